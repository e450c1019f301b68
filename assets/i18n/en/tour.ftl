# The tour: one page through all stages

tour-title = Rasterscope: a tour through the pipeline
tour-facts = { $width } × { $height } pixels, { $draws ->
    [one] one object
   *[other] { $draws } objects
}, { $triangles ->
    [one] one triangle
   *[other] { $triangles } triangles
}.
tour-footer = Made by "rasterscope tour". All numbers are those of the engine that drew the image.
tour-progress = Tour: stage { $number } of { $all }, { $stage }
tour-off = off

tour-triangles = { $count ->
    [one] 1 triangle
   *[other] { $count } triangles
}
tour-vertices = { $count ->
    [one] 1 vertex
   *[other] { $count } vertices
}
tour-spans = { $count ->
    [one] 1 span of pixels
   *[other] { $count } spans of pixels
}
tour-fragments = { $count ->
    [one] 1 fragment
   *[other] { $count } fragments
}
tour-pixels = { $count ->
    [one] 1 pixel
   *[other] { $count } pixels
}
tour-came = In: { $counted }
tour-went = Out: { $counted }
tour-dropped = Dropped: { $count } { $reason }
tour-more-rows = … and { $rows } more.

tour-about-scene = The scene lists its objects in drawing order, and says from where it is seen.
tour-about-model = The model matrix puts each object into the world. A vertex is a column; w is 1.
tour-about-view = The view matrix moves the world so that the eye is at the origin and looks along −z.
tour-about-clip-space = The projection makes w the distance from the eye. Visible is what lies between −w and w.
tour-about-cull = Triangles that turn their back, have no area, or lie outside one plane need no further work.
tour-about-clip = What sticks out of the visible part is cut off, before any division. New corners keep exact places.
tour-about-divide = Dividing by w brings the visible part into the square from −1 to 1. 1/w is kept for the attributes.
tour-about-viewport = The square becomes the image. Vertices are never rounded to pixels.
tour-about-scan-conversion = A pixel is covered if its centre lies inside the triangle. Of two neighbours exactly one draws a shared edge.
tour-about-fragments = Each covered pixel gives a fragment with colour and depth. A pixel can get several.
tour-about-stencil = A fragment goes on only if the stencil value of its pixel allows it.
tour-about-depth = A fragment goes on only if it is nearer than what the pixel holds.
tour-about-blend = A fragment that passed replaces the stored colour, or is mixed with it.
tour-about-image = What is stored at the end is the image: four 8-bit codes a pixel.

tour-off-scene = The scene draws nothing.
tour-off-model = There is no object.
tour-off-view = There is no vertex.
tour-off-clip-space = There is no vertex.
tour-off-cull = There is no triangle.
tour-off-clip = There is no triangle.
tour-off-divide = There is no corner.
tour-off-viewport = There is no corner.
tour-off-scan-conversion = No triangle reached the screen.
tour-off-fragments = No pixel is covered.
tour-off-stencil = Off: no object of this scene tests the stencil.
tour-off-depth = Off: no object of this scene tests the depth.
tour-off-blend = Off: every fragment that passes replaces the colour.
tour-off-image = Nothing was drawn: the image holds the clear colour.

tour-picture-scene = The scene from outside, with the eye and the part that it sees.
tour-picture-model = The objects in world space, with its three axes.
tour-picture-view = Camera space from the side: the line of sight runs to the right.
tour-picture-clip-space = Clip space: x to the right, w upwards. Between the two lines is what fits the image's width.
tour-picture-cull = The scene from outside: what is dropped wears the colour of removed things.
tour-picture-clip = The scene from outside: what was cut off wears the colour of removed things.
tour-picture-divide = Normalised device coordinates from the front.
tour-picture-viewport = The triangles in pixels.
tour-picture-scan-conversion = The pixels whose centre is covered, in the colour of the last triangle.
tour-picture-fragments = How many fragments each pixel got.
tour-picture-stencil = The stencil value of each pixel.
tour-picture-depth = The stored depth of each pixel.
tour-picture-blend = The colours after blending.
tour-picture-image = The image.

tour-table-draws = Objects
tour-table-model-matrix = Model matrix
tour-table-world = World space
tour-table-view-matrix = View matrix
tour-table-view = Camera space
tour-table-projection-matrix = Projection matrix
tour-table-clip = Clip space
tour-table-triangles = Triangles
tour-table-polygons = Clipped polygons
tour-table-ndc = After the division
tour-table-screen = On the screen
tour-table-coverage = Covered pixels
tour-table-fragments = Fragments of a pixel
tour-table-stencil = Stencil values
tour-table-depth = Nearest and farthest
tour-table-depth-pixels = Drawn and clear
tour-table-blend = How colours are mixed
tour-table-skipped = Work left out, the image being the same
tour-table-decisions = Decisions, and those that needed exact arithmetic

column-vertices = vertices
column-triangles = triangles
column-cull = cull
column-facing = facing
column-fate = result
column-corners = corners
column-cut = cut
column-first-row = first row
column-rows = rows
column-color = colour
column-alpha = alpha
column-count = count

tour-cull-none = none
tour-cull-back = back
tour-cull-front = front
tour-facing-front = front
tour-facing-back = back
tour-facing-degenerate = no area
tour-fate-kept = kept
tour-fate-dropped = dropped
tour-yes = yes
tour-no = no
tour-replaces = replaces

tour-step = Step { $step }
tour-steps = { $shown } of { $all } steps, and the start before them.
