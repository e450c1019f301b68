# Edge functions and the ways over the centres: bounding box, backtracking, zigzag, tiles.

traversal-opening = A centre is drawn if the **three edge functions** let it in. The question is which centres to ask about.
traversal-zero-area = The vertices lie on one line: **zero area**, so nothing is drawn.
traversal-box = The box around the vertices has **{ $count ->
    [one] 1 centre
   *[other] { $count } centres
}**: columns { $left } to { $right }, rows { $top } to { $bottom }.
traversal-row = **Row { $y }** is next.
traversal-turn-left = From column **{ $x }** the walk goes **left**.
traversal-turn-right = From column **{ $x }** the walk goes **right**.
traversal-tile-outside = Tile ({ $x }, { $y }) of { $size } × { $size }: even its best centre lies outside **{ $edge }** ({ $ends }). **Left out whole**.
traversal-tile-inside = Tile ({ $x }, { $y }) of { $size } × { $size }: even its worst centre lies inside all edges. **Drawn whole**.
traversal-tile-split = Tile ({ $x }, { $y }) of { $size } × { $size }: an edge passes through. **Split** into tiles of { $part } × { $part }.
traversal-tile-tested = Tile ({ $x }, { $y }) of { $size } × { $size }: an edge passes through, so **each centre is tested**.
traversal-test-in = Centre ({ $x }, { $y }): all three edge functions are positive. **Drawn**.
traversal-test-out = Centre ({ $x }, { $y }): **{ $edge }** ({ $ends }) is negative and keeps it **out**.
traversal-test-tie-drawn = Centre ({ $x }, { $y }) lies exactly on **{ $edge }** ({ $ends }). The tie rule says: **drawn**.
traversal-test-tie-lost = Centre ({ $x }, { $y }) lies exactly on **{ $edge }** ({ $ends }). The tie rule says: **not drawn**.
traversal-skip = The triangle is convex: behind its last pixel **{ $count ->
    [one] 1 centre of the row is
   *[other] { $count } centres of the row are
} skipped**.
traversal-done = Done: **{ $tested ->
    [one] 1 centre
   *[other] { $tested } centres
}** tested, **{ $count ->
    [one] 1 pixel
   *[other] { $count } pixels
}** drawn.
traversal-marker-zero-area = zero area
traversal-edges = Edge functions
traversal-counts = Centres
traversal-tiles = Tiles
traversal-lets-in = lets in
traversal-keeps-out = keeps out
traversal-tie-drawn = tie: drawn
traversal-tie-lost = tie: lost
column-traversal-edge = edge
column-traversal-value = value
column-traversal-verdict = says
column-traversal-centres = centres
column-traversal-outside = outside
column-traversal-inside = inside
column-traversal-split = split
traversal-ways = All ways over this triangle
column-traversal-visited = visited
column-traversal-tested = tested
column-traversal-drawn = drawn
column-traversal-wasted = wasted
row-traversal-aabb = bounding box
row-traversal-backtracking = backtracking
row-traversal-zigzag = zigzag
row-traversal-tiled = tiles
row-traversal-box = in the box
row-traversal-tested = tested
row-traversal-drawn = drawn
row-traversal-wasted = wasted
row-traversal-skipped = skipped

# Why one pixel is drawn or not. $kind is one of the four words below, $rule the name of the tie rule.

pixel-in = The centre lies inside all three edges: **drawn**.
pixel-out = **{ $edge }** keeps it **out**: its edge function is { $value } there.
pixel-tie-drawn = It lies on **{ $edge }**, a { $kind } edge: **drawn** by the tie rule { $rule }.
pixel-tie-lost = It lies on **{ $edge }**, a { $kind } edge: **not drawn** by the tie rule { $rule }.
pixel-outside-box = The centre lies outside the box around the corners: **not looked at**.
pixel-zero-area = The triangle has no area: it covers no pixel.
pixel-wrongly-drawn = Drawn, and that is wrong: exactly, from the corners as given, it is not covered.
pixel-wrongly-lost = Not drawn, and that is wrong: exactly, from the corners as given, it is covered.
word-edge-left = left
word-edge-right = right
word-edge-top = top
word-edge-bottom = bottom
column-edge-kind = edge
