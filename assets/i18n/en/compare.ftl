# Two runs side by side: what can differ, and its values

compare-algorithm = Algorithm
compare-arithmetic = Arithmetic
compare-fill-rule = Tie rule
compare-winding = Winding rule
compare-y-axis = y axis
compare-depth-format = Depth format
compare-depth-compare = Depth test
compare-depth-write = Depth write
compare-bias = Depth bias
compare-early-z = Depth test
compare-depth-range = Depth range
compare-reversed = Depth
compare-mistake = Mistake
compare-space = Clipped in
compare-planes = Planes
compare-pieces = Result
compare-order = Order of sides
compare-outline = Outlines by
compare-outlines = Outlines
compare-blend-order = Order
compare-blend-mode = Blending
compare-edge-on = Edge-on
compare-mode = Mode
compare-samples = Samples
compare-shading = Shading
compare-not-reversed = near 0, far 1
compare-is-reversed = reversed
compare-cull = Cull
compare-front = Front

compare-named = entries
compare-corners = corners
compare-pixels = pixels

compare-counts = { $comparisons } cmp  { $multiplications } mul  { $divisions } div
compare-model = Highlight
compare-sides-lit = Sides lit

column-answer = answer
