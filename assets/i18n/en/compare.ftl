# Two runs side by side: what can differ, and its values

compare-algorithm = Algorithm
compare-arithmetic = Arithmetic
compare-fill-rule = Tie rule
compare-y-axis = y axis
compare-depth-format = Depth format
compare-depth-compare = Depth test
compare-depth-range = Depth range
compare-reversed = Depth
compare-not-reversed = near 0, far 1
compare-is-reversed = reversed
compare-cull = Cull
compare-front = Front

column-answer = answer
