# The whole pipeline: counts of the ribbon, history of a pixel

pipeline = Pipeline
pipeline-about = From the scene to the image, stage by stage.

pipeline-reason-object-frustum = in objects outside
pipeline-reason-frustum = outside
pipeline-reason-back-face = back-facing
pipeline-reason-front-face = front-facing
pipeline-reason-degenerate = degenerate
pipeline-reason-clipped = clipped away
pipeline-reason-carried = of culled triangles
pipeline-reason-stencil = masked
pipeline-reason-depth = behind
pipeline-reason-redrawn = redrawn

pipeline-unit-triangles = tri
pipeline-unit-vertices = vtx
pipeline-unit-spans = spans
pipeline-unit-rows = rows
pipeline-unit-fragments = frag
pipeline-unit-values = values
pipeline-unit-shades = shades
pipeline-unit-pixels = px

pipeline-pixel-written = passed
pipeline-pixel-overwritten = passed, drawn over later
pipeline-pixel-blended-over = passed, blended over later
pipeline-pixel-object-outside = its object is outside: { $plane } plane
pipeline-pixel-outside = outside the frustum: { $plane } plane
pipeline-pixel-back-facing = culled: back-facing
pipeline-pixel-front-facing = culled: front-facing
pipeline-pixel-degenerate = degenerate: no area
pipeline-pixel-clipped-away = clipped away
pipeline-pixel-cut-off = clipped by the { $plane } plane
pipeline-pixel-zero-area = no area on the screen
pipeline-pixel-outside-edge = outside an edge
pipeline-pixel-lost-tie = on an edge: the neighbour draws it
pipeline-pixel-stencil = stencil test failed
pipeline-pixel-depth = depth test failed

pipeline-pixel-would-cover = Its edges would contain this centre.
pipeline-pixel-edge-value = { $edge }(centre) = { $value } < 0
pipeline-pixel-on-edge = { $edge }(centre) = 0
pipeline-pixel-determinant = det (x, y, w) = { $value }
pipeline-pixel-stencil-values = stencil: { $reference } & { $mask } { $compare } { $stored } & { $mask }
pipeline-pixel-stencil-compare = stencil: { $compare }
pipeline-pixel-stencil-stored = { $operation }: { $before } → { $after } (mask { $mask })
pipeline-pixel-depth-unwritten = { $new } { $compare } { $stored }, not stored: no depth write
pipeline-pixel-blended = blended: { $before } → { $after }
pipeline-pixel-replaced = colour: { $before } → { $after }
pipeline-pixel-depth-stored = { $new } { $compare } { $stored }, stored
pipeline-pixel-depth-kept = { $new } { $compare } { $stored }, kept
pipeline-pixel-codes = { $new } { $compare } { $stored }

pipeline-pixel-drawn = { $name } drew this pixel.
pipeline-pixel-clear = No triangle drew this pixel: it shows the clear colour.

pipeline-overlay-none = nothing
pipeline-overlay-depth = depth
pipeline-overlay-stencil = stencil
pipeline-overlay-generated = fragments got
pipeline-overlay-written = fragments written
pipeline-overlay-wireframe = wireframe
pipeline-overlay-triangle = triangle at pointer
pipeline-overlay-changed = changed pixels
