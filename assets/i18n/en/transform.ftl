# The transform chain. What stands between two ** is bold; $axis is x, y, z or w.

transform = Transform chain
transform-about = A vertex goes from object space to the screen: three matrices, one division, one viewport.
transform-opening = { $count ->
    [one] One vertex starts
   *[other] { $count } vertices start
} in object space.
transform-vertex = **{ $vertex }** is { $at } in object space. It gets **w = 1**, so that a matrix can also move it.
transform-matrix-world = **W**, the model matrix, puts { $vertex } where its object stands in the world.
transform-matrix-view = **C⁻¹**, the view matrix, moves { $vertex } with the whole world, so that the eye is at the origin.
transform-matrix-clip = **P**, the projection matrix, takes { $vertex } to clip space. There w tells how far away it is.
transform-component = The row of { $axis } in { $matrix }, times the vector, is **{ $value }**.
transform-reached = In { $space }, **{ $vertex }** is { $at }.
transform-in-front = w is **{ $w }**, the distance along the line of sight. It is more than 0, so { $vertex } lies in front of the eye.
transform-parallel = w is **{ $w }**: the lines of sight are parallel, so the division changes nothing.
transform-behind = w is **{ $w }**, less than 0: { $vertex } lies **behind the eye**. The division would turn it to the wrong side, so it must be clipped before.
transform-no-image = w is **0**: { $vertex } lies in the plane of the eye. Nothing can be divided by 0, so it has **no image**.
transform-divide = Divided by w, what is farther away gets nearer to the middle: { $axis }″ is **{ $value }**.
transform-divide-depth = Depth is divided by w too: z″ is **{ $value }**.
transform-divide-behind = w is negative, so the division turns the sign round: { $axis }″ is { $value }. This is **no image**.
transform-divide-zero = Nothing can be divided by 0: the { $axis } of NDC is set to 0.
transform-reciprocal = 1/w is **{ $value }**. It takes the place of w, because attributes are interpolated with it.
transform-viewport-x = From −1 … 1 to 0 … { $size } pixels: x‴ is **{ $value }**.
transform-viewport-down = From 1 … −1 to 0 … { $size } pixels, for y goes down on the screen: y‴ is **{ $value }**.
transform-viewport-up = From −1 … 1 to 0 … { $size } pixels: y‴ is **{ $value }**.
transform-viewport-depth = Depth stays as it is: z‴ is **{ $value }**.
transform-viewport-depth-stretched = From −1 … 1 to 0 … 1: z‴ is **{ $value }**.
transform-reciprocal-stays = 1/w stays **{ $value }**.
transform-on-screen = On the screen **{ $vertex }** is at { $at } in pixels, with depth { $depth }.
transform-off-screen = **{ $vertex }** would be at { $at } with depth { $depth }. That is outside the visible box, so it must be clipped.
transform-no-screen = { $at } is **no image** of { $vertex }, because w is not more than 0.
transform-done = { $count ->
    [one] The vertex has
   *[other] All { $count } vertices have
} gone through every space.

transform-eye = eye
transform-from-the-side = from the side
transform-depth-against-distance = depth against distance
transform-other-axis = the same for y
transform-marker-behind = behind

transform-space-object = object space
transform-space-world = world space
transform-space-view = camera space
transform-space-clip = clip space
transform-space-ndc = NDC
transform-space-screen = screen space

transform-spaces = Spaces
transform-table-world = W times v: object to world
transform-table-view = C⁻¹ times W v: world to camera
transform-table-clip = P times C⁻¹ W v: camera to clip
transform-table-divide = Divided by w: clip to NDC
transform-table-viewport = D: NDC to screen

column-space = space
column-w-or-r = w, 1/w
