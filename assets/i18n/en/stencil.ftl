# Stencil test. What stands between two ** is bold.

stencil = Stencil
stencil-about = Each pixel keeps a small number. Draws compare it with their own, and change it, so that one draw decides where the next one goes.
stencil-opening = Every pixel starts empty, with the stencil value { $clear }.
stencil-draw = **{ $object }** is drawn next. Its reference is { $reference }, its compare function is { $compare }.
stencil-draw-without = **{ $object }** is drawn next, without a stencil test.
stencil-outline = **{ $object }** is an outline: the same object once more, a little larger.
stencil-enlarge-scale = **{ $object }**: every vertex moves away from the centroid. Its distance is multiplied by { $amount }.
stencil-enlarge-normals = **{ $object }**: every vertex moves along its normal, by { $amount } in object space.
stencil-enlarge-pixels = **{ $object }**: every vertex moves along its normal as the screen sees it, by { $amount } pixels.
stencil-early-whole = Nothing discards fragments of **{ $object }**: each is tested and written before it is coloured. That is early z.
stencil-early-test = An alpha test may discard fragments of **{ $object }**. Early z still tests first, but writes only after the alpha test.
stencil-early-never = No early z for **{ $object }**: a fragment that fails would change the stencil, and it may still be discarded.
stencil-scissor = Row { $y }: the scissor leaves { $kept-first } ≤ x < { $kept-end } of **{ $object }**'s { $first } ≤ x < { $end }.
stencil-scissor-row = Row { $y }: the scissor leaves nothing of **{ $object }**'s { $first } ≤ x < { $end }.
stencil-discard = Pixel ({ $x }, { $y }): **{ $object } is discarded**, for its alpha is { $alpha }. Nothing is stored.
stencil-row = Row { $y }: **{ $object }** covers { $first } ≤ x < { $end }, { $count ->
    [one] 1 fragment
   *[other] { $count } fragments
}.
stencil-fragment = Pixel ({ $x }, { $y }): **{ $object }** arrives. The stencil holds { $stored }.
stencil-fail = Pixel ({ $x }, { $y }): **{ $object } fails the stencil test** ({ $test }). failOp is { $operation }: { $stored } becomes { $after }.
stencil-fail-kept = Pixel ({ $x }, { $y }): **{ $object } fails the stencil test** ({ $test }). failOp is { $operation }: { $after } stays.
stencil-depth-fail = Pixel ({ $x }, { $y }): the stencil test passes ({ $test }), but **{ $object } fails the depth test**: { $new } { $sign } { $depth }. depthFailOp is { $operation }: { $stored } becomes { $after }.
stencil-depth-fail-kept = Pixel ({ $x }, { $y }): the stencil test passes ({ $test }), but **{ $object } fails the depth test**: { $new } { $sign } { $depth }. depthFailOp is { $operation }: { $after } stays.
stencil-depth-fail-untested = Pixel ({ $x }, { $y }): **{ $object } fails the depth test**: { $new } { $sign } { $depth }.
stencil-pass = Pixel ({ $x }, { $y }): **{ $object } passes** ({ $test }). passOp is { $operation }: { $stored } becomes { $after }.
stencil-pass-kept = Pixel ({ $x }, { $y }): **{ $object } passes** ({ $test }). passOp is { $operation }: { $after } stays.
stencil-pass-untested = Pixel ({ $x }, { $y }): **{ $object } is drawn**; it has no stencil test.
stencil-done = **{ $object }** is done: { $passed } of { $count ->
    [one] 1 fragment
   *[other] { $count } fragments
} passed, { $failed } failed the stencil test and { $depth } the depth test.
stencil-done-empty = **{ $object }** is done: no pixel centre lies inside it.
stencil-values = Stencil value
stencil-operations = Operations
stencil-counts = Fragments
stencil-marker-draw = { $object }
stencil-key-passed = { $object } passed
stencil-key-failed = { $object } failed
stencil-key-object = { $object }
column-stencil = value
column-operation = operation
column-after = then
column-stencil-failed = stencil
column-depth-failed = depth
