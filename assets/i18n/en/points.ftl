# Points. What stands between two ** is bold.

points = Points
points-about = A point is a square around its place: it draws the pixels whose centres lie in it.
points-opening = The square around P has sides of { $size }. Which pixel centres lie in it?
points-side = The { $side } side lies at **{ $at }**.
points-first-column = **Column { $index }** is the first whose centres, at x = { $centre }, are at the { $side } side or beyond.
points-first-row = **Row { $index }** is the first whose centres, at y = { $centre }, are at the { $side } side or beyond.
points-first-none = No centre of the image lies at the { $side } side or beyond.
points-corrected = Rounding suggested another place. The exact sign of the { $side } side says **{ $index }**.
points-tie-in = Centres with { $axis } = { $centre } lie exactly on the { $side } side: they are **in**.
points-tie-out = Centres with { $axis } = { $centre } lie exactly on the { $side } side: they are **out**.
points-row = Row { $y }: **{ $begin } ≤ x < { $end }**, { $count ->
    [one] 1 pixel is
   *[other] { $count } pixels are
} drawn.
points-done = The point is done: { $count ->
    [0] no pixel is
    [one] 1 pixel is
   *[other] { $count } pixels are
} drawn.
points-left = left
points-right = right
points-upper = upper
points-lower = lower
row-points-left = left
row-points-right = right
row-points-upper = upper
row-points-lower = lower
points-sides = Sides
points-rows = Rows
