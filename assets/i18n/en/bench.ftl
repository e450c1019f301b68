# rasterscope bench: run time against error, and the claims of the lectures.

bench-progress = { $bar } { $done } of { $all }  { $what }
bench-machine = { $processor }, { $count ->
    [one] one processor
   *[other] { $count } processors
}, { $system }; version { $version }, { $build } build, vectors { $vectors }. Compare times of one table only.

bench-stage-line-clipping = Line clipping
bench-stage-polygon-clipping = Polygon clipping
bench-stage-homogeneous-clipping = Clipping in clip space
bench-stage-coverage = Coverage
bench-stage-depth = Depth
bench-stage-attributes = Attributes

bench-family-ordinary = ordinary
bench-family-past-a-corner = past a corner, but for a rounding
bench-family-beside = on a border or a centre, or two steps beside it
bench-family-nearly-parallel = nearly parallel to a border
bench-family-huge = huge, up to 3 × 10³⁸
bench-family-denormal = denormal, below 10⁻³⁸
bench-family-sliver = slivers
bench-family-near-w-zero = w near 0
bench-family-long = over 4096 rows

bench-item-segment = a segment
bench-item-corner = a corner
bench-item-triangle = a triangle
bench-item-pixel = a pixel
bench-item-point = a point
bench-call-fast = fast call

bench-column-ns = ns
bench-column-quartiles = quartiles
bench-column-wrong = wrong / 10⁶
bench-column-mean = mean ULP
bench-column-max = max ULP
bench-column-exact = exact tail
bench-column-not-finite = not finite

bench-verdict-holds = It holds.
bench-verdict-under-a-condition = It holds under a condition.
bench-verdict-does-not-hold = It does not hold.

bench-claim-culling-removes-half = Back-face culling removes about half of the triangles.
bench-claim-culling-removes-half-here = Of a closed model about half face away; of a round one near the eye, more.
bench-claim-cull-before-clipping = It pays to cull before clipping.
bench-claim-cull-before-clipping-here = The whole frame is timed: what culling late adds is lost where pixels take most of the time.
bench-claim-outcodes-when-outside = Cohen-Sutherland is efficient when most lines are outside.
bench-claim-outcodes-when-outside-here = Both run as taught, in binary64; most lines outside means 75 % or more.
bench-claim-no-division-to-decide = Liang-Barsky decides without divisions.
bench-claim-no-division-to-decide-here = A line that is rejected, or kept whole, costs no division; each cut costs one quotient.
bench-claim-z-buffer-constant = The cost of a z-buffer stays nearly the same as triangles become more and smaller.
bench-claim-z-buffer-constant-here = The covered area stays the same; nearly the same means less than twice.
bench-claim-regions-save-tests = Testing regions first saves tests of pixels.
bench-claim-regions-save-tests-here = Small triangles fill no region; the larger they are, the more regions are decided at once.
bench-claim-fixed-point-is-enough = Fixed point of 16 bits is enough for most steps.
bench-claim-fixed-point-is-enough-here = Enough means that fewer than 1000 pixels in a million change. Small triangles are mostly edge.
bench-claim-additions-are-cheap = Incremental additions make a pixel cheap.
bench-claim-additions-are-cheap-here = Slopes need two ends a row, edge functions three tests a pixel; both in binary32.
bench-claim-row-coherence = Coherence along a row saves depth work.
bench-claim-row-coherence-here = What a row shares is computed once, which rows of a few pixels do not earn back. The depths are the same, bit for bit.

bench-series-back-facing-share = Share facing away
bench-series-late-by-early = Time of culling late, by that of early
bench-series-cohen-sutherland = Cohen-Sutherland, ns a line, by % outside
bench-series-liang-barsky = Liang-Barsky, ns a line, by % outside
bench-series-divisions-by-cuts = Divisions a line, by cuts
bench-series-frame-ms-by-triangles = ms a frame, by triangles
bench-series-tests-by-box = Tests a covered pixel, bounding box, by leg
bench-series-tests-by-tiles = Tests a covered pixel, tiles, by leg
bench-series-changed-per-million = Changed pixels in a million, by leg
bench-series-pixel-ns-by-slopes = ns a pixel, slopes, by leg
bench-series-pixel-ns-by-edges = ns a pixel, edge functions, by leg
bench-series-depth-ns-by-rows = ns a depth, by row, by leg
bench-series-depth-ns-by-pixels = ns a depth, by pixel, by leg
