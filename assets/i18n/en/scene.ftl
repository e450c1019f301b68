# Scene files, models and presets.

## A scene file that cannot be used. $path is the field, such as draws[2].vertices[0][1].

error-scene-empty = The file is empty. A scene is a JSON object; the smallest one is {"{"}"rasterscope": 1, "size": [36, 24], "draws": []{"}"}.
error-scene-not-text = Line { $line } is not text, so this is no scene file. A scene is JSON in UTF-8; a model is an OBJ file.
error-scene-too-large = The file has { $bytes } bytes; a scene has at most { $limit }. Put large meshes into an OBJ file and name it as "model".
error-scene-json = Line { $line }, column { $column }: this is not JSON ({ $what }). Correct it there.
error-scene-json-ends = The file ends in the middle, at line { $line }, column { $column }. It may have been cut off: save it again or close what is open.

error-scene-kind = { $path }: { $wanted } is expected here, not { $found }.
error-scene-kind-null = nothing (null)
error-scene-kind-bool = true or false
error-scene-kind-number = a number
error-scene-kind-whole-number = a whole number
error-scene-kind-fraction = one with a fraction
error-scene-kind-text = a text in quotes
error-scene-kind-list = a list
error-scene-kind-object = an object
error-scene-length = { $path }: the list must have { $wanted ->
    [one] one item
   *[other] { $wanted } items
}; it has { $found }.
error-scene-too-short = { $path }: the list must have at least { $least ->
    [one] one item
   *[other] { $least } items
}; it has { $found }.
error-scene-missing = { $path }: this field is missing. Add it.
error-scene-unknown-field = { $path }: this field does not belong here. The fields here are: { $known }.
error-scene-unknown-name = { $path }: "{ $name }" is unknown. Use one of: { $known }.
error-scene-both = { $path }: this field and "{ $other }" exclude each other. Remove one of them.
error-scene-not-a-scene = This JSON is no scene: it must be an object with "rasterscope": 1.
error-scene-newer = { $path }: the scene has version { $version }, made by a newer Rasterscope. This one reads versions up to { $known }.
error-scene-not-finite = { $path }: the number must be finite as a 32-bit float, at most about 3.4e38.
error-scene-negative = { $path }: the number must be 0 or more.
error-scene-must-be = { $path }: the number must be { $value }.
error-scene-range = { $path }: the number must be from { $min } to { $max }.
error-scene-not-positive = { $path }: the number must be more than 0.
error-scene-no-power-of-two = { $path }: the number must be a power of two.
error-scene-field-of-view = { $path }: the angle must be more than 0 and less than 180 degrees.
error-scene-far-before-near = { $path }: the far plane must lie beyond the near plane.
error-scene-eye-is-target = { $path }: the camera looks at its own place. Move the target or the eye.
error-scene-up-parallel = { $path }: "up" must not be zero or parallel to the line of sight.
error-scene-too-many-pixels = { $path }: the image has too many pixels; at most { $limit } are possible.
error-scene-samples = { $path }: a pixel has 1, 2, 4 or 8 samples.
error-scene-not-triples = { $path }: without indices every three vertices are a triangle, but { $found } is no multiple of 3.
error-scene-no-such-vertex = { $path }: there is no vertex { $index }; { $vertices ->
    [one] the only vertex is number 0
   *[other] the { $vertices } vertices count from 0
}.
error-scene-not-one-each = { $path }: there must be one for { $vertices ->
    [one] the only vertex
   *[other] each of the { $vertices } vertices
}, not { $found }.
error-scene-no-texture-coordinates = { $path }: a texture needs texture coordinates, and this mesh has none. Add "uvs" or remove the texture.
error-scene-window-reversed = { $path }: the window is [xmin, ymin, xmax, ymax], and no minimum may exceed its maximum.
error-scene-polygon-corners = { $path }: the window must have 3 to 32 corners.
error-scene-polygon-no-area = { $path }: all corners lie on one line, so the window has no inside. Move one of them off the line.
error-scene-polygon-not-convex = { $path }: the window must be convex, and a corner bends inward or the outline crosses itself. Move that corner outward.
error-scene-none-there = { $path }: there is none to choose from. Add one, or remove the lab.
error-scene-no-setting = { $path }: name the one setting in which the two sides differ, such as {"{"}"fill_rule": "inclusive"{"}"}.
error-scene-no-file-name = { $path }: this is no file name. Write the name of an OBJ file, such as "cube.obj".
error-scene-draw-out-of-range = { $path }: the vertices of { $name } leave the range of 32-bit floats (about 3.4e38) when transformed. Scale it down.
error-scene-camera-out-of-range = { $path }: its matrices leave the range of 32-bit floats (about 3.4e38). Move it nearer, or make near, far, height and angle less extreme.
error-scene-other = { $path }: this value cannot be used ({ $what }).
error-scene-unreadable = { $path }: the model { $file } cannot be read ({ $reason }). Put it beside the scene or name a model that comes with the program.

## An OBJ file that cannot be used. $word is as written in the file.

error-obj-empty = { $file }: the file is empty.
error-obj-binary = { $file }, line { $line }: this is a binary file, not OBJ. Export the model as Wavefront OBJ.
error-obj-line-too-long = { $file }, line { $line }: the line has { $bytes } bytes; at most { $limit } are possible. The file may be damaged.
error-obj-number = { $file }, line { $line }: "{ $word }" is no number. Write one such as 1.5 or -2e3.
error-obj-not-finite = { $file }, line { $line }: "{ $word }" is not finite as a 32-bit float. Write a number of at most about 3.4e38.
error-obj-count = { $file }, line { $line }: "{ $keyword }" takes { $keyword ->
    [v] 3, 4 or 6
    [vt] 2 or 3
   *[vn] 3
} numbers; here are { $found }. The line may have been cut off.
error-obj-zero-weight = { $file }, line { $line }: the fourth number divides the other three, so it must not be 0.
error-obj-color = { $file }, line { $line }: the colour { $word } must be from 0 to 1.
error-obj-some-colors = { $file }, line { $line }: some vertices have a colour and some have none. Give one to all or to none.
error-obj-corners = { $file }, line { $line }: a face needs 3 corners or more; here are { $found }. The line may have been cut off.
error-obj-corner = { $file }, line { $line }: "{ $word }" is no corner. A corner is v, v/vt, v//vn or v/vt/vn.
error-obj-index-zero = { $file }, line { $line }: there is no index 0; the first one is 1 and the last one is -1.
error-obj-no-such-index = { $file }, line { $line }: the face refers to "{ $keyword }" number { $index }, but there are only { $count }. The file may have been cut off.
error-obj-no-faces = { $file }: the file has no faces, so there is nothing to draw.
error-obj-not-obj = { $file }, line { $line }: "{ $word }" is no OBJ statement, and the file has no faces. Is it an OBJ file?
error-obj-refused = { $file }: the model cannot be used ({ $what }).

## The presets: a name, and one sentence or two why the case matters.

preset-two-through-each-other-name = Two through each other
preset-two-through-each-other = A and B pass through each other: every pixel has its own nearest. C shows its back, so it is culled.

