# Midpoint subdivision of a line. What stands between two ** is bold.

midpoint = Midpoint subdivision
midpoint-about = Halve towards each end of the visible part: sums and shifts, no product, no quotient.
midpoint-opening = Each end gets a code. Then the line is halved until the last visible point is found.
midpoint-code = **{ $end }** lies beyond { $borders ->
    [one] the **{ $first }** border
   *[other] the **{ $first }** and the **{ $second }** border
}: its code is { $code }.
midpoint-code-inside = **{ $end }** lies beyond no border: its code is 0000, inside.
midpoint-or = OR gives { $code }, not 0: at least one end is outside.
midpoint-or-zero = OR gives 0000: both ends are inside.
midpoint-and = AND gives { $code }, not 0: both ends lie beyond the **{ $border }** border.
midpoint-and-zero = AND gives 0000: the line may cross the window.
midpoint-search = **{ $end }** is outside. The last visible point towards it is sought between A = { $other } and E = { $end }.
midpoint-halve = **M** is half-way between A and E, at { $to }. Its code is { $code }.
midpoint-drop = M and E lie beyond the **{ $border }** border, so nothing between them is visible. **E becomes M.**
midpoint-keep = No border has both M and E beyond it, so the last visible point is between them. **A becomes M.**
midpoint-lost = A and E lie beyond the **{ $border }** border: nothing is left.
midpoint-close = A and E are **neighbours**: no number lies between them. A is the last visible point.
midpoint-close-missed = A and E are **neighbours**, and the line has no visible point.
midpoint-move = **{ $end }** moves to A, at { $to }.
midpoint-accept = What is left is **visible**. { $halvings ->
    [0] Nothing had to be halved.
    [one] It took one halving.
   *[other] It took { $halvings } halvings.
}
midpoint-reject = **Nothing is visible.**
midpoint-points = Points
midpoint-marker-search = search
midpoint-marker-move = found
row-midpoint-halvings = halvings
