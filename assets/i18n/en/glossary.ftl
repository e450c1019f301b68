# What the terms mean: one sentence each, shown where the term stands. The id is the term as it stands
# in a heading, in the listing or in another file; src/figure/glossary.rs says how.

glossary-outcode = Outcode: four bits that say outside which borders of the clip window a point lies: top, bottom, right, left. 0000 is inside.
glossary-t-b-r-l = { glossary-outcode }
glossary-clip-window = Clip window: the rectangle that the drawing is cut to. Its border belongs to it.
glossary-cohen-sutherland-window = { glossary-clip-window }
glossary-p = p: how fast the line crosses a border. Below 0 it comes in there, above 0 it goes out, at 0 it is parallel.
glossary-q = q: how far inside the border the first end lies. Below 0 it is outside.
glossary-q-p = q / p: the parameter t at which the line meets the border.
glossary-t = t: how far along the line, 0 at its first end and 1 at its last.
glossary-liang-barsky-course = Whether the line comes into the window over this border, goes out over it, or is parallel to it.
glossary-liang-barsky-from = Where the visible part begins or ends: an end of the line, or the border that cuts it.
glossary-liang-barsky-value = The parameter t of that place on the line.

glossary-transition = Whether the edge stays inside, goes out, stays outside or comes in: this says which vertices it gives.
glossary-sutherland-hodgman-transition = { glossary-transition }
glossary-clip-triangle-transition = { glossary-transition }
glossary-emits = The vertices that the edge gives to the result.
glossary-sutherland-hodgman-emits = { glossary-emits }
glossary-clip-triangle-emits = { glossary-emits }
glossary-signed-distance = d: how far the vertex lies inside the plane; below 0 it is outside.
glossary-clip-triangle-from = { glossary-signed-distance }
glossary-clip-triangle-to = { glossary-signed-distance }
glossary-ulp = ULP: how many representable numbers lie between two results.
glossary-clip-triangle-ulp = { glossary-ulp }
glossary-bvh-boxes = How many boxes hang below this one in the tree.
glossary-l-r-b-t-n-f = Which of the six planes still have to be tested: left, right, bottom, top, near, far.
glossary-frustum-culling-is = Where the object lies: inside the frustum, outside, or across a plane.

glossary-x-left = Where the centre line of the row meets the left edge of the triangle, exactly.
glossary-x-right = Where the centre line of the row meets the right edge of the triangle, exactly.
glossary-first = The first pixel of the span: the first whose centre lies at or right of x left.
glossary-end = The first pixel behind the span: it is not drawn any more.
glossary-span = Span: the pixels of one row that a triangle covers, from the first one up to, but without, the end.
glossary-scanline-spans = { glossary-span }
glossary-pixels = How many pixels: end minus first.
glossary-dx-dy = Slope: how far an edge moves along x from one row to the next.
glossary-winding = Winding number: how often the contours run around a point, in one direction less in the other. Even-odd: odd is inside. Non-zero: all but 0 is inside.
glossary-y-first = The first row whose centre line the edge crosses.
glossary-y-last = The last row whose centre line the edge crosses.
glossary-begin = The first pixel of the span.
glossary-edge-table-active = Active edges: those that the centre line of the row crosses, from left to right.
glossary-edge-table-table = Edge table: every edge under the first row that it crosses.
glossary-d = d, the decision variable: above 0 if the line passes beyond the point midway between the two next pixels.
glossary-x-inc = What one step adds to x.
glossary-y-inc = What one step adds to y.
glossary-major = The length along the axis on which the line is longer, in pixels: each step goes one pixel along it.
glossary-minor = The length along the other axis.
glossary-c = Where the line crosses the centre line of the column or row.
glossary-fill-rule = Tie rule: who draws a pixel whose centre lies exactly on an edge. With top-left, two neighbours draw it once and leave no hole.

