# Cases driven to where arithmetic breaks

stress = Stress
stress-about = Turn the dial from ordinary cases to extreme ones, and see where each arithmetic breaks.

stress-operation = Operation
stress-family = Family
stress-dial = Dial
stress-dial-number = Dial as a number
stress-dial-about = 0: ordinary cases; 10: as extreme as the family gets.
stress-shrink = Shrink the first broken case
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

stress-case-table = This case
stress-parts = What is not exact
stress-totals = All cases so far
stress-numbers = Numbers of this case
stress-there = drawn
stress-missing = not drawn
row-stress-answer = answer
row-stress-corner = corner
column-stress-broken = cases
column-stress-wrong = parts
column-stress-ulps = ULP
column-stress-bits = bits right
column-stress-here = here
column-stress-before = before
column-stress-now = now

stress-key-extra = drawn wrongly
stress-key-lost = lost
stress-key-far = far off
stress-key-curve = how far off, bit by bit
stress-key-taught = as computed
stress-key-exact = exactly

stress-opening = { $cases } cases to { $operation }, { $family }, dial { $dial }. Each arithmetic is held against the exact one.
stress-case = Case { $number }: { $operation }, { $family }.
stress-exact = The exact answer has { $parts } { $parts ->
    [one] part
   *[other] parts
}.
stress-same = { $arithmetic } answers the same.
stress-close = { $arithmetic } decides the same. Its worst number is { $ulps } ULP off.
stress-far = { $arithmetic } breaks: its worst number is { $ulps } ULP off, { $bits } of 24 bits are right.
stress-otherwise = { $arithmetic } breaks: it decides { $wrong } { $wrong ->
    [one] part
   *[other] parts
} otherwise.
stress-otherwise-and-off = { $arithmetic } breaks: it decides { $wrong } { $wrong ->
    [one] part
   *[other] parts
} otherwise, and its worst number is { $ulps } ULP off.
stress-done-same = Case { $number }: { $arithmetic } answers as the exact one does.
stress-done-close = Case { $number }: { $arithmetic } holds. Its worst number is { $ulps } ULP off.
stress-done-far = Case { $number }: { $arithmetic } breaks. Its worst number is { $ulps } ULP off, { $bits } of 24 bits are right.
stress-done-otherwise = Case { $number }: { $arithmetic } breaks. It decides { $wrong } { $wrong ->
    [one] part
   *[other] parts
} otherwise.
stress-done-otherwise-and-off = Case { $number }: { $arithmetic } breaks. It decides { $wrong } { $wrong ->
    [one] part
   *[other] parts
} otherwise, and its worst number is { $ulps } ULP off.
stress-failing = Case { $number } is the first in which { $arithmetic } breaks.
stress-no-case = No case breaks { $arithmetic } at this dial.
stress-simpler = { $name } may be { $to }: { $arithmetic } breaks all the same.
stress-simplest = No number can be simpler. { $changed } of { $all } are simpler than before, and { $arithmetic } still breaks.
