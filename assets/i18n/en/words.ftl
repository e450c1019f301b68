# Words that several areas share: headings of columns and names of things.

word-top = top
word-bottom = bottom
word-right = right
word-left = left
word-accept = accept
word-reject = reject
word-near = near
word-far = far

error-interpolate-zero-area = The triangle has no area, so no point lies inside it.
error-interpolate-outside = The point lies outside the triangle.
error-interpolate-zero-w = A vertex has w = 0: it is infinitely far away on the screen.
error-interpolate-infinite = The sum of l/w is 0: the point is infinitely far away.