glossary-depth = Depth: how far away, from 0 at the near plane to 1 at the far plane, as the depth buffer sees it.
glossary-code = Depth code: the whole number that is stored for the depth. Two depths with one code cannot be told apart.
glossary-hex = The stored code in base 16: one digit for four bits.
glossary-bits = The stored code in base 2.
glossary-fragment = Fragment: what a triangle would put into one pixel: a colour and a depth, before the tests.
glossary-fragments = { glossary-fragment }
glossary-passed = Fragments that passed the depth test and were drawn.
glossary-equal-codes = Fragments whose depth had the very code that was stored: there the order decides.
glossary-discarded = Fragments whose alpha failed its test: nothing of them is stored.
glossary-scissored = Fragments outside the scissor rectangle: they are not even tested.
glossary-failed = Fragments that failed the depth test: something nearer was there.
glossary-depth-format = How a depth is stored: as a whole number of 16, 24 or 32 bits (unorm), or as a 32-bit float.
glossary-depth-range = The range of visible depths in NDC: 0 to 1 as in WebGPU, or −1 to 1 as in OpenGL.

glossary-space = Space: the coordinate system in which the numbers are meant.
glossary-w = w: the fourth coordinate. After the projection it is the distance along the line of sight.
glossary-w-or-r = w until the division; then 1/w takes its place, because attributes are interpolated with it.
glossary-ndc = NDC, normalised device coordinates: what is visible lies between −1 and 1 in x and y, whatever the size of the image.
glossary-transform-space-ndc = { glossary-ndc }
glossary-transform-space-object = Object space: as the object was modelled.
glossary-transform-space-world = World space: where the object stands in the scene.
glossary-transform-space-view = Camera space: seen from the camera, which stands at the origin and looks along −z.
glossary-transform-space-clip = Clip space: after the projection and before the division; visible is −w ≤ x ≤ w and −w ≤ y ≤ w.
glossary-transform-space-screen = Screen space: in pixels, with the depth.

glossary-side-order = In which order the sides of the window cut: L left, R right, B bottom, T top. The covered set is the same; bridges may differ.
glossary-arithmetic = In which numbers the algorithm calculates: exact and rounded once, or in 32 or 64 bits, rounded at every operation as the textbook code does.
glossary-snap = Where a dragged point comes to rest.
glossary-y-axis = Whether row 0 of the image is the highest or the lowest one.
glossary-front = From which side a triangle is seen as its front: where its vertices run counter-clockwise (CCW) or clockwise (CW).
glossary-cull = Which triangles are left out by the side that they show.
glossary-eye = Where the camera stands.
glossary-target = What the camera looks at.
glossary-up = Which direction is up in the picture.
glossary-fovy = Field of view: the angle from the lower to the upper border of the picture, in degrees.
glossary-near = Near plane: what is nearer to the camera is cut off.
glossary-far = Far plane: what is farther from the camera is cut off.

glossary-came = What came into the stage.
glossary-went = What went on to the next stage.
glossary-dropped = What ended in this stage.

glossary-stage-scene = Scene: the triangles as they are given.
glossary-stage-model = Model: vertices are put where their object stands in the world.
glossary-stage-view = View: the world is moved so that the camera is at the origin.
glossary-stage-clip-space = Clip space: the projection gives every vertex a w.
glossary-stage-cull = Cull: triangles that show their back, or have no area, are left out.
glossary-stage-clip = Clip: what lies outside the visible volume is cut off.
glossary-stage-divide = Divide: x, y and z are divided by w, so that what is far away gets small.
glossary-stage-viewport = Viewport: from NDC to pixels.
glossary-stage-scan-conversion = Scan conversion: which pixels each triangle covers.
glossary-stage-fragments = Fragments: every covered pixel gets a colour and a depth.
glossary-stage-stencil = Stencil: a small number in every pixel says whether a fragment may pass.
glossary-stage-depth = Depth: a fragment passes if it is nearer than what the pixel shows.
glossary-stage-blend = Blend: the colour of a fragment is mixed with the one that is there.
glossary-stage-image = Image: what is seen in the end.

glossary-tab-step = What just happened: the sentence, the formula and the values that changed.
glossary-tab-listing = The algorithm in pseudocode, with the line that was just executed.
glossary-tab-values = Every value that the algorithm holds now.
glossary-tab-difference = How the two sides differ: how much, in what, and what each of them costs.
glossary-tab-pixel = What happened to the pixel that was clicked, fragment by fragment.
