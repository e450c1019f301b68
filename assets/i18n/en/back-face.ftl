# Six back-face tests side by side. What stands between two ** is bold.

back-face = Back-face tests
back-face-about = Six tests ask whether the eye sees the front or the back of one triangle.
back-face-opening = Six tests answer the same question, each in its own space. The sign of a value s decides.

back-face-terms-camera = In **camera space** the eye stands in the origin. The normal n is the cross product of two edges.
back-face-terms-object = In **object space** no vertex is transformed. Instead the eye is taken there, once for the whole object.
back-face-terms-plane = In **world space** the plane of the triangle is Ax + By + Cz + D = 0. A, B, C is the normal.
back-face-terms-screen = On the **screen** each edge gives one product; their sum is twice the area.
back-face-terms-determinant = In **clip space** the rows are (x, y, w). The minors of the first row are the cross product of the other two.
back-face-value = { $test }: s is **{ $value }**.
back-face-no-image = { $test }: a vertex has w = 0 and so no image. **There is nothing to take a sign of**.
back-face-no-eye = { $test }: the eye has no place in that space. **There is nothing to take a sign of**.
back-face-answer-positive = s is positive: **{ $answer }**.
back-face-answer-negative = s is negative: **{ $answer }**.
back-face-answer-zero = s is exactly 0: by the rule for edge-on triangles, **{ $answer }**.
back-face-answer-none = s is not a number: **{ $answer }**.
back-face-no-area-coincident = The triangle has no area: **two vertices are the same point**.
back-face-no-area-collinear = The triangle has no area: **its vertices lie on one line**.
back-face-no-area-flattened = The triangle has an area as modelled, but in camera space **its vertices lie on one line**.
back-face-no-area-edge-on = The triangle has an area, but **the eye lies in its plane**: it is seen edge-on.
back-face-compare-same = { $test } says the same as the exact determinant: **{ $answer }**.
back-face-compare-no-answer = { $test } has **no answer** here. The determinant always has one.
back-face-compare-mirrored = { $test } says **{ $answer }**, the determinant does not: the model is **mirrored**, and object space does not know it.
back-face-compare-behind-eye = { $test } says **{ $answer }**, the determinant does not: an odd number of vertices lies **behind the eye**, and the divide mirrors each.
back-face-compare-edge-on-rule = { $test } says **{ $answer }**, the determinant does not: both are 0, but the **rules for 0** differ.
back-face-compare-rounded = { $test } says **{ $answer }**, the determinant does not: something was **rounded**.
back-face-fate-culled = The determinant decides: { $answer }, so the triangle is **culled**. { $disagreeing ->
    [0] All tests agree.
    [one] One test does not agree.
   *[other] { $disagreeing } tests do not agree.
}
back-face-fate-kept = The determinant decides: { $answer }, so the triangle is **kept**. { $disagreeing ->
    [0] All tests agree.
    [one] One test does not agree.
   *[other] { $disagreeing } tests do not agree.
}
back-face-fate-no-area = The determinant is 0, so the triangle covers nothing and is **dropped**. { $disagreeing ->
    [0] All tests agree.
    [one] One test does not agree.
   *[other] { $disagreeing } tests do not agree.
}

back-face-front = front
back-face-back = back
back-face-neither = neither
back-face-no-answer = none
back-face-coincident = coincident
back-face-collinear = collinear
back-face-flattened = flattened
back-face-edge-on = edge-on
back-face-why-same = same
back-face-why-no-answer = no answer
back-face-why-mirrored = mirrored
back-face-why-behind-eye = behind the eye
back-face-why-edge-on-rule = other rule for 0
back-face-why-rounded = rounded

back-face-test-camera = The normal in camera space
back-face-test-object = The eye in object space
back-face-test-plane = The plane's equation
back-face-test-ndc = The normal's z in NDC
back-face-test-screen = The area on the screen
back-face-test-determinant = The determinant of (x, y, w)
back-face-marker-camera = camera
back-face-marker-object = object
back-face-marker-plane = plane
back-face-marker-ndc = NDC
back-face-marker-screen = screen
back-face-marker-determinant = determinant

back-face-tests = Tests
row-back-face-camera = camera
row-back-face-object = object
row-back-face-plane = plane
row-back-face-ndc = NDC z
row-back-face-screen = screen
row-back-face-determinant = x y w
column-back-face-answer = sees
column-back-face-against-determinant = vs det
back-face-vertices-camera = Camera space
back-face-vertices-object = Object space
back-face-vertices-world = World space
back-face-vertices-ndc = NDC
back-face-vertices-screen = Screen
back-face-vertices-clip = Clip space
back-face-conventions = Conventions
column-back-face-setting = setting
row-back-face-front = front
row-back-face-cull = culled
back-face-rule = s = 0 is
back-face-rule-neither = neither
back-face-rule-back = back
back-face-rule-front = front
back-face-rule-as-taught = taught
back-face-culled = culled
back-face-kept = kept
back-face-eye = eye
back-face-object = Whole object
column-back-face-triangles = triangles
row-back-face-of-front = front seen
row-back-face-of-back = back seen
row-back-face-of-none = neither
