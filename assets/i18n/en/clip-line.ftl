# What the labs that clip a line share. What stands between two ** is bold.

clip-line-legend = T B R L  top, bottom, right, left
clip-line-enters = enters
clip-line-leaves = leaves
clip-line-parallel = parallel
clip-line-comparison = Beside the right answer
column-clip-line-here = here
column-clip-line-right = right

mistake-or-for-and = OR instead of AND
mistake-or-for-and-effect = rejects lines that cross the window
mistake-other-order = cut from the other end
mistake-other-order-effect = rounds otherwise than the neighbour: a crack (f32, f64)
column-clip-line-count = so far
row-clip-line-comparisons = comparisons
row-clip-line-multiplications = multiplications
row-clip-line-divisions = divisions