preset-acceptance-square-name = Square on pixel centres
preset-acceptance-square = All corners and the diagonal lie on pixel centres. The tie rule fills exactly 36 pixels, each once.

preset-shared-edges-through-centres-name = Fan around a pixel centre
preset-shared-edges-through-centres = Eight triangles share edges that run through pixel centres. Each centre belongs to exactly one of them.

preset-near-plane-name = Through the near plane
preset-near-plane = One corner is too near. The near plane cuts it off, and two triangles remain.

preset-behind-the-eye-name = Behind the eye
preset-behind-the-eye = One corner lies behind the eye, where w is negative. Dividing before clipping would throw it to the wrong side.

preset-sliver-name = Sliver
preset-sliver = The triangle is thinner than a pixel, so it covers only the centres that it happens to meet. The gaps are right.

preset-zero-area-name = Zero area
preset-zero-area = A is a line and B has two equal corners. Neither covers a point, so both are dropped.

preset-edge-on-name = Edge-on
preset-edge-on = The plane of A goes through the eye: its determinant is exactly zero. It is not front, not back, and covers nothing.

preset-mirrored-name = Mirrored
preset-mirrored = A and B have the same vertices, but the scale of B is negative. That turns its front into its back, so B is culled.

preset-off-screen-huge-name = Corners far off the screen
preset-off-screen-huge = A and B share an edge two million units long. Snapped or fixed-point coordinates overflow here; exact ones leave no gap.

preset-cyclic-overlap-name = Cyclic overlap
preset-cyclic-overlap = A covers B, B covers C and C covers A. No drawing order is right without a depth test.

preset-z-fighting-name = Nearly coplanar
preset-z-fighting = B lies nearer than A everywhere, but by half a step of the 16-bit code. It wins only where the codes differ: in stripes. Lay equal depth codes on the image: there A stays.

preset-reversed-depth-name = Reversed depth
preset-reversed-depth = Near is 1 and far is 0: the buffer is cleared to 0 and the greater depth wins. The old compare function would draw nothing.

preset-checkered-square-name = Checkered square
preset-checkered-square = The square leans away, so its far half is small on the screen. Only a division by 1/w at each pixel keeps the squares straight.

preset-order-of-blending-name = Order of blending
preset-order-of-blending = Right are the same two layers as left, in the other order. Where they overlap, the layer drawn last counts most.

preset-stencil-mask-name = Stencil mask
preset-stencil-mask = A writes 1 into the stencil. B is drawn only where the stencil is 1, so A cuts B out.

preset-outline-name = Outline by stencil
preset-outline = The pawn is drawn and writes 1. An enlarged one is drawn where the stencil is not 1: what remains is the outline.

preset-tetrahedron-name = Tetrahedron
preset-tetrahedron = Every corner has its own colour. Inside a face the colour is the weighted mean of three corners, weighted by 1/w.

preset-cube-name = Cube
preset-cube = Twelve triangles, of which at most six face the eye. Culling the others changes no pixel, because the cube is closed.

preset-pawn-name = Pawn
preset-pawn = A body of revolution: many small triangles, about half of them turned away. This is what a real model asks of each stage.

preset-trefoil-name = Trefoil knot
preset-trefoil = The knot passes before and behind itself three times. No order of whole objects can replace a depth for each pixel.

preset-spheres-name = Spheres through the sides
preset-spheres = Two spheres reach out of the view. Some triangles are dropped whole, some are cut, and the cuts leave no gap.

preset-point-in-a-region-name = Beyond one border
preset-point-in-a-region = One comparison says yes: the point lies in the region to the right of the window.

preset-point-inside-name = Inside
preset-point-inside = No comparison says yes: the code is 0000.

preset-point-beyond-two-name = Beyond two borders
preset-point-beyond-two = Two bits are 1 in the corner regions. More than two are impossible.

preset-point-on-a-border-name = On a border
preset-point-on-a-border = The window is closed: beyond means more than ymax, and equal is not more.

preset-point-on-a-corner-name = On a corner
preset-point-on-a-corner = The point lies on two borders at once and is visible.

preset-point-one-step-outside-name = One step outside
preset-point-one-step-outside = The next f32 after xmax = 9. On the screen it is on the border; a comparison needs no tolerance to know better.

preset-line-three-cuts-name = Three cuts, corner to corner
preset-line-three-cuts = Both ends lie in corner regions. Three borders cut before the line is accepted.

preset-line-inside-name = Inside: accepted at once
preset-line-inside = Both codes are 0000. One OR decides, and nothing is computed.

preset-line-same-side-name = Same side: rejected at once
preset-line-same-side = Both ends lie above the window. One AND decides, and nothing is computed.

preset-line-looks-hidden-name = Looks hidden, is not (AND = 0)
preset-line-looks-hidden = Both ends lie outside, but on no common side. Only cutting shows that a piece is visible.

preset-line-passes-by-name = Passes by (AND = 0)
preset-line-passes-by = The ends share no side, yet the line misses the window. It is rejected after a cut, not at once.

preset-line-touches-a-corner-name = Touches a corner
preset-line-touches-a-corner = The line meets the window in one point. The window is closed, so this point is visible.

preset-line-along-a-border-name = Along a border
preset-line-along-a-border = The line runs on the border itself. Border points have code 0000, so only the ends are cut.

preset-line-or-for-and-name = Mistake: OR instead of AND
preset-line-or-for-and = The line crosses the window, but its codes are joined by OR. So it is rejected.

preset-line-crack-name = Mistake: a crack
preset-line-crack = So far from the origin f32 has only sixteenths. Two neighbours that share this edge cut it from different ends and do not meet.

preset-order-kept-name = Four crossings, kept
preset-order-kept = All four crossings lie between the ends, in the order 1 > α4 > α3 > α2 > α1 > 0. The two inner ones cut.

preset-order-rejected-name = Four crossings, rejected
preset-order-rejected = In the order 1 > α4 > α2 > α3 > α1 > 0 the line leaves at the top before it enters at the left. Nothing is visible.

preset-order-reversed-name = The same, from the other end
preset-order-reversed = P1 and P2 have changed places, so every entry became an exit. The visible part has the same bits.

preset-order-parallel-name = Parallel to two borders
preset-order-parallel = For the top and the bottom border p is 0: they have no t. Only the other two cut.

preset-order-parallel-outside-name = Parallel and outside
preset-order-parallel-outside = For the top border p is 0 and q is negative. One comparison decides, whatever the other borders say.

preset-order-one-cut-name = One end inside
preset-order-one-cut = Every entry lies before P1, so t0 stays 0 and P1 keeps its bits. One division cuts P2.

preset-order-inside-name = Both ends inside
preset-order-inside = Every entry lies before P1 and every exit after P2. Nothing is divided.

preset-convex-pentagon-name = Across a pentagon
preset-convex-pentagon = Five edges, five normals. The last entry and the first exit bound the visible part.

preset-convex-rectangle-name = A rectangle
preset-convex-rectangle = The usual window as four edges: the answer is bit for bit that of the other algorithms, at the price of four divisions.

preset-convex-clockwise-name = Clockwise corners
preset-convex-clockwise = The same pentagon, its corners given the other way round. The inside stays the inside.

