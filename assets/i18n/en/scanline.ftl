# Slope scan line

scanline = Slope scan line
scanline-about = Walk down two edges at once and fill the pixels whose centres lie between them.
scanline-opening = Each row is filled between the two edges that its centre line meets.
scanline-sorted = From top to bottom: { $top }, { $middle }, { $bottom }.
scanline-zero-area = Zero area: nothing is drawn.
scanline-slope = Along { $edge }, x changes by { $slope } for each unit of y.
scanline-half = From { $from } to { $to }: { $count ->
    [one] one row, row { $first }
   *[other] rows { $first } to { $last }
}.
scanline-half-empty = From { $from } to { $to }: no row has its centre line here.
scanline-row = Row { $y }: its pixel centres lie on y = { $centre }.
scanline-crossing-left = The row meets { $edge }, its left edge, at x = { $x }.
scanline-crossing-right = The row meets { $edge }, its right edge, at x = { $x }.
scanline-first = The span begins at pixel { $x }.
scanline-end = The span ends before pixel { $x }.
scanline-corrected = Rounding chose another pixel; the exact sign of the edge says { $x }.
scanline-tie-left-drawn = Pixel ({ $x }, { $y }) is a tie: its centre lies exactly on { $edge }, a left edge. The span takes it in.
scanline-tie-left-lost = Pixel ({ $x }, { $y }) is a tie: its centre lies exactly on { $edge }, a left edge. The span leaves it out.
scanline-tie-right-drawn = Pixel ({ $x }, { $y }) is a tie: its centre lies exactly on { $edge }, a right edge. The span takes it in.
scanline-tie-right-lost = Pixel ({ $x }, { $y }) is a tie: its centre lies exactly on { $edge }, a right edge. The span leaves it out.
scanline-span = Row { $y }: the span is { $first } ≤ x < { $end }, { $count ->
    [one] one pixel
   *[other] { $count } pixels
}.
scanline-span-empty = Row { $y }: no pixel centre lies between the edges.
scanline-pixel = Pixel ({ $x }, { $y }) is drawn.
scanline-done = All rows are done: { $count ->
    [0] no pixel is drawn
    [one] one pixel is drawn
   *[other] { $count } pixels are drawn
}.
scanline-spans = Spans
scanline-slopes = Slopes
scanline-marker-zero-area = zero area
scanline-marker-upper = upper half
scanline-marker-lower = lower half
column-pixels = px
