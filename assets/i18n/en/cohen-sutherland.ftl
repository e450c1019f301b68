# Cohen-Sutherland line clipping

cohen-sutherland = Cohen–Sutherland
cohen-sutherland-about = Give each end a 4-bit code, then cut at one border at a time.
cohen-sutherland-opening = Each end gets a code: one bit for each border it lies beyond.
cohen-sutherland-code = { $end } lies beyond a border: its code is { $code }.
cohen-sutherland-code-inside = { $end } lies inside the window: its code is 0000.
cohen-sutherland-or = OR gives { $code }, not 0: at least one end is outside.
cohen-sutherland-or-zero = OR gives 0000: both ends are inside.
cohen-sutherland-accept = What is left of the segment is visible.
cohen-sutherland-and = AND gives { $code }: both ends lie beyond the same border.
cohen-sutherland-and-zero = AND gives 0000: no border has both ends beyond it, so the segment may cross the window.
cohen-sutherland-reject = The whole segment lies beyond the { $border } border: nothing is visible.
cohen-sutherland-give-up = Rounding put an end back outside: after { $cuts } cuts the algorithm gives up.
cohen-sutherland-choose = The first bit that differs is { $border }: it is 1 at { $end }, so { $end } moves.
cohen-sutherland-cut = { $end } moves to { $axis } = { $border }, to { $to }. Its new code is { $code }.
cohen-sutherland-ends = Ends
cohen-sutherland-window = Window
cohen-sutherland-marker-top = cut top
cohen-sutherland-marker-bottom = cut bottom
cohen-sutherland-marker-right = cut right
cohen-sutherland-marker-left = cut left
