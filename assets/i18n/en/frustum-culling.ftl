# Objects against the frustum. What stands between two ** is bold.

frustum-culling = Frustum culling
frustum-culling-about = One body stands for each object: six plane tests can spare all of its triangles.
frustum-culling-opening = { $count ->
    [one] One object, a { $body } around it
   *[other] { $count } objects, a { $body } around each
}. What lies outside one plane cannot be seen.
frustum-culling-object = **{ $object }** has { $count ->
    [one] one triangle
   *[other] { $count } triangles
}. Its { $body } stands for all of them.
frustum-culling-plane-outside = { $object }: d + r is negative, so the { $body } lies wholly **outside** the **{ $plane }** plane.
frustum-culling-plane-inside = { $object }: d − r is not negative, so the { $body } lies wholly **inside** the **{ $plane }** plane.
frustum-culling-plane-crosses = { $object }: the { $body } reaches to both sides of the **{ $plane }** plane. It **crosses** it, as far as one can tell.
frustum-culling-reject = **{ $object }** is **culled**: outside the { $plane } plane. { $count ->
    [one] Its triangle is
   *[other] Its { $count } triangles are
} not even transformed.
frustum-culling-accept = **{ $object }** is **inside** all six planes. { $count ->
    [one] Its triangle needs
   *[other] Its { $count } triangles need
} no test and no clipping.
frustum-culling-cross = **{ $object }** crosses a plane. Now { $count ->
    [one] its triangle is
   *[other] its { $count } triangles are
} tested.
frustum-culling-triangle-outside = Triangle { $triangle } of { $object }: all three vertices lie outside the **{ $plane }** plane. It is **dropped**.
frustum-culling-triangle-kept = Triangle { $triangle } of { $object }: no plane has all three vertices outside. It is **kept**; the clipper may cut it.
frustum-culling-done = { $outside } outside, { $inside } inside, { $crossing } crossing. { $tests } plane { $tests ->
    [one] test
   *[other] tests
} spared { $saved } { $saved ->
    [one] triangle
   *[other] triangles
}; { $tested } { $tested ->
    [one] was
   *[other] were
} tested.

frustum-culling-sphere = sphere
frustum-culling-box = box
frustum-culling-body = Body
frustum-culling-outside = outside
frustum-culling-inside = inside
frustum-culling-crosses = crosses
frustum-culling-objects = Objects
frustum-culling-planes = Planes
column-frustum-culling-is = lies
column-frustum-culling-lost = dropped
row-frustum-culling-left = left
row-frustum-culling-right = right
row-frustum-culling-bottom = bottom
row-frustum-culling-top = top
row-frustum-culling-near = near
row-frustum-culling-far = far
column-frustum-culling-triangles = triangles
