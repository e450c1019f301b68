# Cohen-Sutherland line clipping. What stands between two ** is bold.

cohen-sutherland = Cohen–Sutherland
cohen-sutherland-about = Give each end a 4-bit code, then cut at one border at a time.
cohen-sutherland-opening = Each end gets a code: one bit for each border it lies beyond.
cohen-sutherland-code = **{ $end }** lies beyond { $borders ->
    [one] the **{ $first }** border
   *[other] the **{ $first }** and the **{ $second }** border
}: its code is { $code }.
cohen-sutherland-code-inside = **{ $end }** lies beyond no border: its code is 0000, inside.
cohen-sutherland-or = OR gives { $code }, not 0: at least one end is outside.
cohen-sutherland-or-zero = OR gives 0000: both ends are inside.
cohen-sutherland-accept = Both ends are inside, so everything between them is **visible**.
cohen-sutherland-and = AND gives { $code }, not 0: both ends lie beyond the **{ $border }** border.
cohen-sutherland-and-zero = AND gives 0000: no border has both ends beyond it, so the line may cross the window.
cohen-sutherland-and-mistaken = **Mistake:** the codes are joined by OR, not AND. It gives { $code }, not 0, whenever an end is outside.
cohen-sutherland-reject = Both ends lie beyond the **{ $border }** border, and so does everything between them: **nothing is visible**.
cohen-sutherland-reject-mistaken = **Rejected by mistake:** no border has both ends beyond it.
cohen-sutherland-give-up = Rounding put an end back outside. After { $cuts } cuts the algorithm gives up.
cohen-sutherland-choose = The first bit that differs is **{ $border }**: 1 at { $end }, 0 at { $other }. So { $end } moves to the border { $axis } = { $at }.
cohen-sutherland-cut = **{ $end }** moves along the line to { $axis } = { $border }. At { $to } its code is { $code }.
cohen-sutherland-cutting = cutting at { $axis } = { $border }
cohen-sutherland-ends = Ends
cohen-sutherland-window = Window
cohen-sutherland-marker-top = cut top
cohen-sutherland-marker-bottom = cut bottom
cohen-sutherland-marker-right = cut right
cohen-sutherland-marker-left = cut left