preset-convex-just-missed-name = Just missed
preset-convex-just-missed = The line leaves one edge before it enters another: tE is after tL.

preset-convex-along-an-edge-name = Along an edge
preset-convex-along-an-edge = D·n is 0: the line runs on the edge itself. The window is closed, so that is inside.

preset-convex-through-a-corner-name = Touches a corner
preset-convex-through-a-corner = The line touches the window in one corner: tE = tL, and the point is visible.

preset-convex-inside-name = Both ends inside
preset-convex-inside = Every entry lies before P1 and every exit after P2. It still costs a division an edge.

preset-halve-corner-to-corner-name = From corner to corner
preset-halve-corner-to-corner = Both ends are outside, so there are two searches. Each halving adds one bit to the answer.

preset-halve-one-end-name = One end inside
preset-halve-one-end = P1 lies inside and stays. Only the last visible point towards P2 is sought.

preset-halve-hits-a-border-name = A midpoint on the border
preset-halve-hits-a-border = The first midpoint is the corner itself. The search goes on all the same: it cannot know that this is the last visible point.

preset-halve-until-rejected-name = Passes by
preset-halve-until-rejected = The codes share no bit, and yet nothing is visible. After a few halvings what is left lies beyond one border.

preset-halve-touches-a-corner-name = Touches a corner
preset-halve-touches-a-corner = The corner lies a third of the way, and no halving hits a third. Exact signs decide in the end: it is visible.

preset-halve-misses-a-corner-name = Misses a corner in f32
preset-halve-misses-a-corner = The same line with rounded midpoints: the touched corner is lost.

preset-halve-inside-name = Both ends inside
preset-halve-inside = Both codes are 0: nothing is halved.

preset-regions-from-a-corner-name = From a corner region
preset-regions-from-a-corner = P1 lies beyond two borders. One slope tells where the line enters, another where it leaves.

preset-regions-from-an-edge-name = From an edge region
preset-regions-from-an-edge = P1 lies beyond one border, so the line can only enter there. P2 lies across: no slope is needed.

preset-regions-from-inside-name = From inside
preset-regions-from-inside = P2 lies beyond two borders. The slope to their corner tells which one cuts, and only that point is computed.

preset-regions-just-missed-name = Just missed
preset-regions-just-missed = The line passes the corner on the outside. Two products tell it, and no point is computed.

preset-regions-through-a-corner-name = Through a corner
preset-regions-through-a-corner = Both borders of the corner are crossed at once. Either would give the same point.

preset-regions-same-side-name = On the same side
preset-regions-same-side = P2 lies beyond the border that P1 lies beyond. Three comparisons reject the line.
preset-polygon-triangle-name = A triangle loses three corners
preset-polygon-triangle = Every corner is outside, yet most of the triangle is visible. A corner of the window becomes a corner of the polygon.

preset-polygon-e-shape-name = An E falls apart: bridges
preset-polygon-e-shape = The back of the E is cut off and three bars are left. One outline must hold them all, so it runs along the border there and back.

preset-polygon-star-name = A star that crosses itself
preset-polygon-star = The four transitions do not care that edges cross. Around every point inside the window the outline winds as often as before.

preset-polygon-around-name = Around the window
preset-polygon-around = No corner is inside and no edge crosses the window. What is left is the window itself.

preset-polygon-edge-on-border-name = An edge on a border
preset-polygon-edge-on-border = Two corners lie exactly on the left border. The window is closed, so they are inside and nothing is computed for them.

preset-polygon-touches-a-corner-name = Touches in a corner
preset-polygon-touches-a-corner = One point is in the window. It has no area, so nothing is left.

preset-polygon-crack-name = Neighbours with a crack (f32)
preset-polygon-crack = Both polygons have the edge V0 V1, in opposite directions. Cut from whichever end comes first, rounding gives them different corners.

preset-polygon-two-sides-name = Only two sides cut
preset-polygon-two-sides = Right at the left and the bottom, wrong at the right and the top: two of the four sides were forgotten.

preset-pieces-convex-name = A: convex, one piece
preset-pieces-convex = Six crossings, entering and leaving by turns. The ring goes along the polygon and along the border, three times each.

preset-pieces-three-name = B: concave, three pieces
preset-pieces-three = One polygon falls apart into three. Each piece has a ring of its own, and no bridge joins them.

preset-pieces-holes-name = Two holes, one cut open
preset-pieces-holes = One hole is inside the window and stays a hole. The other crosses the border and becomes a dent.

preset-pieces-star-name = A star that crosses itself
preset-pieces-star = By the even-odd rule the middle of the star is outside. One ring that crosses itself leaves it free.

preset-pieces-touching-name = Corners and edges on borders
preset-pieces-touching = Corners lie on borders and one edge runs along one. The window counts as a trace smaller, so each touch is a plain crossing or none.

preset-pieces-around-name = Around the window, with a hole
preset-pieces-around = Nothing crosses the border, and the border is inside. The window itself is a ring, and the inner contour is its hole.

preset-span-left-tie-name = One tie on a left edge
preset-span-left-tie = In row 4 the left edge runs exactly through a pixel centre. A left edge draws it; a right edge would not.

preset-span-apex-on-a-row-name = Apex on a centre row
preset-span-apex-on-a-row = The apex lies on the line of pixel centres of row 1. The span there is empty: it begins where it ends.

preset-span-shared-diagonal-name = Shared diagonal, 36 pixels
preset-span-shared-diagonal = The diagonal of the square runs through pixel centres. It is a left edge for one triangle and a right edge for the other.

preset-span-needle-name = Needle: no centre inside
preset-span-needle = The needle crosses eight rows, but every span lies between two pixel centres. Nothing is drawn, and that is right.

preset-span-flat-top-name = Flat top on a centre row
preset-span-flat-top = A horizontal edge lies on the line of pixel centres. A top edge draws that row.

preset-span-flat-bottom-name = Flat bottom on a centre row
preset-span-flat-bottom = A horizontal edge lies on the line of pixel centres. A bottom edge does not draw that row.

preset-box-half-wasted-name = About half is wasted
preset-box-half-wasted = A triangle fills half of its box. The other half of the centres is tested for nothing, unless a row is left early.

preset-box-sliver-name = Sliver: nearly all is wasted
preset-box-sliver = A thin triangle along the diagonal has the box of a fat one. Nearly every test keeps its centre out.

preset-box-ties-name = Ties on all three edges
preset-box-ties = Every edge runs through pixel centres. The left and the top edge draw them, the slanted edge does not.

preset-box-mirrored-name = Turned the other way
preset-box-mirrored = The same corners in the other turning sense. The edges are turned round, so that the inside stays positive: the same pixels.

preset-box-huge-name = Corners far off the screen
preset-box-huge = Coordinates of 10³⁰ pixels. The box is cut to the image, and the signs are still exact.

preset-box-zero-area-name = Three corners on one line
preset-box-zero-area = Many centres lie exactly on the line. Still nothing is drawn: a triangle without area has no inside.

preset-back-to-the-left-name = Back, then fill
preset-back-to-the-left = In each row the walk goes left until the triangle lies to the right, then fills up to the other side.

