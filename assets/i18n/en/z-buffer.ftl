# Z-buffer. What stands between two ** is bold.

z-buffer = Z-buffer
z-buffer-about = Each pixel keeps the depth of what it shows; a fragment is drawn only if its own depth passes against that.
z-buffer-opening = Every pixel starts empty, at depth { $clear }.
z-buffer-triangle = Triangle **{ $object }** is drawn next.
z-buffer-early-whole = Nothing discards fragments of **{ $object }**: each is tested and written at once, before it is coloured. That is early z.
z-buffer-early-test = An alpha test may discard fragments of **{ $object }**. Early z still tests depth first, but writes only after the alpha test.
z-buffer-early-never = A discarded fragment of **{ $object }** would leave a trace: all tests wait for its alpha.
z-buffer-early-off = Early z is off: the alpha of every fragment of **{ $object }** is computed before its depth is tested.
z-buffer-scissor = Row { $y }: the scissor leaves { $kept-first } ≤ x < { $kept-end } of **{ $object }**'s { $first } ≤ x < { $end }.
z-buffer-scissor-row = Row { $y }: the scissor leaves nothing of **{ $object }**'s { $first } ≤ x < { $end }.
z-buffer-alpha-kept = Pixel ({ $x }, { $y }): **{ $object } is kept**, for alpha { $alpha } { $sign } { $reference }. Its depth is tested next.
z-buffer-alpha-kept-early = Pixel ({ $x }, { $y }): **{ $object }** passes in depth and **is kept**, for alpha { $alpha } { $sign } { $reference }.
z-buffer-alpha-discarded = Pixel ({ $x }, { $y }): **{ $object } is discarded**, for alpha { $alpha } { $sign } { $reference }. Its depth is not tested.
z-buffer-alpha-discarded-early = Pixel ({ $x }, { $y }): **{ $object }** passes in depth, but **is discarded**: alpha { $alpha } { $sign } { $reference }. Nothing is written.
z-buffer-row = Row { $y }: **{ $object }** covers { $first } ≤ x < { $end }, { $count ->
    [one] 1 fragment
   *[other] { $count } fragments
}.
z-buffer-fragment = Pixel ({ $x }, { $y }): **{ $object }** arrives at depth { $new }. **{ $before }** is there, at { $stored }.
z-buffer-fragment-empty = Pixel ({ $x }, { $y }): **{ $object }** arrives at depth { $new }. The pixel is empty, at { $stored }.
z-buffer-pass = Pixel ({ $x }, { $y }): **{ $object } passes**, for { $new } { $sign } { $stored }.
z-buffer-pass-nearer = Pixel ({ $x }, { $y }): **{ $object } passes**. { $new } < { $stored }, so { $object } is nearer than { $before }.
z-buffer-pass-always = Pixel ({ $x }, { $y }): **{ $object } passes**, as everything does.
z-buffer-pass-untested = Pixel ({ $x }, { $y }): **{ $object } is drawn**; there is no depth test.
z-buffer-pass-unwritten = Pixel ({ $x }, { $y }): **{ $object } passes**, for { $new } { $sign } { $stored }. Its depth is not written.
z-buffer-fail = Pixel ({ $x }, { $y }): **{ $object } fails**. { $new } { $sign } { $stored }, so { $before } stays.
z-buffer-fail-empty = Pixel ({ $x }, { $y }): **{ $object } fails**. { $new } { $sign } { $stored }, so the pixel stays empty.
z-buffer-fail-never = Pixel ({ $x }, { $y }): **{ $object } fails**, as everything does.
z-buffer-done = **{ $object }** is done: { $passed } of { $count ->
    [one] 1 fragment
   *[other] { $count } fragments
} passed.
z-buffer-done-empty = **{ $object }** is done: no pixel centre lies inside it.
z-buffer-test = Test
z-buffer-bits = Code, bit by bit
z-buffer-bias = Depth bias
z-buffer-counts = Fragments
z-buffer-marker-triangle = { $object }
z-buffer-key-passed = { $object } passed
z-buffer-key-failed = { $object } failed
z-buffer-key-equal = equal codes
z-buffer-key-object = { $object }
z-buffer-key-others = the others
column-equal-codes = equal
column-discarded = discarded
column-scissored = scissored
row-bias-constant = constant
row-bias-slope = slope
row-bias-clamp = clamp
row-bias = bias
row-before = before
row-arrives = arrives
row-after = after
column-object = object
column-depth = depth
column-code = code
column-hex = hex
column-bits = bits
column-fragments = fragments
column-passed = passed
column-failed = failed
