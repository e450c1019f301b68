# What the labs that clip a line share. What stands between two ** is bold.

clip-line-legend = T B R L  top, bottom, right, left
clip-line-enters = enters
clip-line-leaves = leaves
clip-line-parallel = parallel
clip-line-comparison = Beside the right answer
column-clip-line-here = here
column-clip-line-right = right
