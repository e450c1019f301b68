# The step of depth. What stands between two ** is bold.

depth-precision = Precision
depth-precision-about = Every code of the depth buffer stands for a stretch of the line of sight. Where it is longer than the gap between two planes, both can have one code.
depth-precision-opening = From { $near } to { $far } in { $format }: where can two planes { $gap } apart have the same code?
depth-precision-range = Code { $code } begins at { $distance } and is { $step } long, more than { $gap }. **Planes can merge before it**: this range is searched.
depth-precision-range-fine = Code { $code } begins at { $distance } and is { $step } long, not more than { $gap }. All steps before it in this range are shorter.
depth-precision-nearer = Code { $code } at { $distance } is { $step } long, **more than { $gap }**. The first such code is this one or nearer.
depth-precision-farther = Code { $code } at { $distance } is { $step } long, not more than { $gap }. The first longer one is **farther**.
depth-precision-found = **From { $distance } on** two planes { $gap } apart can have the same code, { $code } first: it is { $step } long.
depth-precision-never = **Never**: no code is longer than { $gap }, so the two planes always differ.
depth-precision-axis-step = length of a code, logarithmic ↑
depth-precision-axis-distance = distance, logarithmic →
depth-precision-codes = Codes
depth-precision-steps = Step by distance
depth-precision-marker-found = merge
depth-precision-marker-never = never
depth-precision-unit = found
depth-precision-planes = planes
row-first = first
row-looked-at = looked at
row-last = last
column-distance = begins at
column-step = step
