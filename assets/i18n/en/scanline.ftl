# Slope scan line. What stands between two ** is bold; $rule is the fill rule's name on the command line.

scanline = Slope scan line
scanline-about = Walk down two edges at once and fill the pixels whose centres lie between them.
scanline-opening = Each row is filled between the two edges that its centre line meets.
scanline-sorted = Sorted from top to bottom: **{ $top }**, **{ $middle }**, **{ $bottom }**. The walk goes down in this order.
scanline-zero-area = The vertices lie on one line: **zero area**, so nothing is drawn.
scanline-slope = Along **{ $edge }**, x changes by **{ $slope }** when y grows by 1.
scanline-half = { $count ->
    [one] Row { $first } lies
   *[other] Rows { $first } to { $last } lie
} between **{ $long }** and **{ $short }**.
scanline-half-left-out = { $count ->
    [one] Row { $first } lies
   *[other] Rows { $first } to { $last } lie
} between **{ $long }** and **{ $short }**. Row { $y } runs exactly along { $flat }: { $rule ->
    [strict] with this rule no edge draws its ties.
   *[other] a bottom edge does not draw its ties.
}
scanline-half-empty = No row has its centre line between { $from } and { $to }.
scanline-row = Row { $y }: its pixel centres lie on y = { $centre }.
scanline-row-top-edge = Row { $y }: its pixel centres lie exactly on **{ $edge }**. It is a top edge, so it draws them.
scanline-row-bottom-edge = Row { $y }: its pixel centres lie exactly on **{ $edge }**. With this rule a bottom edge draws them.
scanline-crossing-left = The centre line meets the left edge, **{ $edge }**, at **x = { $x }**.
scanline-crossing-right = The centre line meets the right edge, **{ $edge }**, at **x = { $x }**.
scanline-first = The span begins at **pixel { $x }**: its centre, { $centre }, is the first { $closed ->
    [true] at or right of
   *[other] right of
} { $at }.
scanline-first-none = The span is empty: no centre of the row lies { $closed ->
    [true] at or right of
   *[other] right of
} { $at }.
scanline-end = The span ends before **pixel { $x }**: its centre, { $centre }, is the first { $closed ->
    [true] at or right of
   *[other] right of
} { $at }.
scanline-end-border = The span ends at the border of the image: { $at } lies beyond its last centre.
scanline-corrected = Rounding suggested another pixel. The exact sign of the edge says **pixel { $x }**.
scanline-tie-drawn = tie: drawn
scanline-tie-lost = tie: not drawn
scanline-tie-left-drawn = Centre { $centre } lies exactly on **{ $edge }**. { $rule ->
    [inclusive] With this rule every edge draws its ties: **drawn**.
   *[other] The inside is to its right, so it is a left edge: **drawn**. The neighbour on this edge does not draw it.
}
scanline-tie-left-lost = Centre { $centre } lies exactly on **{ $edge }**. With this rule no edge draws its ties: **not drawn**.
scanline-tie-right-drawn = Centre { $centre } lies exactly on **{ $edge }**. With this rule every edge draws its ties: **drawn**.
scanline-tie-right-lost = Centre { $centre } lies exactly on **{ $edge }**. { $rule ->
    [strict] With this rule no edge draws its ties: **not drawn**.
   *[other] The inside is to its left, so it is a right edge: **not drawn**. The neighbour on this edge draws it.
}
scanline-span = Row { $y }: the span is **{ $first } ≤ x < { $end }**, { $count ->
    [one] 1 pixel
   *[other] { $count } pixels
}.
scanline-span-empty = Row { $y }: no pixel centre lies between the edges, so the span is **empty**.
scanline-pixel = Pixel ({ $x }, { $y }) lies in the span: **drawn**.
scanline-done = All rows are done: { $count ->
    [0] no pixel is
    [one] 1 pixel is
   *[other] { $count } pixels are
} drawn.
scanline-spans = Spans
scanline-slopes = Slopes
scanline-marker-zero-area = zero area
scanline-marker-upper = upper half
scanline-marker-lower = lower half
column-pixels = px
