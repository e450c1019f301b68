# Zigzag traversal

zigzag = Zigzag
zigzag-about = Go down the triangle; in each row fill to the left, come back, and fill to the right.