preset-back-leaning-left-name = Leaning left: back is long
preset-back-leaning-left = The row above ends far to the right of where the next begins. Each row is walked nearly twice.

preset-back-leaning-right-name = Leaning right: back is short
preset-back-leaning-right = The row above ends near the begin of the next. Hardly any centre is tested twice.

preset-back-needle-name = Needle: no centre inside
preset-back-needle = The needle passes between all centres. Every row is walked, and nothing is drawn.

preset-back-flat-top-name = Flat top on centres
preset-back-flat-top = Two corners are highest; the walk begins at the first. The whole top row are ties, and a top edge draws them.

preset-back-apex-outside-name = Apex outside the image
preset-back-apex-outside = The highest corner lies above and left of the image. The walk begins at the border, where the image begins.

preset-zigzag-both-sides-name = To both sides
preset-zigzag-both-sides = Each row is entered below the middle of the row above: first to the left, then to the right. No centre is tested twice.

preset-zigzag-leaning-left-name = Leaning left
preset-zigzag-leaning-left = Where backtracking walks a row nearly twice, zigzag tests each centre once.

preset-zigzag-shallow-name = Shallow: the start is outside
preset-zigzag-shallow = The next row begins beside the triangle. The walk must not stop at the first centre outside.

preset-zigzag-tie-name = One tie on a left edge
preset-zigzag-tie = In row 4 the left edge runs exactly through a pixel centre. It is drawn, and the walk goes on to the left.

preset-zigzag-point-up-and-down-name = Apex on a centre
preset-zigzag-point-up-and-down = The highest corner is a pixel centre. It lies on two edges at once: one of them does not draw it.

preset-zigzag-against-backtracking-name = Split: two ways
preset-zigzag-against-backtracking = The same triangle both ways. The pixels are the same; the numbers of tests are not.

preset-tiles-nested-name = Squares of 64, 16 and 4
preset-tiles-nested = Whole squares are left out or drawn at once. Only along the edges squares are split, down to single centres.

preset-tiles-inside-name = Whole tiles inside
preset-tiles-inside = The worst centre of a tile lies inside all edges: its sixteen pixels are drawn without a test of their own.

preset-tiles-outside-name = Whole tiles outside
preset-tiles-outside = Most tiles of the box lie outside one edge. Two corners of a tile settle sixteen centres, or 256.

preset-tiles-small-name = Too small for tiles
preset-tiles-small = The triangle lies in one tile of 4 × 4. The two larger tiles around it are looked at for nothing.

preset-tiles-tie-name = A tie decides a whole tile
preset-tiles-tie = The left edge runs through the first centres of two tiles. A left edge draws its ties, so both are drawn whole; a right edge would split them.

preset-tiles-huge-name = The image is inside
preset-tiles-huge = The triangle covers all of the image. One look at one tile of 64 × 64 draws 768 pixels.

preset-tiles-against-box-name = Split: tiles against the box
preset-tiles-against-box = A long thin triangle. The tiles look at few centres, the box at all of them.
preset-stencil-outline-scale-name = Outline: scaled
preset-stencil-outline-scale = The L is drawn and writes 1, is scaled about its centroid, and is drawn where the stencil is not 1. It is concave: in its notch the outline falls inside.

preset-stencil-outline-normals-name = Outline: along normals
preset-stencil-outline-normals = Each corner of the same L moves along its normal. Now the notch has its outline too, as wide as the other edges.

preset-stencil-outline-pixels-name = Outline: in pixels
preset-stencil-outline-pixels = Each corner moves by two pixels on the screen. An object farther away would have an outline of the same width.

preset-stencil-outlines-overlap-name = Outlines of overlapping objects
preset-stencil-outlines-overlap = Left each object writes a value of its own, so each has a whole outline. Right all write 1: one outline runs around both.

preset-stencil-keyhole-name = Mask: a keyhole
preset-stencil-keyhole = A writes 1. B is drawn only where the stencil is 1, C only where it is not.

preset-stencil-even-odd-name = Even-odd by inverting
preset-stencil-even-odd = Three triangles of a star that crosses itself invert one bit. Where an odd number met, B finds a 1 and fills it.

preset-stencil-mirror-name = Mirror
preset-stencil-mirror = The floor A writes 1. B is the object mirrored, drawn only on the floor; without the test it would hang below it.

preset-stencil-shadow-volume-name = Shadow volume, counted
preset-stencil-shadow-volume = Front faces of the shadow's body count up, back faces count down, each only where it lies before the scene. What is not 0 lies inside: in shadow.
preset-fill-star-name = A star by the even-odd rule
preset-fill-star = The middle is wound around twice. Twice is even, so it is outside.

preset-fill-star-non-zero-name = A star by both rules
preset-fill-star-non-zero = The middle is wound around twice: outside by the even-odd rule, inside by the non-zero rule. Seven pixels tell.

preset-fill-ring-name = A hole that turns back
preset-fill-ring = The hole runs against the outer contour, so its inside is wound around 1 − 1 = 0 times. Both rules leave it free.

preset-fill-ring-same-way-name = A hole that turns along
preset-fill-ring-same-way = Here the hole runs the same way as the outer contour, so its inside is wound around twice. The non-zero rule fills it.

preset-fill-comb-name = A comb: six crossings
preset-fill-comb = A concave polygon has several spans in a row. The list of active edges changes only where an edge begins or ends.

preset-fill-on-centres-name = Every edge through centres
preset-fill-on-centres = Top and left edges take the centres on them, bottom and right edges do not. So the row where both contours meet is drawn once.

preset-fill-crossing-name = Edges that cross
preset-fill-crossing = Below the crossing the two edges have changed places. They are sorted again in each row, by the column that they reach.

preset-fill-sliver-name = Sliver: spans without a pixel
preset-fill-sliver = The polygon crosses eight rows, but it is so thin that most rows have no pixel centre between its edges.

preset-vertices-fixed-4-name = Split: four bits below the pixel
preset-vertices-fixed-4 = Corners snapped to sixteenths of a pixel move the edges across two centres. With eight bits no pixel changes here.

preset-vertices-whole-name = Split: corners cast to whole numbers
preset-vertices-whole = The cast drops the fractions, so the triangle jumps up and to the left. Twelve of its pixels are wrong.

preset-edge-epsilon-name = Split: an epsilon in the edge test
preset-edge-epsilon = Who calls nearly zero zero lets the tie rule decide beside an edge. The longer the edge, the nearer is nearly.

preset-edge-epsilon-tiny-name = Split: a tiny triangle, a tiny epsilon
preset-edge-epsilon-tiny = The triangle is a thousandth of a pixel wide and holds a centre. All its edge functions are below 0.00001: the pixel is lost.

preset-slopes-added-up-name = Split: slopes added up
preset-slopes-added-up = In every tenth row the left edge meets a centre. One tenth has no exact binary form: after 400 additions such ties are lost.

preset-homogeneous-in-front-name = All corners in front
preset-homogeneous-in-front = Every w is positive. The pixels are those of the projected triangle, and nothing was divided to test them.

preset-homogeneous-one-behind-name = One corner behind the eye
preset-homogeneous-one-behind = V2 is behind the eye; divided by w it would come out at the wrong side. The triangle runs off the screen instead.

