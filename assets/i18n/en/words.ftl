# Words that several areas share: headings of columns and names of things.

word-top = top
word-bottom = bottom
word-right = right
word-left = left
word-accept = accept
word-reject = reject
word-accepted = accepted
word-rejected = rejected
word-near = near
word-far = far

mistake-none = none
word-side-order-left-right-bottom-top = left, right, bottom, top
word-side-order-bottom-top-left-right = bottom, top, left, right
word-side-order-top-right-bottom-left = top, right, bottom, left
word-side-order-left-bottom-right-top = left, bottom, right, top
word-space-clip = clip
word-space-camera = camera
word-planes-all = all six
word-planes-near = near only
word-planes-guard = guard band
word-pieces-polygon = polygon
word-pieces-triangles = triangles
mistake-divide-first = Divide before clip
mistake-no-near-plane = No near plane
mistake-no-attributes = New vertices without u
mistake-walk-order = Intersections in walk order
word-arithmetic-exact = exact
word-arithmetic-f32 = f32, as taught
word-arithmetic-f64 = f64, as taught
word-arithmetic-fixed-8 = fixed, 8 bits
word-fill-top-left = top-left
word-fill-right-of-point = right of point
word-fill-inclusive = inclusive
word-fill-strict = strict
word-winding-even-odd = even-odd
word-winding-non-zero = non-zero
word-depth-zero-to-one = 0 … 1
word-depth-minus-one-to-one = −1 … 1
word-y-down = down
word-y-up = up
word-front-ccw = CCW
word-front-cw = CW
word-cull-none = none
word-cull-back = back
word-cull-front = front

error-interpolate-zero-area = The triangle has no area, so no point lies inside it.
error-interpolate-outside = The point lies outside the triangle.
error-interpolate-zero-w = A vertex has w = 0: it is infinitely far away on the screen.
error-interpolate-infinite = The sum of l/w is 0: the point is infinitely far away.
