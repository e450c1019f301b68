# Words of figures: what a drawing says by itself, whatever the lab.

figure-undefined = not defined yet
figure-nan = an operation without a defined result
figure-infinity = beyond the largest finite number
figure-values-hidden = { $cells ->
    [one] One value is hidden
   *[other] { $cells } values are hidden
}: they show from { $size } px cells on. Zoom { $zoom }× more.

figure-dark = Dark
figure-light = Light
figure-projector = Projector

figure-film-too-fine = An animated picture has at most { $most } frames; this one would have { $frames }. Choose larger steps.
figure-film-too-long = An animated picture has at most { $most } frames; even with the largest steps this one would have { $frames }. Choose a smaller scene.

# What lies on an image

figure-overlay-depth = stored depth; the nearer, the stronger
figure-overlay-no-depth = No depth was written: every pixel holds the clear value.
figure-overlay-stencil = stencil value; faint as cleared
figure-overlay-no-stencil = No stencil value was written: every pixel holds the clear value.
figure-overlay-generated = fragments that the pixel got
figure-overlay-written = fragments that were written to the pixel
figure-overlay-no-fragment = No pixel got a fragment.
figure-overlay-equal = fragments with the code stored there
figure-overlay-no-equal = No fragment had the depth code that was stored.
figure-overlay-wires = { $edges ->
    [one] one edge of the triangles on the screen
   *[other] { $edges } edges of the triangles on the screen
}
figure-overlay-wired = pixels with an edge; too many edges for lines
figure-overlay-no-edit = Nothing was edited yet. Switch something: the pixels that change are outlined.
figure-overlay-unchanged = No pixel differs from before the last edit: colour, depth and stencil are equal.
figure-overlay-changed = { $count ->
    [one] One pixel differs from before the last edit
   *[other] { $count } pixels differ from before the last edit
}: { $color } in colour, { $depth } in depth, { $stencil } in stencil
