# A checkered square with and without perspective correction. What stands between two ** is bold.

perspective-correction = Perspective correction
perspective-correction-about = What changes evenly in space does not change evenly on the screen. Divide by w first, then it does.
perspective-correction-opening-affine = Affine: u and v change evenly on the screen, as if the square faced the eye.
perspective-correction-opening-perspective = Perspective: u/w, v/w and 1/w change evenly on the screen, and one division a pixel gives u and v.
perspective-correction-triangle = Triangle { $number } of 2: the square is cut along its diagonal.
perspective-correction-row = Row { $y }: { $count ->
    [one] one pixel
   *[other] { $count } pixels
}.
perspective-correction-affine = Pixel ({ $x }, { $y }): (u, v) = **{ $uv }**, as if all w were equal.
perspective-correction-perspective = Pixel ({ $x }, { $y }): (u, v) = **{ $uv }**, by one division.
perspective-correction-texel = Pixel ({ $x }, { $y }) shows a **{ $square }** square, and would the other way, too.
perspective-correction-differs = Pixel ({ $x }, { $y }) shows a **{ $square }** square; the other way it would be **another one**.
perspective-correction-line = { $count ->
    [0] No pixel differs from the other way.
    [one] **One pixel** shows another square than the other way.
   *[other] **{ $count } pixels** show another square than the other way.
} Now along the line from L0 to L1.
perspective-correction-along = t = { $t }: z = { $z } and 1/w = { $r } lie **on straight lines**; the distance d = { $d } does not.
perspective-correction-marker-first = first triangle
perspective-correction-marker-second = second triangle
perspective-correction-marker-line = line
perspective-correction-pixel = The pixel both ways
perspective-correction-counts = What is drawn
perspective-correction-curves = Along the line
