# Blending. What stands between two ** is bold.

blend = Blending
blend-about = What a fragment's colour becomes over the colour that is there. Nothing is rounded before the result is stored.
blend-opening = The pixel holds { $codes }. { $count ->
    [one] One layer comes
   *[other] { $count } layers come
} to it.
blend-append = **{ $object }** joins the pixel's list, at depth { $depth }. Nothing is blended yet.
blend-swap = **{ $first }** at { $far } is farther than **{ $second }** at { $near }: they change places.
blend-keep = **{ $first }** at { $far } is not nearer than **{ $second }** at { $near }: both stay.
blend-layer = **{ $object }** is blended next, over { $codes }.
blend-channel = **{ $object }**, { $channel }: the result is { $result }. Its code is { $code }.
blend-channel-clamped = **{ $object }**, { $channel }: the result is { $result }, outside 0 … 1. Its code is { $code }.
blend-store = **{ $object }** is stored: the pixel now holds { $codes }.
blend-channels = Channels
blend-factors = Factors and operations
blend-layers = Codes after each layer
blend-marker-layer = { $object }
row-red = red
row-green = green
row-blue = blue
row-alpha = alpha
row-color = colour
column-red = r
column-green = g
column-blue = b
blend-unit-layers = { $count ->
    [one] layer
   *[other] layers
}