preset-homogeneous-two-behind-name = Two corners behind the eye
preset-homogeneous-two-behind = Only V0 is in front. What is seen is the wedge at V0, up to the border of the image.

preset-homogeneous-w-zero-name = A corner with w = 0
preset-homogeneous-w-zero = V2 is a direction: the two edges to it run in parallel and never meet. A division would have no result.

preset-homogeneous-divide-first-name = Split: division first
preset-homogeneous-divide-first = Right, x and y are divided by w before anything else. The corner behind the eye becomes one in front: a wrong triangle.

preset-homogeneous-near-plane-name = The near plane cuts
preset-homogeneous-near-plane = The near plane is a fourth edge. It cuts off what is nearer than w = 0.4, without a new corner.

preset-homogeneous-edge-on-name = Seen edge-on
preset-homogeneous-edge-on = The eye lies in the plane of the triangle. The determinant is 0, so nothing is drawn.
preset-steps-gentle-name = A gentle line
preset-steps-gentle = Eleven columns, so ten steps. y grows by the same amount at each and is rounded for each pixel.

preset-steps-steep-name = A steep line
preset-steps-steep = The longer way is along y: each step goes down one row, and x is the one that is rounded.

preset-steps-backwards-name = Backwards
preset-steps-backwards = From right to left the steps are negative. In exact arithmetic the same pixels are drawn from either end.

preset-steps-f32-tie-name = A tie that rounding breaks
preset-steps-f32-tie = After three steps y is exactly 1.5. In f32 three times 0.16666667 ends below that, and another pixel is drawn.

preset-steps-f64-tie-name = The same in f64
preset-steps-f64-tie = More digits break fewer ties, but they still break some. This line differs in f64 as well.

preset-steps-one-pixel-name = Both ends in one pixel
preset-steps-one-pixel = No step is needed, and no division: it would be 0 / 0. The pixel is drawn.

preset-octant-gentle-name = A gentle line
preset-octant-gentle = d says at each step which of two pixels is nearer. It is a whole number and changes by additions alone.

preset-octant-steep-name = A steep line
preset-octant-steep = The roles of x and y change: each step goes down one row, and d says when to go aside by one column.

preset-octant-backwards-name = Left and up
preset-octant-backwards = In all eight directions the same text works: only the signs of the two steps change.

preset-octant-tie-name = d = 0: two pixels equally near
preset-octant-tie = Every second step passes exactly between two pixels. The lower one is taken, from either end.

preset-octant-diagonal-name = The diagonal
preset-octant-diagonal = d is above 0 at every step, so each goes aside: the pixels touch in their corners only.

preset-octant-rounded-ends-name = Ends between centres
preset-octant-rounded-ends = The ends are moved to pixel centres, so another line is drawn than was given: the dashed one is the given one.

preset-two-sides-line-name = Rounded ends and unrounded
preset-two-sides-line = Bresenham moves both ends and draws both. By the diamond-exit rule nothing moves, and the last pixel is not drawn.

preset-diamond-unrounded-name = Unrounded ends
preset-diamond-unrounded = The pixel where the line starts is drawn, because the line leaves its diamond. The one where it ends is not.

preset-diamond-starts-beyond-name = Starts between diamonds
preset-diamond-starts-beyond = The start is in pixel (2, 2), but right of its diamond: the line never leaves it, so the pixel is not drawn.

preset-diamond-ends-before-name = Ends before a diamond
preset-diamond-ends-before = The line reaches the last column but ends before the diamond there. The pixel before is the last one.

preset-diamond-steep-name = A steep line
preset-diamond-steep = A steep line is walked row by row, and the right corner of a diamond belongs to it.

preset-diamond-along-edges-name = Along the edges of diamonds
preset-diamond-along-edges = The line runs along lower left edges. They belong to the diamonds, the upper right ones do not: one pixel a column.

preset-diamond-inside-name = Inside one diamond
preset-diamond-inside = The line starts and ends in one diamond, so it leaves none: a short line can draw nothing.

preset-square-one-name = Size 1
preset-square-one = A point of size 1 draws one pixel, wherever it lies: the square is as wide as the centres are apart.

preset-square-between-name = Size 1, on a corner of pixels
preset-square-between = Four pixel centres are the corners of the square. The upper left one is in, the others are out.

preset-square-three-name = Size 3
preset-square-three = Three columns and three rows, or now and then a tie that changes nothing: it is still three.

preset-square-half-name = Smaller than a pixel
preset-square-half = A point of size 0.5 draws a pixel only if it lies near its centre. Moved from there, it vanishes.

preset-square-two-on-centre-name = Size 2, on a centre
preset-square-two-on-centre = All sides run through centres: two columns and two rows, those at the left and the upper side.

preset-square-off-image-name = Over the border of the image
preset-square-off-image = Only the pixels of the image are drawn, though the place of the point lies outside.

preset-depth-two-triangles-name = B over A: smaller depth wins
preset-depth-two-triangles = A and B overlap, and neither is nearer everywhere. Each pixel compares two codes.

preset-depth-equal-name = Equal depth
preset-depth-equal = Both triangles have depth 0.5 everywhere. Less is false for equal codes, so the first one stays.

preset-depth-through-name = Through each other
preset-depth-through = One triangle falls to the right, the other rises. They change places where their depths are equal.

preset-depth-behind-name = Wholly behind
preset-depth-behind = B lies behind A. Where they overlap every test fails, and nothing is written.

preset-depth-order-name = The same, drawn back to front
preset-depth-order = These are the triangles of the example before, in the other order. The image is the same, but more is written.

preset-depth-less-or-equal-name = Equal depths: less, less-equal
preset-depth-less-or-equal = Left equal codes fail and the first triangle stays. Right they pass and the last one wins.

preset-depth-reversed-codes-name = Reversed
preset-depth-reversed-codes = The same two triangles with near at 1: the buffer is cleared to 0 and the greater depth wins. The image is the same.

preset-depth-not-written-name = Test without write
preset-depth-not-written = Fragments that pass store no depth, so B is drawn over A although it lies behind.

preset-depth-equal-codes-name = Equal codes
preset-depth-equal-codes = B lies nearer than A everywhere, by half a step. Diamonds mark where rounding made their codes equal.

preset-depth-bias-decal-name = Decal with and without bias
preset-depth-bias-decal = B lies in the plane of A. Right they fight, as the last bits of two sums decide; left a bias of two steps and one slope lifts B off its wall.

preset-depth-bias-too-much-name = Too much bias
preset-depth-bias-too-much = B stands in front of the wall A, and C is a decal on the wall. So large a bias lifts C not only off the wall, but through B, too.

preset-depth-bias-slope-name = Stripes of a steep surface
preset-depth-bias-slope = A to H are what a light saw, in steps two pixels wide; I and J are the surface itself. Half its pixels lie behind their own step. A bias by the slope cures that on any slope; a constant does not.

preset-depth-unclipped-name = In front of the near plane
preset-depth-unclipped = A reaches from in front of the near plane to behind it and is cut there. B does the same without clipping: what is too near is drawn at depth 0.

