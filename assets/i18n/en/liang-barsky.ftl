# Liang-Barsky line clipping. What stands between two ** is bold.

liang-barsky = Liang–Barsky
liang-barsky-about = Put the four crossings with the borders in order along the line; divide only to cut.
liang-barsky-opening = Along the line t runs from 0 at P1 to 1 at P2. Each border has its own t; their order decides.
liang-barsky-start = Nothing is cut yet: the visible part runs from t0 = 0 to t1 = 1.
liang-barsky-measure-enters = At the **{ $border }** border p is negative: there the line **enters**, at { $name } = q / p.
liang-barsky-measure-leaves = At the **{ $border }** border p is positive: there the line **leaves**, at { $name } = q / p.
liang-barsky-measure-parallel = At the **{ $border }** border p is 0: the line is **parallel** to it and never crosses it.
liang-barsky-along-outside = q is negative: the whole line lies beyond the **{ $border }** border.
liang-barsky-along-inside = q is not negative: the whole line is on the inner side of the **{ $border }** border.
liang-barsky-enter-later = The line enters at { $at } after t0. So t0 becomes { $name }, not divided yet.
liang-barsky-enter-earlier = The line enters at { $at } no later than t0. So t0 stays.
liang-barsky-leave-earlier = The line leaves at { $at } before t1. So t1 becomes { $name }, not divided yet.
liang-barsky-leave-later = The line leaves at { $at } no earlier than t1. So t1 stays.
liang-barsky-order-right = t0 is not after t1: so far a part is visible. Two products told it, no division.
liang-barsky-order-crossed = t0 is after t1: the line leaves before it has entered everywhere.
liang-barsky-reject = **Nothing is visible**, and nothing was divided.
liang-barsky-divide = Now the division pays: { $bound } = { $name } = { $t }.
liang-barsky-cut = **{ $end }** moves along the line to the **{ $border }** border, at { $to }.
liang-barsky-accept = What is left is **visible**. { $divisions ->
    [0] Both ends stayed, so nothing was divided.
    [one] One end was cut, by one division.
   *[other] Both ends were cut, each by one division.
}
liang-barsky-note = { $name } { $course }
liang-barsky-borders = Borders
liang-barsky-order = In order along the line
liang-barsky-part = Visible part
liang-barsky-marker-enter = enter
liang-barsky-marker-leave = leave
liang-barsky-marker-parallel = parallel
liang-barsky-marker-divide = divide
column-liang-barsky-course = there
column-liang-barsky-from = from
column-liang-barsky-value = value
row-liang-barsky-divisions = divisions
