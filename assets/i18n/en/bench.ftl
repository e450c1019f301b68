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
bench-family-long = over 4096 rows or columns
bench-family-all = every family of inputs

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
bench-column-triangles = triangles
bench-column-pixels = pixels
bench-column-frame = ms a frame, and times the first
bench-column-not-finite = not finite

# Names of what has no lab.
bench-algorithm-at-once = All borders at once
bench-algorithm-clip-triangle = Plane by plane
bench-algorithm-plane = Plane, pixel by pixel
bench-algorithm-rows = Plane, row by row
bench-algorithm-perspective = Perspective
bench-algorithm-affine = Affine
bench-algorithm-plane-equation = Plane equation
bench-algorithm-affine-plane = Plane equation, affine

# Plots.
bench-errors-title = { $stage }: run time against error
bench-errors-subtitle = Inputs: { $family }. To the left is more exact, further down is faster.
bench-error-worst = worst error (ULP of binary32), logarithmic
bench-error-mean = mean error (ULP of binary32), logarithmic
bench-error-wrong = wrong answers in a million, logarithmic
bench-short-error-worst = worst, ULP
bench-short-error-mean = mean, ULP
bench-short-error-wrong = wrong answers
bench-axis-time = time { $item } (ns), logarithmic
bench-axis-frame = time of a frame (ms), logarithmic
bench-axis-triangles = triangles, logarithmic
bench-axis-pixels = pixels of the image, logarithmic
bench-lane-exact = exact
bench-lane-infinite = not finite
bench-frontier = none is faster and more exact
bench-rounds = Median of { $rounds ->
    [one] one round
   *[other] { $rounds } rounds
}.

bench-growing-triangles = Cost by triangles
bench-growing-pixels = Cost by pixels
bench-growth-subtitle = { $factors } times as many. Both axes count in factors.
bench-method-pipeline = the pipeline, scan line
bench-method-z-buffer = the z-buffer, step by step
bench-method-engine = the frame engine

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
bench-claim-object-space-quadratic = Object space costs the square of the number of triangles, image space is proportional to it.
bench-claim-object-space-quadratic-here = Each of k triangles is held against every other; a ray, or the z-buffer, looks at each once. Four times as many: sixteen times, or four times the cost.
bench-claim-z-buffer-constant = The cost of a z-buffer stays nearly the same as triangles become more and smaller.
bench-claim-z-buffer-constant-here = The covered area stays the same; nearly the same means less than twice.
bench-claim-regions-save-tests = Testing regions first saves tests of pixels.
bench-claim-regions-save-tests-here = Small triangles fill no region; the larger they are, the more regions are decided at once.
bench-claim-fixed-point-is-enough = Fixed point of 16 bits is enough for most steps.
bench-claim-fixed-point-is-enough-here = Enough means that fewer than 1000 pixels in a million change. Small triangles are mostly edge.
bench-claim-additions-are-cheap = Incremental additions make a pixel cheap.
bench-claim-additions-are-cheap-here = Slopes need two ends a row, edge functions three tests a pixel; both in binary32.
bench-claim-perspective-one-division = Perspective correction costs one division.
bench-claim-perspective-one-division-here = One for each pixel and attribute, counted in the plane equation; those of the set-up are the row's.
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
bench-series-frame-ms-by-pairs = ms a frame, pairs, by triangles
bench-series-frame-ms-by-rays = ms a frame, rays, by triangles
bench-series-frame-ms-by-z-buffer = ms a frame, z-buffer, by triangles
bench-series-pairs = Pairs compared, by triangles
bench-series-intersections = Intersections with rays, by triangles
bench-series-divisions-a-pixel = Divisions a pixel
bench-series-pixel-ns-by-mode = ns a pixel

bench-claim-verdict = { $verdict } { $here }
bench-curve-back-facing-share = share
bench-curve-late-by-early = late by early
bench-curve-cohen-sutherland = Cohen–Sutherland
bench-curve-liang-barsky = Liang–Barsky
bench-curve-divisions-by-cuts = divisions
bench-curve-frame-ms-by-triangles = z-buffer
bench-curve-tests-by-box = bounding box
bench-curve-tests-by-tiles = tiles
bench-curve-changed-per-million = fixed point, 8 bits
bench-curve-pixel-ns-by-slopes = slopes
bench-curve-pixel-ns-by-edges = edge functions
bench-curve-depth-ns-by-rows = row by row
bench-curve-depth-ns-by-pixels = pixel by pixel
bench-curve-frame-ms-by-pairs = object space: pairs of triangles
bench-curve-frame-ms-by-rays = image space: rays through pixels
bench-curve-frame-ms-by-z-buffer = image space: z-buffer
bench-curve-divisions-a-pixel = divisions

bench-x-model = model
bench-x-outside = lines outside (%)
bench-x-cuts = cuts of the line
bench-x-triangles = triangles, logarithmic
bench-x-leg = legs of the triangles (px), logarithmic
bench-x-mode = interpolation
bench-y-share = share of triangles that face away
bench-y-late-by-early = time of culling late, by that of early
bench-y-line = time a line (ns)
bench-y-divisions = divisions a line
bench-y-divisions-pixel = divisions a pixel
bench-y-frame = time of a frame (ms)
bench-y-frame-log = time of a frame (ms), logarithmic
bench-y-tests = tests a covered pixel, logarithmic
bench-y-changed = changed pixels in a million, logarithmic
bench-y-pixel = time a pixel (ns), logarithmic
bench-y-depth = time a depth (ns), logarithmic
bench-guide-culling-removes-half = half
bench-guide-cull-before-clipping = no difference
bench-guide-fixed-point-is-enough = enough: below 1000

bench-short-claim-culling-removes-half = Back-face culling removes half
bench-short-claim-cull-before-clipping = Cull before clipping
bench-short-claim-outcodes-when-outside = Outcodes when most are outside
bench-short-claim-no-division-to-decide = Deciding without divisions
bench-short-claim-object-space-quadratic = Object space k², image space k
bench-short-claim-z-buffer-constant = z-buffer cost nearly constant
bench-short-claim-regions-save-tests = Regions save pixel tests
bench-short-claim-fixed-point-is-enough = 16-bit fixed point is enough
bench-short-claim-additions-are-cheap = Additions make a pixel cheap
bench-short-claim-perspective-one-division = Perspective costs one division
bench-short-claim-row-coherence = Row coherence saves depth work

bench-skips-frames = Frames with and without each skip
bench-skips-skip = skip
bench-skips-left-out = left out
bench-skips-done = done
bench-skips-without = time without
bench-skips-same = same bytes
bench-skips-yes = yes
bench-skips-no = NO
bench-skips-stage = into the stage
bench-skips-with = with all
bench-skips-none = with none
bench-skips-all = With all skips a frame takes { $ms } ms: { $before } before the screen, { $on } on it.
bench-skips-nothing = With none it takes { $ms } ms ({ $before } and { $on }), { $times } times as long.
bench-skips-proof = Colour, depth and stencil are equal, byte for byte, with each skip and without it.