preset-scissor-name = Scissor rectangle
preset-scissor = B may draw to columns 3 to 8 and rows 2 to 6 only. Other fragments of it end before every test.

preset-alpha-leaf-name = Leaf with a hole, early z
preset-alpha-leaf = Alpha falls to 0 at the middle of the leaf B, C, D, and what is below one half is discarded. Where A is nearer, early z never asks for alpha. The hole shows E: a discarded fragment has stored no depth.

preset-alpha-leaf-late-name = Early z against late z
preset-alpha-leaf-late = Left the depth test comes first and is written after the alpha test; right every fragment is asked for its alpha first. The image is the same, the work is not.

preset-alpha-no-early-name = No early z
preset-alpha-no-early = B counts in the stencil where it fails in depth, and its alpha discards a part. A discarded fragment must not count, so nothing may be tested before its alpha is known.

preset-precision-16-bits-name = 16 bits, 0.1 to 1000
preset-precision-16-bits = Most codes lie near the eye. Eight units away a centimetre is less than one code.

preset-precision-24-bits-name = 24 bits, 0.1 to 1000
preset-precision-24-bits = With 256 times as many codes planes merge 16 times farther away: the step grows with the square of the distance.

preset-precision-near-plane-name = Near plane moved to 1
preset-precision-near-plane = The near plane moved from 0.1 to 1. That gains as much as three more bits; moving the far plane gains next to nothing.

preset-precision-floats-name = 32-bit floats
preset-precision-floats = Floats are finest near 0, and perspective puts nearly everything near 1. So they gain next to nothing over 24 bits.

preset-precision-reversed-floats-name = Reversed floats
preset-precision-reversed-floats = Right the far plane has depth 0, where floats are finest. That cancels the perspective: the step stays a fixed part of the distance.

preset-precision-orthographic-name = Orthographic
preset-precision-orthographic = Without perspective depth is linear in distance: every code of a unorm format is equally long.

preset-blend-over-name = Over
preset-blend-over = Two half transparent layers over white. Each takes half of what is there and adds half of itself.

preset-blend-alpha-factors-name = Alpha: 0.7 or 0.45
preset-blend-alpha-factors = A layer of alpha 0.5 over alpha 0.4. By the formula the result is 0.7; with the colour's factors for alpha too it is 0.45.

preset-blend-two-orders-name = Two layers, two orders
preset-blend-two-orders = The same two layers. The one that is blended last counts twice as much as the other.

preset-blend-three-orders-name = Three layers, two orders
preset-blend-three-orders = Of three layers of alpha 0.5 the last counts four times as much as the first.

preset-blend-list-name = A list for each pixel
preset-blend-list = Left the layers are blended as they come, the nearest first: wrong. Right they are kept, sorted by depth, and blended from the farthest on.

preset-blend-constant-name = Fading by a constant
preset-blend-constant = Source times a constant, destination times the rest: one picture fades into another, whatever their alphas are. Here a quarter of the way.

preset-blend-premultiplied-name = Premultiplied
preset-blend-premultiplied = The colours are multiplied by their alpha already, so the source's factor is 1. A layer of alpha 0 can still add light.

preset-blend-additive-name = Additive
preset-blend-additive = Light on light: nothing of what is there is taken away. What exceeds 1 is clamped, and there the order begins to matter.

preset-blend-multiply-name = Multiply
preset-blend-multiply = Each layer is a filter. Products do not depend on the order, but every store rounds.

preset-blend-min-name = Darkest
preset-blend-min = Each channel keeps the lesser of the two values. The factors do not count, and neither does the order.

preset-blend-max-name = Lightest
preset-blend-max = Each channel keeps the greater of the two values, whatever the alpha.

preset-vertex-perspective-name = Perspective
preset-vertex-perspective = One corner of A goes through every space, from the model to the pixel. Its w is its distance along the line of sight.

preset-vertex-orthographic-name = Orthographic
preset-vertex-orthographic = Without perspective w stays 1. The division changes nothing, and depth is linear.

preset-vertex-behind-the-eye-name = Behind the eye: w < 0
preset-vertex-behind-the-eye = This corner lies behind the eye. After the division it would stand on the wrong side, so it must be clipped before.

preset-vertex-minus-one-to-one-name = Depth from −1 to 1
preset-vertex-minus-one-to-one = The first corner lies on the near plane and the second on the far plane. Their depths are exactly −1 and 1.

preset-vertex-rotated-model-name = Rotated model
preset-vertex-rotated-model = A corner of the cube is scaled, rotated and moved before the camera sees it. The order of the three matters.

preset-two-sides-tie-name = Split: tie rules
preset-two-sides-tie = Left the top-left rule, right inclusive edges. Inclusive draws the shared diagonal twice, and a row and a column more.

preset-two-sides-depth-bits-name = Split: 16 bits of depth
preset-two-sides-depth-bits = The same two triangles with 32-bit floats and with 16-bit codes. B is nearer everywhere, yet with 16 bits A shows in stripes.

preset-two-sides-corner-name = Split: two algorithms
preset-two-sides-corner = Beside a corner both reject. Cohen-Sutherland divides once to find out; Liang-Barsky compares fractions and divides not at all.

preset-two-sides-rounding-name = Split: rounding at a corner
preset-two-sides-rounding = Exactly, the line misses the corner by less than a millionth and is rejected. In f32 it touches the corner and is kept.

preset-two-sides-depth-range-name = Split: depth ranges
preset-two-sides-depth-range = One vertex with depths 0 … 1 and −1 … 1. Clip space and NDC differ in z alone; on the screen both have the same depth.

preset-clip-behind-and-right-name = Behind, and to the right
preset-clip-behind-and-right = v1 lies behind the eye, v2 to the right. Two planes cut: near is not the first, yet the result is right.

preset-clip-one-in-name = One in, two out
preset-clip-one-in = One vertex is inside the right plane: two crossings, and a triangle is left.

preset-clip-two-in-name = Two in, one out
preset-clip-two-in = Two vertices are inside the right plane: two crossings, and a polygon of four corners is left. It needs two triangles.

preset-clip-near-plane-name = Through the near plane
preset-clip-near-plane = The nearest vertex is before the near plane, and still before the eye. Only the near plane cuts.

preset-clip-divide-first-name = Mistake: divide first
preset-clip-divide-first = v1 lies behind the eye. Divided by its negative w it comes out mirrored, and another triangle is clipped.

preset-clip-w-zero-name = w = 0
preset-clip-w-zero = v1 lies in the plane of the eye: its w is 0, and no division could place it. Clipping before the divide needs none.

preset-clip-no-near-name = Mistake: no near plane
preset-clip-no-near = The part between the near plane and the eye stays. After the divide its depths are outside 0 … 1.

preset-clip-frustum-corner-name = An edge of the frustum
preset-clip-frustum-corner = Two vertices are outside, each beyond another plane, and the edge between right and top pierces the triangle. That corner is made by the triangle and two planes.

preset-clip-guard-band-name = Guard band keeps it
preset-clip-guard-band = The right plane stands four times as far out: the triangle reaches over the side of the image, and nothing is cut. The rasterizer does the rest.

