# Clipping a triangle in space. What stands between two ** is bold.

clip-triangle = Clipping a triangle
clip-triangle-about = Clip the triangle at one plane, then give the result to the next.
clip-triangle-opening = A vertex has four numbers here, before the divide. Inside all planes means −w ≤ x, y ≤ w and its depth in range.
clip-triangle-opening-camera = In camera space every plane has a point p and a normal n that points inwards. Inside means (v − p) · n ≥ 0.
clip-triangle-opening-divide = The mistake: divide by w first, clip afterwards. That is right only where w is positive.
clip-triangle-opening-no-near = The mistake: no near plane. Watch what is left between it and the eye.
clip-triangle-opening-no-attributes = The mistake: new corners get a position, but no u.
clip-triangle-opening-walk = The mistake: each crossing is computed from the end that the walk meets first. The neighbour walks the other way.
clip-triangle-divide = **{ $vertex }** is divided by w = { $w } and becomes { $at }.
clip-triangle-divide-behind = **{ $vertex }** has w = { $w }: it is **behind the eye**. Dividing mirrors it to { $at }.
clip-triangle-divide-zero = **{ $vertex }** has w = 0: it has no image. It is put to { $at }.
clip-triangle-lost = **{ $vertex }** is not finite after the division: nothing can be clipped.
clip-triangle-plane = The **{ $plane }** plane: inside is { $inside }. { $count ->
    [0] No vertex lies outside.
    [one] { $names } lies outside.
   *[other] { $names } lie outside.
}
clip-triangle-keep = The **{ $plane }** plane cuts nothing: the polygon stays as it is.
clip-triangle-reject = All lie outside the **{ $plane }** plane: **nothing is left**.
clip-triangle-side-in = **{ $corner }** lies inside the **{ $plane }** plane: d = { $d }.
clip-triangle-side-on = **{ $corner }** lies exactly on the **{ $plane }** plane. That counts as inside.
clip-triangle-side-out = **{ $corner }** lies outside the **{ $plane }** plane: d = { $d } is negative.
clip-triangle-leaves = { $from } → { $to } goes **out** through the **{ $plane }** plane: keep { $from }, emit the crossing **{ $new }**.
clip-triangle-enters = { $from } → { $to } comes **in** through the **{ $plane }** plane: emit the crossing **{ $new }**.
clip-triangle-stays-in = { $from } → { $to } begins inside and does not cross: keep **{ $from }**.
clip-triangle-stays-out = { $from } → { $to } does not come inside: it emits nothing.
clip-triangle-next = The **{ $plane }** plane is done: { $corners } corners go to the next plane.
clip-triangle-next-nothing = Inside the **{ $plane }** plane no area is left: **nothing is visible**.
clip-triangle-round = **{ $corner }** is rounded once: { $at }. It depends on its edge and plane alone.
clip-triangle-round-vertex = **{ $corner }** is a vertex: it stays bit for bit.
clip-triangle-round-interior = **{ $corner }** lies on two planes: it comes from the triangle and both of them, rounded once: { $at }.
clip-triangle-merge = Rounding put a corner on the one before it: they are one.
clip-triangle-attribute = **{ $corner }** is new: u = { $value }, recomputed where the edge is cut.
clip-triangle-attribute-vertex = **{ $corner }** keeps its u = { $value }.
clip-triangle-attribute-missing = **{ $corner }** is new and got no attribute: u = { $value }. Right would be { $right }.
clip-triangle-triangle = One triangle of the fan: { $corners }.
clip-triangle-done = { $corners } corners are left: { $triangles ->
    [one] one triangle
   *[other] { $triangles } triangles
}.
clip-triangle-done-nothing = **Nothing of the triangle is visible.**
clip-triangle-done-divide = { $corners } corners are left. Clipped before the division there are { $right }: hold both against each other.
clip-triangle-done-no-near = { $corners } corners are left. With the near plane there are { $right }.
clip-triangle-in-in = in → in
clip-triangle-in-out = in → out
clip-triangle-out-in = out → in
clip-triangle-out-out = out → out
clip-triangle-eye = eye
clip-triangle-edges = Edges against the plane
clip-triangle-so-far = Out so far
clip-triangle-polygon = Polygon
clip-triangle-inequalities = Distances of the vertices
clip-triangle-neighbours = The neighbour at these corners
clip-triangle-correct = Without mistake and rounding
clip-triangle-vertices = Vertices
clip-triangle-marker-left = left
clip-triangle-marker-right = right
clip-triangle-marker-bottom = bottom
clip-triangle-marker-top = top
clip-triangle-marker-near = near
clip-triangle-marker-far = far
column-clip-triangle-from = d from
column-clip-triangle-to = d to
column-clip-triangle-transition = transition
column-clip-triangle-emits = emits
column-clip-triangle-outside = outside
column-clip-triangle-ulp = ULP
row-clip-triangle-left = left
row-clip-triangle-right = right
row-clip-triangle-bottom = bottom
row-clip-triangle-top = top
row-clip-triangle-near = near
row-clip-triangle-far = far
