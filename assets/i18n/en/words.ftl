# Words that several areas share: headings of columns and names of things.

word-top = top
word-bottom = bottom
word-right = right
word-left = left
word-accept = accept
word-reject = reject
word-near = near
word-far = far
