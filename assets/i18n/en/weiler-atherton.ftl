# Weiler-Atherton polygon clipping. What stands between two ** is bold.

weiler-atherton = Weiler–Atherton
weiler-atherton-about = Walk along the polygon and along the window by turns, one ring for each piece.
weiler-atherton-opening = First every crossing of the polygon with the window is noted. Then rings are walked from crossing to crossing.
weiler-atherton-edge = **{ $start } → { $end }**: does it cross the window's border?
weiler-atherton-cross-enters = It crosses the **{ $side }** border at { $at }: there it **enters**. This is { $crossing }.
weiler-atherton-cross-leaves = It crosses the **{ $side }** border at { $at }: there it **leaves**. This is { $crossing }.
weiler-atherton-origin-inside = The polygon winds around the corner **C0** { $winding } { $winding ->
    [one] time
   *[other] times
}, an odd number: C0 is **inside**.
weiler-atherton-origin-outside = The polygon winds around the corner **C0** { $winding } { $winding ->
    [one] time
   *[other] times
}, an even number: C0 is **outside**.
weiler-atherton-next-inside = Round the window, **{ $crossing }** at { $at } comes next. Behind it the border is **inside** the polygon.
weiler-atherton-next-outside = Round the window, **{ $crossing }** at { $at } comes next. Behind it the border is **outside** the polygon.
weiler-atherton-start = **{ $crossing }** enters and is unused: a ring starts there, at { $at }.
weiler-atherton-follow = Along the polygon: **{ $corner }** is inside the window and belongs to the ring.
weiler-atherton-reach = Along the polygon to the crossing **{ $crossing }**. At { $at } the polygon and the ring part.
weiler-atherton-turn = Along the border inside the polygon: over the window's corner **{ $corner }**.
weiler-atherton-arrive = Along the border inside the polygon to the crossing **{ $crossing }**, at { $at }.
weiler-atherton-close = Along the border inside the polygon, and the ring is back at its start: **{ $corners } corners**.
weiler-atherton-whole = This contour crosses nothing and is inside the window: it is a ring as it is.
weiler-atherton-whole-hole = This contour crosses nothing, is inside the window and inside the polygon: it is the ring of a **hole**.
weiler-atherton-window = Nothing crosses the border, and it is inside the polygon: the **window** itself is a ring.
weiler-atherton-drop-repeats = A corner at the same place as the one before it is dropped.
weiler-atherton-drop-straight = A corner at which the ring goes straight on is dropped.
weiler-atherton-drop-no-area = The ring has no area: this corner is dropped.
weiler-atherton-ring-done = { $corners ->
    [0] The ring is empty and is left out. Is another crossing unused?
   *[other] The ring has { $corners } corners. Is another crossing unused?
}
weiler-atherton-hole = The hole goes to the innermost ring around it.
weiler-atherton-done = { $pieces ->
    [0] **Nothing** with an area is left.
    [one] **One piece** is left.
   *[other] **{ $pieces } pieces** are left, each with an outline of its own.
} { $holes ->
    [0] { "" }
    [one] There is one hole.
   *[other] There are { $holes } holes.
}
weiler-atherton-enters = enters
weiler-atherton-leaves = leaves
weiler-atherton-inside = inside
weiler-atherton-outside = outside
weiler-atherton-marker-round = round
weiler-atherton-marker-ring = ring
weiler-atherton-marker-done = done
weiler-atherton-marker-empty = empty
weiler-atherton-polygon-list = Crossings along the polygon
weiler-atherton-window-list = Crossings round the window
weiler-atherton-ring = Ring
weiler-atherton-pieces = Pieces
column-weiler-atherton-course = there
column-weiler-atherton-on = on
column-weiler-atherton-behind = behind it
column-weiler-atherton-corners = corners
column-weiler-atherton-holes = holes
