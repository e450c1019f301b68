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
pipeline-reason-scissor = outside the scissor
pipeline-reason-discarded = discarded
pipeline-reason-stencil = masked
pipeline-reason-depth = failed
pipeline-reason-redrawn = redrawn

pipeline-unit-triangles = tri
pipeline-unit-vertices = vtx
pipeline-unit-spans = { $count ->
    [one] span
   *[other] spans
}
pipeline-unit-rows = { $count ->
    [one] row
   *[other] rows
}
pipeline-unit-tile-rows = { $count ->
    [one] tile row
   *[other] tile rows
}
pipeline-unit-fragments = frag
pipeline-unit-values = { $count ->
    [one] value
   *[other] values
}
pipeline-unit-shades = { $count ->
    [one] shade
   *[other] shades
}
pipeline-unit-pixels = px

pipeline-pixel-written = passed
pipeline-pixel-overwritten = passed, drawn over later
pipeline-pixel-blended-over = passed, blended over later
pipeline-pixel-object-outside = its object is outside: { $plane } plane
pipeline-pixel-outside = outside the frustum: { $plane } plane
pipeline-pixel-back-facing = culled: back-facing
pipeline-pixel-front-facing = culled: front-facing
pipeline-pixel-degenerate = degenerate: no area
pipeline-pixel-clipped-away = clipped away: { $plane } plane
pipeline-pixel-rounded-away = no area is left after clipping
pipeline-pixel-cut-off = clipped by the { $plane } plane
pipeline-pixel-zero-area = no area on the screen
pipeline-pixel-outside-edge = outside an edge
pipeline-pixel-lost-tie = on an edge: the neighbour draws it
pipeline-pixel-no-sample = covers no sample
pipeline-pixel-scissored = outside the scissor rectangle
pipeline-pixel-discarded = discarded by the alpha test
pipeline-pixel-stencil = stencil test failed
pipeline-pixel-depth = depth test failed

pipeline-pixel-would-cover = Its edges would contain this centre.
pipeline-pixel-would-cover-samples = Its edges would contain samples of this pixel.
pipeline-pixel-shaded = shaded once, at { $at }
pipeline-pixel-sample = sample { $index }: { $reason }
pipeline-pixel-edge-value = { $edge }(centre) = { $value } < 0
pipeline-pixel-on-edge = { $edge }(centre) = 0
pipeline-pixel-determinant = det (x, y, w) = { $value }
pipeline-pixel-cut-before = The { $plane } plane had cut it before.
pipeline-pixel-scissor = { $left } ≤ x < { $right }, { $top } ≤ y < { $bottom }
pipeline-pixel-alpha = alpha { $alpha } { $compare } { $reference }
pipeline-pixel-alpha-never = alpha { $alpha }: never kept
pipeline-pixel-early-test = Early z may test it before its alpha is known, but not write it.
pipeline-pixel-early-never = No early z: failing would change the stencil, so all waits for its alpha.
pipeline-pixel-biased = depth { $plane } + bias { $bias } = { $sum }
pipeline-pixel-biased-clamped = depth { $plane } + bias { $bias }, kept in 0 … 1: { $sum }
pipeline-pixel-clamped = depth { $plane }, kept in 0 … 1: { $sum }
pipeline-pixel-stencil-values = stencil: { $reference } & { $mask } { $compare } { $stored } & { $mask }
pipeline-pixel-stencil-compare = stencil: { $compare }
pipeline-pixel-stencil-stored = { $operation }: { $before } → { $after } (mask { $mask })
pipeline-pixel-depth-unwritten = { $new } { $compare } { $stored }, not stored: no depth write
pipeline-pixel-blended = blended: { $before } → { $after }
pipeline-pixel-replaced = colour: { $before } → { $after }
pipeline-pixel-depth-stored = { $new } { $compare } { $stored }, stored
pipeline-pixel-depth-kept = { $new } { $compare } { $stored }, kept
pipeline-pixel-codes = { $new } { $compare } { $stored }

pipeline-pixel-blend-add = { $channel }: { $source } · { $source-factor } + { $stored } · { $stored-factor } = { $result } → { $code }
pipeline-pixel-blend-subtract = { $channel }: { $source } · { $source-factor } − { $stored } · { $stored-factor } = { $result } → { $code }
pipeline-pixel-blend-reverse = { $channel }: { $stored } · { $stored-factor } − { $source } · { $source-factor } = { $result } → { $code }
pipeline-pixel-blend-min = { $channel }: min({ $source }, { $stored }) = { $result } → { $code }
pipeline-pixel-blend-max = { $channel }: max({ $source }, { $stored }) = { $result } → { $code }

pipeline-pixel-drawn = { $name } drew this pixel.
pipeline-pixel-why-own-black = { $name } drew this pixel, and is black there itself.
pipeline-pixel-why-left-black = { $name } was blended over this pixel last, and that left it black.
pipeline-pixel-why-transparent = { $name } came last, with alpha 0: it changed nothing.
pipeline-pixel-why-mean = The mean of { $count } samples: { $parts }.
pipeline-pixel-why-mean-clear = The mean of { $count } samples: { $parts }, { $clear } × clear.
pipeline-pixel-why-nothing = Nothing comes to this pixel: it shows the clear colour.
pipeline-pixel-why-depth = The pixel is clear: { $name } came to it, but its depth test failed.
pipeline-pixel-why-stencil = The pixel is clear: { $name } came to it, but its stencil test failed.
pipeline-pixel-why-discarded = The pixel is clear: { $name } came to it, but was discarded for its alpha.
pipeline-pixel-why-scissored = The pixel is clear: it lies outside the scissor rectangle of { $name }.
pipeline-pixel-why-lost-tie = The pixel is clear: its centre lies on an edge of { $name } that does not draw it.
pipeline-pixel-why-no-sample = The pixel is clear: { $name } covers none of its samples.
pipeline-pixel-why-cut-off = The pixel is clear: the { $plane } plane cut off what { $name } would show here.
pipeline-pixel-why-back-facing = The pixel is clear: { $name } would cover it, but is culled, as it shows its back.
pipeline-pixel-why-front-facing = The pixel is clear: { $name } would cover it, but is culled, as it shows its front.

pipeline-overlay-none = nothing
pipeline-overlay-depth = depth
pipeline-overlay-stencil = stencil
pipeline-overlay-generated = fragments got
pipeline-overlay-written = fragments written
pipeline-overlay-wireframe = wireframe
pipeline-overlay-triangle = triangle at pointer
pipeline-overlay-changed = changed pixels
pipeline-overlay-equal = equal depth codes

pipeline-work-triangles = triangles
pipeline-work-pixels = pixels tested
pipeline-work-colors = colours computed
pipeline-work-cleared = pixels cleared
pipeline-work-stages = stages run
pipeline-work-tiles = tiles and blocks
pipeline-pixel-light-flat = lit once for the face: factor { $factor }
pipeline-pixel-light-gouraud = lit at the vertices: { $color } comes here
pipeline-pixel-light-inputs = P = { $place }, N = { $normal }
pipeline-pixel-light-terms = ambient { $ambient } + diffuse { $diffuse }, specular { $specular }
