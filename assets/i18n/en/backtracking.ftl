# Backtracking traversal

backtracking = Backtracking
backtracking-about = Go down the triangle; in each row go back to its left side, then fill to the right.
