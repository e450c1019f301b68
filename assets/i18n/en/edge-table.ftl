# Edge table. What stands between two ** is bold; $rule is the winding rule's name on the command line.

edge-table = Edge table
edge-table-about = Keep a list of the edges that cross the row, and fill where the winding number says inside: for any polygon.
edge-table-opening = Every edge is first put into a table, by the first row that it crosses. Then each row needs only the edges that cross it.
edge-table-horizontal = **{ $edge }** is horizontal, so it crosses no row. The edges at its ends decide.
edge-table-left-out = **{ $edge }** ends before it comes to a row of pixel centres: it is left out.
edge-table-edge = **{ $edge }** crosses { $count ->
    [one] row { $first } only
   *[other] rows { $first } to { $last }
}: it goes into the table under **row { $first }**.
edge-table-slope = Along **{ $edge }**, x changes by **{ $slope }** when y grows by 1.
edge-table-built = The table is complete: { $count ->
    [one] 1 edge
   *[other] { $count } edges
}, sorted by the first row.
edge-table-built-empty = No edge crosses a row of pixel centres: **nothing is drawn**.
edge-table-row = Row { $y }: its pixel centres lie on y = { $centre }.
edge-table-row-along = Row { $y }: its pixel centres lie exactly on **{ $edge }**. They belong to what is **below** it.
edge-table-take = **{ $edge }** begins with row { $y }: it joins the active edges.
edge-table-crossing = The centre line of row { $y } meets **{ $edge }** at **x = { $x }**.
edge-table-first = **Pixel { $x }** is the first whose centre, { $centre }, is at or right of { $at }.
edge-table-first-none = No centre of the row is at or right of **{ $edge }**.
edge-table-corrected = Rounding suggested another pixel. The exact sign of the edge says **pixel { $x }**.
edge-table-tie = Centre { $centre } lies exactly on **{ $edge }**: it belongs to the side to its **right**.
edge-table-sorted = Sorted by x, the active edges are now { $edges }.
edge-table-across-inside = Right of **{ $edge }** the winding number is **{ $winding }**: { $rule ->
    [even-odd] odd, so
   *[other] not 0, so
} **inside**.
edge-table-across-outside = Right of **{ $edge }** the winding number is **{ $winding }**: { $rule ->
    [even-odd] even, so
   *[other] so
} **outside**.
edge-table-span = Row { $y }: **{ $begin } ≤ x < { $end }** lies inside: { $count ->
    [one] 1 pixel is
   *[other] { $count } pixels are
} drawn.
edge-table-span-empty = Row { $y }: no pixel centre lies between the two edges, so **nothing** is drawn there.
edge-table-row-done = Row { $y } is done: { $count ->
    [0] no pixel is drawn
    [one] 1 pixel is drawn
   *[other] { $count } pixels are drawn
}{ $spans ->
    [0] { "" }
    [one] , in 1 span
   *[other] , in { $spans } spans
}.
edge-table-drop = **{ $edge }** ends above the next row of centres: it leaves the active edges.
edge-table-done = All rows are done: { $count ->
    [0] no pixel is
    [one] 1 pixel is
   *[other] { $count } pixels are
} drawn.
edge-table-active = Active edges
edge-table-spans = Spans
edge-table-table = Edge table
edge-table-marker-rows = rows
edge-table-marker-empty = no rows
