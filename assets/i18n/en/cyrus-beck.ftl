# Cyrus-Beck line clipping. What stands between two ** is bold.

cyrus-beck = Cyrus–Beck
cyrus-beck-about = Any convex window: take each edge's inward normal n and ask where the line comes in or goes out.
cyrus-beck-opening = The line is P1 + t D. At each edge the normal n tells whether the line comes in or goes out there, and at which t.
cyrus-beck-start = Nothing is cut yet: the visible part runs from tE = 0 to tL = 1.
cyrus-beck-measure-enters = At **{ $edge }** D·n is positive: the line goes the way of the inward normal, so it **enters**.
cyrus-beck-measure-leaves = At **{ $edge }** D·n is negative: the line goes against the inward normal, so it **leaves**.
cyrus-beck-measure-parallel = At **{ $edge }** D·n is 0: the line is **parallel** to it and never crosses it.
cyrus-beck-along-outside = w·n is negative: the whole line lies beyond **{ $edge }**.
cyrus-beck-along-inside = w·n is not negative: the whole line is on the inner side of **{ $edge }**.
cyrus-beck-divide = The line meets **{ $edge }** at t = { $t }.
cyrus-beck-enter-later = That is later than tE, so **{ $edge }** now bounds the visible part: tE becomes this t.
cyrus-beck-enter-earlier = That is no later than tE = { $bound }, so { $edge } does not matter.
cyrus-beck-leave-earlier = That is earlier than tL, so **{ $edge }** now bounds the visible part: tL becomes this t.
cyrus-beck-leave-later = That is no earlier than tL = { $bound }, so { $edge } does not matter.
cyrus-beck-order-right = tE = { $enter } is not after tL = { $leave }: the line is inside between them.
cyrus-beck-order-crossed = tE = { $enter } is after tL = { $leave }: the line leaves before it has entered everywhere.
cyrus-beck-reject = **Nothing is visible.** { $divisions ->
    [0] Nothing was divided.
    [one] It took one division to know.
   *[other] It took { $divisions } divisions to know.
}
cyrus-beck-cut = **{ $end }** moves along the line to **{ $edge }**, at { $to }.
cyrus-beck-accept = What is left is **visible**. { $divisions ->
    [0] Nothing was divided.
    [one] It took one division.
   *[other] It took { $divisions } divisions, one for each edge that is not parallel.
}
cyrus-beck-edges = Edges
cyrus-beck-part = Visible part
cyrus-beck-marker-enter = enter
cyrus-beck-marker-leave = leave
cyrus-beck-marker-parallel = parallel
cyrus-beck-marker-cut = cut
column-cyrus-beck-course = there
column-cyrus-beck-from = from
column-cyrus-beck-value = t
