# Diamond exit. What stands between two ** is bold.

diamond-exit = Diamond exit
diamond-exit-about = The ends are not rounded: a pixel is drawn if the line leaves the diamond around its centre.
diamond-exit-opening = In each pixel stands a diamond. The line draws the pixels whose diamonds it leaves on its way from P1 to P2.
diamond-exit-along-x = The line is longer along **x** than along y, or as long: the walk goes from column to column.
diamond-exit-along-y = The line is longer along **y** than along x: the walk goes from row to row.
diamond-exit-column = Column { $at }: its centre line is x = { $centre }.
diamond-exit-row = Row { $at }: its centre line is y = { $centre }.
diamond-exit-crossing = The line crosses it at **{ $axis } = { $at }**.
diamond-exit-starts-in-diamond = The line starts beyond the centre line, but still **in a diamond**.
diamond-exit-starts-beyond = The line starts beyond the centre line and in no diamond: **nothing** is drawn here.
diamond-exit-ends-before = The line ends before the centre line, so it leaves no diamond here: **nothing** is drawn.
diamond-exit-candidate = That is in the diamond of pixel **({ $x }, { $y })**.
diamond-exit-corrected = Rounding suggested another pixel. The exact sign says pixel **({ $x }, { $y })**.
diamond-exit-off-image = That is off the image: nothing is drawn.
diamond-exit-ends-inside = P2 lies in this diamond, so the line does not leave it: pixel ({ $x }, { $y }) is **not drawn**.
diamond-exit-leaves = P2 lies outside, so the line leaves the diamond: pixel **({ $x }, { $y })** is drawn.
diamond-exit-done = The line is done: { $count ->
    [0] no pixel is
    [one] 1 pixel is
   *[other] { $count } pixels are
} drawn.
diamond-exit-verdict-starts-beyond = no diamond
diamond-exit-verdict-ends-before = ends before
diamond-exit-verdict-off-image = off the image
diamond-exit-verdict-ends-inside = ends inside
diamond-exit-verdict-leaves = drawn
diamond-exit-columns = Columns
diamond-exit-rows = Rows
column-verdict = verdict
