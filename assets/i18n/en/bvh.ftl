# A tree of boxes against the frustum. What stands between two ** is bold.

bvh = Tree of boxes (BVH)
bvh-about = A bounding volume hierarchy: one test can reject or accept many objects at once.
bvh-opening = { $count ->
    [one] One box becomes
   *[other] { $count } boxes become
} a tree, split by { $split }. Then the frustum is tested from the root down.
bvh-split = **{ $node }** holds { $count } boxes. It is split across **{ $axis }**: { $left } to one side, { $right } to the other.
bvh-leaf = **{ $node }** is a leaf: it holds { $count ->
    [one] one box
   *[other] { $count } boxes
}.
bvh-visit-root = The traversal begins at the root **{ $node }**, with all six planes and { $count ->
    [one] its only box
   *[other] all { $count } boxes
}.
bvh-visit = **{ $node }** is next, with { $count ->
    [one] one box
   *[other] { $count } boxes
}. { $planes ->
    [one] One plane is
   *[other] { $planes } planes are
} left to test; its parent is inside the others.
bvh-plane-outside = { $node } lies wholly **outside** the **{ $plane }** plane.
bvh-plane-inside = { $node } lies wholly **inside** the **{ $plane }** plane. Below it, this plane is not tested again.
bvh-plane-crosses = { $node } **crosses** the **{ $plane }** plane.
bvh-reject = All of **{ $node }** is **rejected**: { $count ->
    [one] one box
   *[other] { $count } boxes
} by the { $plane } plane, without a look at any of them.
bvh-accept = All of **{ $node }** is **accepted**: { $count ->
    [one] one box
   *[other] { $count } boxes
} inside all planes, without a further test.
bvh-descend = **{ $node }** crosses { $planes ->
    [one] one plane
   *[other] { $planes } planes
}. Both children are next, with only { $planes ->
    [one] this plane.
   *[other] these planes.
}
bvh-item-outside = { $item } lies wholly **outside** the **{ $plane }** plane.
bvh-item-inside = { $item } lies wholly **inside** the **{ $plane }** plane.
bvh-item-crosses = { $item } **crosses** the **{ $plane }** plane.
bvh-item-rejected = **{ $item }** is **rejected** by the { $plane } plane.
bvh-item-kept = **{ $item }** is **kept**: no plane has all of it outside.
bvh-done = { $kept } of { $count ->
    [one] one box is
   *[other] { $count } boxes are
} kept, after **{ $tests }** plane { $tests ->
    [one] test
   *[other] tests
}. Box by box it would have been { $without }.

bvh-split-median = median
bvh-split-surface-area = surface
bvh-split-rule = Split
bvh-over = Boxes of
bvh-over-objects = objects
bvh-over-triangles = triangles
bvh-marker-traverse = traverse
bvh-fate-visited = being tested
bvh-fate-accepted = inside
bvh-fate-crossed = across
bvh-kept = kept
bvh-counts = Counts
bvh-path = Path from the root
column-bvh-count = count
column-bvh-boxes = boxes
column-bvh-fate = is
row-bvh-visited = nodes visited
row-bvh-rejected = rejected whole
row-bvh-accepted = accepted whole
row-bvh-items = boxes tested
row-bvh-tests = plane tests
row-bvh-without = without a tree
