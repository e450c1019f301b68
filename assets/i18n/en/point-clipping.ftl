# Clipping a point. What stands between two ** is bold.

point-clipping = Clipping a point
point-clipping-about = Four comparisons tell in which of nine regions the point lies.
point-clipping-opening = The point is compared with one border after the other. Each comparison gives one bit.
point-clipping-beyond = The point lies beyond the **{ $border }** border: bit { $bit } is 1.
point-clipping-on = The point lies **on** the { $border } border, and the window is closed: bit { $bit } is 0.
point-clipping-within = The point does not lie beyond the { $border } border: bit { $bit } is 0.
point-clipping-accept = All bits are 0: the point is **visible**.
point-clipping-reject = The code is { $code }: the point lies beyond { $borders ->
    [one] the **{ $first }** border
   *[other] the **{ $first }** and the **{ $second }** border
} and is **not visible**.
point-clipping-bits = Comparisons
point-clipping-point = Point
column-point-clipping-border = border
column-point-clipping-bit = bit
