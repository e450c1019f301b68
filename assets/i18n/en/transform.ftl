# The transform chain

transform = Transform chain
transform-about = A vertex goes from object space to the screen: three matrices, one division, one viewport.
transform-opening = { $count ->
    [one] One vertex starts
   *[other] { $count } vertices start
} in object space.
transform-vertex = { $vertex } is { $at } in object space; w = 1 is added.
transform-matrix-world = W, the model matrix, puts { $vertex } into the world.
transform-matrix-view = C⁻¹, the view matrix, moves { $vertex } so that the eye is at the origin.
transform-matrix-clip = P, the projection matrix, takes { $vertex } to clip space.
transform-component = Row { $axis } of the matrix, times the vector, is { $value }.
transform-reached = { $vertex } is { $at } in { $space }.
transform-in-front = w is { $w }, more than 0: { $vertex } lies in front of the eye.
transform-behind = w is { $w }, less than 0: { $vertex } lies behind the eye. What the division gives is not its image.
transform-no-image = w is 0: { $vertex } lies in the plane of the eye and has no image. It is set to 0.
transform-divide = { $axis } divided by w is { $value }.
transform-reciprocal = 1/w is { $value }. It is kept in the place of w.
transform-viewport = On the screen, { $axis } is { $value }.
transform-reciprocal-stays = 1/w stays { $value }.
transform-done = { $count ->
    [one] The vertex is
   *[other] All { $count } vertices are
} on the screen.

transform-marker-behind = behind

transform-space-object = object space
transform-space-world = world space
transform-space-view = camera space
transform-space-clip = clip space
transform-space-ndc = NDC
transform-space-screen = screen space

transform-spaces = Spaces
transform-table-world = W, object to world
transform-table-view = C⁻¹, world to camera
transform-table-clip = P, camera to clip

column-space = space
column-w-or-r = w, 1/w
