# DDA. What stands between two ** is bold.

dda = DDA
dda-about = Add a constant step to x and y, round to the nearest pixel, draw.
dda-opening = The ends are moved to the centres of their pixels. From there on, whole numbers are pixel centres.
dda-start = From P1 to P2, x changes by **{ $dx }** pixels and y by **{ $dy }**.
dda-steps = { $count ->
    [0] Both ends are in the same pixel: **no step** is needed.
    [one] The longer way is along { $axis }: **1 step**.
   *[other] The longer way is along { $axis }: **{ $count } steps**.
}
dda-increment = Each step adds **{ $by }** to { $axis }.
dda-advance = The next step leads to **{ $axis } = { $to }**.
dda-plot = { $axis } = { $at } is rounded: pixel **({ $x }, { $y })** is drawn.
dda-plot-tie = { $axis } = { $at } lies exactly between two pixels. A half is rounded up: pixel **({ $x }, { $y })** is drawn.
dda-done = The line is done: { $count ->
    [one] 1 pixel.
   *[other] { $count } pixels.
}
dda-steps-made = Steps
dda-increments = Increments
