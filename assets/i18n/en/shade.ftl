# Light on a surface, for the labs that compute it. What stands between two ** is bold.

shade-opening = How bright is P? The light, the eye and the normal decide.
shade-turned = The normal in world space is **{ $normal }**: N times the inverse transpose of the model matrix.
shade-turned-mistaken = **Wrong:** N went through the model matrix itself. { $normal } need not stand upright on the surface.
shade-unit-normal = n = **{ $unit }**: the normal, of length 1.
shade-unit-eye = v = **{ $unit }**: from P to the eye, of length 1.
shade-unit-light = l = **{ $unit }**: from P to the light, of length 1.
shade-as-it-is = **Wrong:** the interpolated normal { $normal } is used as it is, with a length of only **{ $length }**.
shade-no-normal = The normal has length 0, so it has **no direction**: only the ambient term is left.
shade-no-eye = The eye is at P itself: it has **no direction**, and there is no highlight.
shade-no-light = The light is at P itself: it has **no direction**, and lights nothing.
shade-flipped = n points away from the eye, and both sides are lit: n is **turned around** to { $unit }.
shade-ambient = The ambient term is **{ $value }**: light from everywhere, the same for every direction.
shade-fade = The light is { $distance } away, so **{ $factor }** of its intensity comes here.
shade-incidence = n·l = **{ $cosine }**: the light comes in at { $degrees }° to the normal.
shade-behind = n·l is not above 0: the light is **behind the surface**. It adds nothing.
shade-diffuse = The diffuse term is **{ $value }**: the flatter the light falls in, the less.
shade-mirrored = r = **{ $r }**: the light mirrored at the normal.
shade-halfway = h = **{ $h }**: halfway between the light and the eye.
shade-highlight-phong = r·v = **{ $cosine }**: the eye is { $degrees }° beside the mirrored light.
shade-highlight-blinn = n·h = **{ $cosine }**: h is { $degrees }° beside the normal.
shade-highlight-none = The mirrored light goes away from the eye: there is **no highlight**.
shade-power = To the power of { $exponent } it is **{ $value }**: a larger exponent makes a smaller highlight.
shade-specular = The specular term is **{ $value }**.
shade-sum = The three terms add up: **I = { $value }**.
shade-sum-clamped = The three terms add up to { $sum }, more than white: **I = { $value }**.
shade-marker-vectors = vectors
shade-marker-ambient = ambient
shade-marker-behind = behind
shade-marker-diffuse = diffuse
shade-marker-specular = specular
shade-marker-sum = sum
shade-key-outgoing = how bright it is seen from there; the circle is white
shade-unit-points = { $count ->
    [one] point
   *[other] points
}
shade-terms = The terms
shade-vectors = The vectors
shade-numbers = On the way
row-shade-ambient = ambient
row-shade-diffuse = diffuse
row-shade-specular = specular
word-model-phong = Phong, r·v
word-model-blinn-phong = Blinn-Phong, n·h
word-one-side-lit = one
word-both-sides-lit = both
mistake-model-normals = normals by the model matrix
mistake-model-normals-effect = under uneven scale the normal leans, and the light with it
mistake-not-renormalised = interpolated normals used as they are
mistake-not-renormalised-effect = they are too short between the vertices, and the middle is too dark
word-shade-none = none
word-shade-flat = flat
word-shade-gouraud = Gouraud
word-shade-phong = Phong
word-shade-scene = as each object says
word-model-of-draw = of the material

shade-stages-opening = The vertex stage runs once for each vertex, the fragment stage once for each pixel.
shade-object = Object **{ $name }**: the vertex stage runs for each of its vertices.
shade-vertex = **{ $vertex }** goes through the vertex stage: its clip position, and what is handed on to the pixels.
shade-vertex-lit = { $vertex } is lit here: the colour **{ $color }** is handed on, and only interpolated from now on.
shade-vertex-color = { $vertex } hands on its colour { $color }: it is **not lit yet**.
shade-triangle = Triangle { $number } of **{ $name }** is on the screen.
shade-face = The whole face is lit once: its factor is **{ $factor }**.
shade-row = Row { $y }: { $count ->
    [one] one pixel
   *[other] { $count } pixels
}.
shade-hidden = Pixel ({ $x }, { $y }): something nearer is there. **No fragment stage runs.**
shade-fragment = Pixel ({ $x }, { $y }): the fragment stage runs. The varyings are interpolated for it.
shade-varying-place = The place in world space is **{ $value }** here.
shade-varying-normal = The normal is **{ $value }** here, with a length of { $length }.
shade-varying-color = The colour is **{ $value }** here.
shade-varying-uv = The texture coordinates are **{ $value }** here.
shade-output-none = Pixel ({ $x }, { $y }): **{ $value }**, without light; codes { $code }.
shade-output-flat = Pixel ({ $x }, { $y }): **{ $value }**, the face's factor times the colour; codes { $code }.
shade-output-gouraud = Pixel ({ $x }, { $y }): **{ $value }**, between the lit vertices; codes { $code }.
shade-output-phong = Pixel ({ $x }, { $y }): **{ $value }**, lit for this pixel alone; codes { $code }.
shade-done = The triangle is done: { $drawn ->
    [one] one pixel
   *[other] { $drawn } pixels
}.
shade-done-hidden = The triangle is done: { $drawn } drawn, { $hidden } hidden.
shade-pixel-none = Nothing is drawn here so far.
shade-pixel-shown = **{ $name }** shows { $value } here.
shade-marker-vertices = vertices
shade-marker-triangle = triangle
shade-vertex-in = Into the vertex stage
shade-vertex-out = Out of the vertex stage
shade-fragment-in = Into the fragment stage
shade-fragment-out = Out of the fragment stage
shade-counts = So far
column-shade-lights = lights
column-shade-drawn = drawn
column-shade-hidden = hidden
row-shade-position = position
row-shade-normal = normal
row-shade-color = colour
row-shade-uv = u, v
row-shade-clip = clip
row-shade-place = P, world
row-shade-world-normal = N, world
row-shade-lit = lit colour
row-shade-factor = factor
row-shade-value = largest
row-shade-code = codes
row-shade-matte = matte
row-shade-gloss = gloss

