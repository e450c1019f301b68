# Edge functions over the bounding box

aabb = Bounding box
aabb-about = Test every centre of the bounding box against the three edges.
