# Bresenham's line. What stands between two ** is bold.

bresenham = Bresenham
bresenham-about = One whole number tells after each step whether to go straight on or aside: no division, no rounding.
bresenham-opening = The ends are moved to the centres of their pixels. Then everything is a whole number.
bresenham-start = From P1 to P2 it is **{ $dx }** pixels along x and **{ $dy }** along y: the longer way, { $axis }, is the major axis.
bresenham-decision = The decision variable starts with **d = { $d }**. It is above 0 if the line passes beyond the point midway between the two next pixels.
bresenham-aside = d = { $d } is above 0: the pixel { $aside } is nearer. One step { $straight } **and** { $aside }.
bresenham-straight = d = { $d } is below 0: the pixel straight on is nearer. One step **{ $straight }**.
bresenham-tie-aside = d = 0: both pixels are equally near. The right or lower one is taken: one step { $straight } **and** { $aside }.
bresenham-tie-straight = d = 0: both pixels are equally near. The right or lower one is taken: one step **{ $straight }**.
bresenham-plot = Pixel **({ $x }, { $y })** is drawn.
bresenham-done = The line is done: { $count ->
    [one] 1 pixel.
   *[other] { $count } pixels.
}
bresenham-right = to the right
bresenham-left = to the left
bresenham-down = down
bresenham-up = up
bresenham-way-aside = aside
bresenham-way-straight = straight on
bresenham-steps = Steps
bresenham-values = Values
column-way = step
