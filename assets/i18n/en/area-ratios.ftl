# A value by area ratios. What stands between two ** is bold.

area-ratios = Area ratios
area-ratios-about = P cuts the triangle in three. The part opposite to a vertex says how much the vertex weighs.
area-ratios-opening-affine = What is a at P? P and the edges make three triangles, and their areas are the weights.
area-ratios-opening-perspective = What is a at P? Areas weigh a/w and 1/w, and one division gives a.
area-ratios-whole = The whole triangle has an area of **{ $area }** square pixels.
area-ratios-part = P and the edge opposite to { $vertex } make a triangle of **{ $area }** square pixels.
area-ratios-part-outside = P lies **beyond** the edge opposite to { $vertex }: its triangle turns the other way.
area-ratios-share = **{ $vertex }** weighs **{ $l }**: its part of the whole area.
area-ratios-over = At { $vertex } a/w = **{ $value }**. It is computed once for the triangle.
area-ratios-reciprocal = At { $vertex } 1/w = **{ $value }**. It is computed once for the triangle.
area-ratios-sum-over = On the screen a/w changes evenly: at P it is **{ $value }**.
area-ratios-sum-reciprocal = So does 1/w: at P it is **{ $value }**, so w is { $w } there.
area-ratios-affine = **a = { $value }** at P, as if all w were equal.
area-ratios-perspective = One division: **a = { $value }** at P. Without w it would be { $affine }.
area-ratios-zero-area = The area is 0: there is **no inside**, so no value.
area-ratios-outside = P is **outside**: there is no value.
area-ratios-zero-w = A vertex has w = 0: it is nowhere on the screen, so there is **no value**.
area-ratios-infinite = At P 1/w is 0: P is infinitely far away, so there is **no value**.
area-ratios-marker-areas = areas
area-ratios-marker-shares = weights
area-ratios-marker-over = over w
area-ratios-marker-sums = at P
area-ratios-marker-value = value
area-ratios-marker-none = no value
area-ratios-weights = What each vertex weighs
area-ratios-over-w = Over w
area-ratios-values = The value at P
