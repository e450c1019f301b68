# A triangle against one plane. What stands between two ** is bold.

clip-plane = Triangle and plane
clip-plane-about = Three signed distances decide. One vertex inside leaves one triangle, two leave two.
clip-plane-opening = A point p and a normal n make the plane; n points inwards. d = (v − p) · n is negative outside.
clip-plane-inside = **{ $vertex }** is **inside**: d = { $d }.
clip-plane-on = **{ $vertex }** lies on the plane: d = 0 counts as **inside**.
clip-plane-outside = **{ $vertex }** is **outside**: d = { $d }.
clip-plane-keep = All three are inside: **the triangle stays as it is**.
clip-plane-reject = None is inside: **nothing is left**.
clip-plane-alone-inside = Only **{ $vertex }** is inside. Both its edges cross the plane.
clip-plane-alone-outside = Only **{ $vertex }** is outside. Both its edges cross the plane.
clip-plane-share = Here t weighs a = { $a }, the end inside: t = { $t }. Books that weigh b = { $b } instead write { $other } for it.
clip-plane-cross = The new vertex **{ $new }** is at { $at }.
clip-plane-one = One vertex inside, so **one triangle** is left: { $corners }.
clip-plane-first = Two vertices inside leave a quadrangle. Its **first triangle**: { $corners }.
clip-plane-second = Its **second triangle**: { $corners }.
clip-plane-flat = { $corners }: two of these are one point on the plane. A triangle without area is not made.
clip-plane-marker-x0 = x0
clip-plane-marker-x1 = x1
clip-plane-marker-triangle = triangle
clip-plane-vertices = Vertices and distances
clip-plane-new = New vertices
clip-plane-triangles = Triangles that are left
column-clip-plane-corners = corners
