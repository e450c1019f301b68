# Cases driven to where arithmetic breaks

stress = Stress
stress-about = Turn the dial from ordinary cases to extreme ones, and see where each arithmetic breaks.

stress-what = Under stress
stress-operation = Operation
stress-family = Family
stress-dial = Dial
stress-dial-about = 0: ordinary cases; 10: as extreme as the family gets.
stress-first-broken = The first broken case
stress-shrink = Make it small
stress-open = Open it in its lab
stress-nothing-to-open = No case breaks here: turn the dial further, or choose another arithmetic.
stress-unit-broken = broken
stress-unit-cases = cases

stress-of-lines = clip lines
stress-of-polygons = clip polygons
stress-of-triangles = clip triangles
stress-of-coverage = fill triangles
stress-of-depth = depth by planes
stress-of-attributes = attributes

stress-ordinary = ordinary
stress-past-a-corner = past a corner
stress-beside = beside a border
stress-nearly-parallel = nearly parallel
stress-huge = huge
stress-denormal = denormal
stress-sliver = sliver
stress-near-w-zero = w near 0
stress-long = long sums

stress-marker-failing = breaks
stress-marker-sound = sound
stress-marker-simplest = small

stress-totals = Where each arithmetic breaks
column-stress-broken = cases
column-stress-wrong = wrong parts
column-stress-worst = worst, ULP
stress-numbers = The case in hand
column-stress-before = before
column-stress-now = now

stress-opening = { $cases } cases to { $operation }, { $family }, dial { $dial }: each arithmetic is held against the exact one.
stress-case = Case { $number }, { $family }: what it takes to { $operation }.
stress-exact = Exactly, the answer has { $parts } { $parts ->
    [one] part
   *[other] parts
}.
stress-agrees = { $arithmetic } decides the same; its worst number is { $ulps } ULP off.
stress-breaks = { $arithmetic } breaks: { $wrong } { $wrong ->
    [one] part is
   *[other] parts are
} decided otherwise, and the worst number is { $ulps } ULP off.
stress-failing = Case { $number } is the first in which { $arithmetic } breaks.
stress-no-case = No case breaks { $arithmetic } at this dial.
stress-simpler = { $name } may be { $to }: { $arithmetic } breaks all the same.
stress-simplest = No number can be simpler. { $changed } of { $all } are simpler than before, and { $arithmetic } still breaks.