preset-clip-crack-name = Mistake: crack at an edge
preset-clip-crack = In f32, each triangle computes the crossing from the end that it meets first. At the shared edge two results differ in the last place: a crack.

preset-clip-no-attributes-name = Mistake: no attributes
preset-clip-no-attributes = The new corners get a position but no u. The texture is right up to the cut and wrong beyond it.

preset-clip-camera-space-name = In camera space
preset-clip-camera-space = The same cut with points and normals: distances are (v − p) · n, and there is no fourth number.

preset-clip-many-planes-name = Five planes cut
preset-clip-many-planes = A large triangle reaches over all sides and the far plane. Seven corners are left, and five triangles.

preset-plane-two-in-name = Two in, one out
preset-plane-two-in = v1 is outside. The quadrangle that is left needs two triangles.

preset-plane-one-in-name = One in, two out
preset-plane-one-in = The same triangle and plane, but the normal points the other way: now one triangle is left.

preset-plane-three-in-name = All in
preset-plane-three-in = All three distances are positive: the triangle stays bit for bit, and nothing is divided.

preset-plane-none-in-name = None in
preset-plane-none-in = All three distances are negative: nothing is left, and nothing is divided.

preset-plane-vertex-on-it-name = A vertex on the plane
preset-plane-vertex-on-it = v2 lies on the plane, which counts as inside. One crossing is v2 again, and one of both triangles has no area.

preset-plane-slanted-name = Slanted, in f32
preset-plane-slanted = The plane is slanted and n is not of unit length: distances are multiples of that length, and t does not care. In f32 the new vertices miss the plane by a little.

preset-plane-near-name = The near plane
preset-plane-near = In camera space the near plane at distance 1 has p = (0, 0, −1) and n = (0, 0, −1). v0 is too near to the eye.
preset-facing-front-name = Seen from the front
preset-facing-front = All six tests see the front. Swap two vertices: then all six see the back.

preset-facing-closed-surface-name = Closed surface: about half
preset-facing-closed-surface = Of a closed surface the eye sees the front of about half of the triangles. Culling the others leaves half of the work.

preset-facing-mirrored-name = Mirrored model
preset-facing-mirrored = A scale of −1 turns every triangle round on its way. The test in object space comes too early to see that.

preset-facing-behind-the-eye-name = One vertex behind the eye
preset-facing-behind-the-eye = The divide mirrors what lies behind the eye. So the tests after the divide see the wrong side, and only they do.

preset-facing-edge-on-name = Exactly edge-on
preset-facing-edge-on = All six values are exactly 0. Some lectures call that a back, some a front; nothing is drawn either way.

preset-facing-collinear-name = No area at all
preset-facing-collinear = The three vertices lie on one line. All tests give 0, and the reason has a name.

preset-facing-rounded-name = Rounded to the other side
preset-facing-rounded = Nearly edge-on: in binary32 the determinant itself sees the wrong side. In exact arithmetic only what was rounded on the way differs.

preset-frustum-beside-name = Beside and behind
preset-frustum-beside = B stands beside the frustum and C behind the eye. One plane each is enough to leave out all of their triangles.

preset-frustum-straddles-name = A box across a plane
preset-frustum-straddles = The box reaches to both sides of the right plane. So its triangles are tested one by one, and some fall.

preset-frustum-long-object-name = Long object: sphere too large
preset-frustum-long-object = The sphere around a long object reaches into the frustum. The box does not: choose it and A is culled.

preset-frustum-corner-name = Outside of no single plane
preset-frustum-corner = A stands beside an edge of the frustum. No plane has all of it outside, so it is kept, and the clipper finds nothing.

preset-frustum-all-inside-name = All inside
preset-frustum-all-inside = Both spheres lie inside all six planes. None of nearly two thousand triangles needs a test or a cut.

preset-frustum-behind-the-eye-name = Too near and too far
preset-frustum-behind-the-eye = One ball is behind the eye and one reaches through the far plane. Depth culls like any other direction.

preset-tree-of-eight-name = Eight objects
preset-tree-of-eight = Objects that stand together fall together: one node stands for all four at the right.

preset-tree-of-a-hundred-name = A hundred objects
preset-tree-of-a-hundred = A camera sees a part of a field. The tree accepts and rejects whole regions of it.

preset-tree-of-clusters-name = Clusters, by surface area
preset-tree-of-clusters = Where objects stand in clusters, splitting by surface area puts each cluster into a node. Compare with the median.

preset-tree-of-triangles-name = Triangles of one model
preset-tree-of-triangles = A ball crosses the right plane. A tree of its triangles finds the part outside without testing each.

preset-tree-all-outside-name = Everything outside
preset-tree-all-outside = All objects stand to the right. The root alone is tested, and the picture is empty.

preset-tree-all-inside-name = Everything inside
preset-tree-all-inside = The root lies inside all planes: six tests for all objects.

preset-two-sides-mistake-name = Split: a mistake
preset-two-sides-mistake = Left all four sides cut; right only the left and the bottom one, as beginners often leave it. What sticks out is outlined.

preset-weigh-inside-name = A point inside
preset-weigh-inside = The farther vertex V1 has the larger w, so it counts for less than its area says. Perspective: one division at the point.

preset-weigh-centroid-name = The centroid
preset-weigh-centroid = At the centroid all three areas are equal: each vertex weighs a third, and no binary number is a third.

preset-weigh-on-an-edge-name = On an edge
preset-weigh-on-an-edge = P lies on the edge V0V1, so V2 weighs 0: what is across an edge does not depend on the third vertex, and neighbours meet.

preset-weigh-outside-name = A point outside
preset-weigh-outside = One of the areas has the other sign: so an area also tells where P is. There is no value, unless one extrapolates.

preset-weigh-equal-w-name = All w are equal
preset-weigh-equal-w = A triangle that faces the eye has one w: then w cancels, and affine and perspective are the same.

preset-weigh-sliver-name = A sliver in f32
preset-weigh-sliver = The area of a sliver is the small difference of two large products: f32 is wrong by many steps where the exact value is rounded once.

preset-weigh-zero-area-name = No area
preset-weigh-zero-area = All three vertices lie on one line: there is no inside, and nothing can be weighed.

preset-row-depth-name = Depth along a row
preset-row-depth = Depth is a plane over the screen: one value at the first centre, then one addition a pixel.

preset-row-drift-name = Additions in f32
preset-row-drift = Each addition rounds, and the next pixel starts from the rounded sum: the error grows along the row. Exact beside it.

preset-row-perspective-name = Two planes and a division
preset-row-perspective = In perspective the attribute is no plane over the screen, but a/w and 1/w are: two additions and one division a pixel.

preset-row-constant-name = Equal values
preset-row-constant = All three vertices have the same value: A and B are 0, and nothing is added. In f32 a/w over 1/w may still miss it.

preset-row-sliver-name = A sliver in f32
preset-row-sliver = C is twice the area. In a sliver it is a small difference of large products, and both slopes are divided by it.

preset-row-empty-name = A row without pixels
preset-row-empty = The needle passes between two rows of centres: there is nothing to fill in, and nothing is computed.

