# A row of pixels by the plane equation. What stands between two ** is bold.

plane-equation = Plane equation
plane-equation-about = A value is a plane over the screen: one division for the first pixel, one addition for each other.
plane-equation-opening-affine = Over x and y, the values of a make a plane. The row through P is filled by stepping along it.
plane-equation-opening-perspective = In perspective a is no plane over the screen, but a/w and 1/w are. The row through P steps along both.
plane-equation-row = Row { $y }: { $first } ≤ x < { $end }, { $count ->
    [one] one pixel
   *[other] { $count } pixels
}.
plane-equation-normal = The normal of the plane of { $q }: **{ $name } = { $value }**.
plane-equation-offset = V0 lies on the plane of { $q }, so **D = { $value }**.
plane-equation-slope-x = One pixel to the right, { $q } grows by **{ $value }**.
plane-equation-slope-y = One pixel along y, { $q } grows by **{ $value }**.
plane-equation-start = At the first centre, of pixel { $x }, { $q } is **{ $value }**.
plane-equation-step = One addition: at pixel { $x }, { $q } is **{ $value }**.
plane-equation-value = Pixel { $x } gets **{ $value }**, the exact value rounded once.
plane-equation-quotient = One division: pixel { $x } gets **{ $value }**, the exact value rounded once.
plane-equation-drift = Pixel { $x } gets **{ $value }**; the exact value rounds to { $exact }, **another number**.
plane-equation-zero-area = The triangle has no area: **nothing to fill**.
plane-equation-zero-w = A vertex has w = 0: it is nowhere on the screen, so there is **nothing to fill**.
plane-equation-no-pixel = No centre of the row through P lies inside: **nothing to fill**.
plane-equation-done = The row is done: { $count ->
    [one] its **only value** is the exact one
   *[other] **all { $count } values** are the exact ones
}, rounded once.
plane-equation-done-drift = The row is done: **{ $off } of { $count }** { $count ->
    [one] value has drifted off the exact one
   *[other] values have drifted off the exact ones
}.
plane-equation-marker-plane = plane
plane-equation-marker-start = first centre
plane-equation-marker-none = nothing
plane-equation-planes = Planes
plane-equation-slopes = Slopes and sums
plane-equation-pixels = Pixels
