# Sutherland-Hodgman polygon clipping. What stands between two ** is bold.

sutherland-hodgman = Sutherland–Hodgman
sutherland-hodgman-about = Cut the whole polygon at one side, then give what is left to the next.
sutherland-hodgman-opening = { $polygons ->
    [one] The whole polygon is cut at one side of the window. What is left goes to the next side.
   *[other] Each polygon is cut at one side of the window after the other, as if the others were not there.
}
sutherland-hodgman-begin = Polygon { $number } starts with { $corners ->
    [one] its only corner as it was given
   *[other] its { $corners } corners as they were given
}.
sutherland-hodgman-side = Now the **{ $side }** side cuts. Inside is { $inside }.
sutherland-hodgman-first-in = The first corner **{ $first }** is inside: it is emitted.
sutherland-hodgman-first-on = The first corner **{ $first }** lies on the side. That counts as inside: it is emitted.
sutherland-hodgman-first-out = The first corner **{ $first }** is outside: it is not emitted.
sutherland-hodgman-in-in = **{ $start } → { $end }** stays **inside**: emit { $end }.
sutherland-hodgman-in-in-closing = **{ $start } → { $end }** stays **inside** and closes the polygon: { $end } has been emitted already.
sutherland-hodgman-in-out = **{ $start } → { $end }** goes **out**: emit only the cut.
sutherland-hodgman-out-in = **{ $start } → { $end }** comes **in**: emit the cut, then { $end }.
sutherland-hodgman-out-in-closing = **{ $start } → { $end }** comes **in** and closes the polygon: emit the cut. { $end } has been emitted already.
sutherland-hodgman-out-out = **{ $start } → { $end }** stays **outside**: emit nothing.
sutherland-hodgman-touch = **{ $corner }** lies on the side: it is the cut itself, and is not emitted twice.
sutherland-hodgman-cut = The edge meets { $axis } = { $at } at { $to }: emit **{ $name }**.
sutherland-hodgman-cut-corner = This edge runs along a border that has cut before, so it meets { $axis } = { $at } in a corner of the window: emit **{ $name }**.
sutherland-hodgman-keep = **{ $end }** is inside: it is emitted.
sutherland-hodgman-side-done = The **{ $side }** side leaves { $corners ->
    [0] nothing
    [one] one corner
   *[other] { $corners } corners
}.
sutherland-hodgman-drop-repeats = A corner at the same place as the one before it is dropped.
sutherland-hodgman-drop-straight = A corner at which the outline goes straight on is dropped.
sutherland-hodgman-drop-no-area = What is left has no area: this corner is dropped.
sutherland-hodgman-done = What is left has **{ $corners } corners**. { $bridges ->
    [0] { "" }
    [one] On one stretch it runs along the border there and back: a **bridge** joins pieces that fell apart.
   *[other] On { $bridges } stretches it runs along a border there and back: **bridges** join pieces that fell apart.
}
sutherland-hodgman-done-two-sides = What is left has { $corners } corners. **Mistake:** right and top did not cut.
sutherland-hodgman-done-cracks = What is left has { $corners } corners. **A crack:** { $cracks ->
    [one] one cut of a shared edge differs
   *[other] { $cracks } cuts of shared edges differ
} from the neighbour's.
sutherland-hodgman-empty = **Nothing** with an area is left.
sutherland-hodgman-cutting = cutting at { $axis } = { $at }
sutherland-hodgman-bridge = bridge
sutherland-hodgman-marker-done = done
sutherland-hodgman-marker-empty = empty
sutherland-hodgman-word-in-in = in → in
sutherland-hodgman-word-in-out = in → out
sutherland-hodgman-word-out-in = out → in
sutherland-hodgman-word-out-out = out → out
sutherland-hodgman-edges = Edges against this side
sutherland-hodgman-out = Emitted so far
sutherland-hodgman-polygon = Polygon
sutherland-hodgman-sides = Corners before and after each side
sutherland-hodgman-cracks = Cracks at shared edges
column-sutherland-hodgman-transition = goes
column-sutherland-hodgman-emits = emits
column-sutherland-hodgman-along = along
column-sutherland-hodgman-before = before
column-sutherland-hodgman-after = after
column-sutherland-hodgman-ours = here
column-sutherland-hodgman-theirs = there

mistake-two-sides = only left and bottom cut
mistake-two-sides-effect = right there, wrong at the right and the top
mistake-either-end = cut from whichever end comes first
mistake-either-end-effect = rounds otherwise than the neighbour: a crack (f32, f64)