preset-tilt-floor-name = A floor
preset-tilt-floor = The near half fills most of the image. Affine gives both halves the same room: the squares bend along the diagonal.

preset-tilt-facing-name = Facing the eye
preset-tilt-facing = All corners have the same w: it cancels, and both ways give the same bits. No division is needed.

preset-tilt-wall-name = A wall
preset-tilt-wall = Turned about the upright axis: across the wall u needs the division, up the wall v does not, but for the diagonal.

preset-tilt-steep-name = Nearly edge-on
preset-tilt-steep = From w = 1.25 to 9: affine is off by several squares, and the two triangles no longer fit together.

preset-tilt-one-square-name = Where the triangles meet
preset-tilt-one-square = Two squares a side, affine: each triangle is right at its own corners, and the middle lies where the diagonals of the image do not cross.

preset-tilt-depth-is-straight-name = Must z be corrected, too?
preset-tilt-depth-is-straight = A learner's question. Device z has been divided by w already, so it changes evenly on the screen; dividing once more bends it.

preset-tilt-level-line-name = A level line
preset-tilt-level-line = Along a line at one distance z, 1/w and d are constant: there affine is right. That is why old games drew floors row by row.

preset-samples-edge-name = An edge in steps
preset-samples-edge = The slanted edge passes through the samples one by one: pixels along it get 0, 1, 2, 3 or 4 quarters of white.

preset-samples-sliver-name = A sliver between centres
preset-samples-sliver = No centre lies in the sliver: with one sample it is not there at all, and with four it is a grey line.

preset-samples-centroid-name = Shaded outside the triangle
preset-samples-centroid = The shade grows from 0 to 1 inside. At a centre outside it is extrapolated: too dark or too light pixels along the edges. Centroid shades inside.

preset-samples-shared-edge-name = A shared edge
preset-samples-shared-edge = Both triangles are white and share an edge: each sample belongs to exactly one, so the seam is 255 throughout.

preset-samples-silhouette-name = A silhouette with 8
preset-samples-silhouette = Eight samples give nine levels of grey; no two stand in one row or column, so flat and steep edges are equally smooth. One sample beside it.

preset-samples-per-sample-name = Every sample shaded
preset-samples-per-sample = Inside the triangle the shade changes faster than pixels do: one shade a pixel is one point of it, per sample is a mean, at four times the cost.

preset-samples-on-an-edge-name = Samples on an edge
preset-samples-on-an-edge = The left edge passes exactly through samples: the tie rule decides for samples as it does for centres.

preset-stress-nearly-parallel-name = Nearly parallel lines
preset-stress-nearly-parallel = Lines nearly along a border that pass a corner of the window by less than binary32 can tell. Rounding decides whether they are drawn, and half of the cases come out wrong.

preset-stress-beside-name = One step beside a centre
preset-stress-beside = Vertices on pixel centres, or one step of binary32 beside them. The tie rule decides there, and rounding breaks ties: binary32 gets pixels wrong, binary64 and exact none.

preset-stress-huge-name = Huge triangles
preset-stress-huge = Two vertices lie so far away that the image is a point to them. No product of such numbers keeps a digit of a pixel. Turn the dial on, and binary64 breaks as well.

preset-stress-denormal-name = Below the smallest normal number
preset-stress-denormal = A side misses the centres of a diagonal by a number below the smallest normal one. Beside a coordinate of 10 no sum keeps such a number, so only exact signs see which side they lie on.

preset-stress-sliver-name = A sliver, made small
preset-stress-sliver = The triangle has nearly no area, and dividing by it multiplies every rounding. The first case that breaks is made small, number by number.

preset-stress-near-w-zero-name = w near 0
preset-stress-near-w-zero = One vertex lies just before the eye and one just behind it. What they say of 1/w nearly cancels, and what is left is rounding.

preset-stress-long-name = Sums along a row
preset-stress-long = The plane equation adds one slope a pixel. The depth falls to nearly nothing along the row, but the roundings of the large sums stay: the curve shows how they grow.

preset-stress-frustum-edge-name = Along an edge of the frustum
preset-stress-frustum-edge = A side of the triangle lies along an edge of the frustum, but for next to nothing. Each plane cuts what the planes before it have rounded, so binary32 keeps corners that are not there.

preset-light-highlight-name = In the highlight
preset-light-highlight = The mirrored light goes nearly to the eye, so the specular term is nearly all of ks. Drag E, and it falls quickly.

preset-light-behind-name = A light behind the surface
preset-light-behind = n·l is below 0: without the test the diffuse term would take light away, and a highlight would shine through.

preset-light-grazing-name = Grazing light
preset-light-grazing = Flat light and a flat view: n·h changes half as fast as r·v, so Blinn's highlight is the larger one. Both side by side.

preset-light-fades-name = A light that fades
preset-light-fades = At the distance 2 only 1 / (1 + 0.5 + 1) of the light is left. The ambient term does not fade.

preset-light-leaning-normal-name = Normals by the model matrix
preset-light-leaning-normal = The surface is squeezed to a quarter of its height. The normal must go the other way: by the inverse transpose, as on the right.

preset-light-both-sides-name = Both sides
preset-light-both-sides = Seen from behind, a surface with one lit side is dark. Lit on both sides, its normal is turned to the eye.

preset-light-too-bright-name = More than white
preset-light-too-bright = The terms add up to more than 1, and all of that is white: the highlight has no shape any more.

preset-light-small-highlight-name = A small highlight
preset-light-small-highlight = The eye is 4° beside the mirrored light. With the exponent 128 that costs a third of the highlight, with 8 next to nothing.

preset-shade-lost-highlight-name = A highlight between vertices
preset-shade-lost-highlight = The highlight lies in the middle, where no vertex is. Lit at the vertices it is lost; lit at each pixel it is there.

preset-shade-mach-band-name = A band along an edge
preset-shade-mach-band = Gouraud's brightness grows along straight lines and turns back at the shared edge: the eye sees a bright band there. Phong's is round.

preset-shade-facets-name = Facets
preset-shade-facets = Flat: one factor for each face, and every edge is seen. Gouraud, beside it, takes the mean normal at each vertex.

preset-shade-too-short-name = Normals too short
preset-shade-too-short = Between the vertices an interpolated normal is shorter than 1. Used as it is, the middle is too dark and the highlight is gone.

preset-shade-leaning-normals-name = The wrong matrix
preset-shade-leaning-normals = The object is flattened. Its normals by the model matrix lean outwards, and the top, which faces the light, is too dark.

preset-shade-all-varyings-name = All varyings
preset-shade-all-varyings = Place, normal, colour and texture coordinates: each has a number at the vertices, and one that is interpolated in each pixel.

preset-shade-hidden-name = Hidden, so not lit
preset-shade-hidden = A is nearer and comes first. Where it hides B, the depth test fails and no light is computed for B at all.

preset-lit-spheres-name = Three kinds of shading
preset-lit-spheres = One sphere of 320 triangles, lit once for each face, at its vertices, and at each pixel.

preset-lit-pawn-name = A pawn and two lights
preset-lit-pawn = Lit at each pixel. The model has no normals: each vertex gets the mean of its faces, by area. A click on a pixel shows its terms.
