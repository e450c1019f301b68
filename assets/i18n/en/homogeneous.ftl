# Homogeneous rasterization

homogeneous = Homogeneous
homogeneous-about = Edge functions from x, y and w: no division, no clipping, right behind the eye.
homogeneous-opening = Each edge is a plane through the eye and two corners. Its sign at a centre needs no division by w, and **no clipping**.
homogeneous-coefficient = { $edge } is the plane through the eye and { $ends }: its **{ $term }** is **{ $value }**.
homogeneous-determinant = The determinant of the three corners is **{ $value }**. Its sign says which side of the triangle is seen.
homogeneous-zero-area = The determinant is 0: the triangle has no area, or the eye looks along it. **Nothing is drawn**.
homogeneous-turned = The determinant is negative: every sign is **turned**, so that the inside is positive.
homogeneous-inverse-w = The three edges added up are det/w, linear on the screen: its **{ $term }** is **{ $value }**.
homogeneous-near = The near plane, w = { $near }, is a **fourth edge**: its **{ $term }** is **{ $value }**.
homogeneous-box-whole = A corner is not in front of the eye, so its quotient bounds nothing: { $count ->
    [one] **the only centre** of the image is
   *[other] **all { $count } centres** of the image are
} looked at.
homogeneous-test-in = Centre ({ $x }, { $y }): every edge is positive, so 1/w is too. **Drawn**.
homogeneous-test-near = Centre ({ $x }, { $y }): **N** is negative. The triangle is nearer than the near plane there: **out**.
homogeneous-pixel-near = **N** keeps it **out**: the triangle is nearer than w = { $near } there.
homogeneous-marker-adjugate = adjugate
homogeneous-coefficients = Coefficients
homogeneous-at = Edges at the centre
