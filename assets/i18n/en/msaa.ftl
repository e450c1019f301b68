# Several samples a pixel. What stands between two ** is bold.

msaa = Multisampling
msaa-about = Several samples a pixel decide what is covered. The pixel shows their mean, so edges look smooth.
msaa-opening = Each pixel has { $count ->
    [one] one sample, its centre
   *[other] { $count } samples at standard places
}. A triangle covers those inside.
msaa-triangle = Triangle **{ $object }**: the pixels of the box around it are looked at.
msaa-zero-area = { $object } has no area: **it covers no sample**.
msaa-pixel = Pixel ({ $x }, { $y }): which of its samples are inside?
msaa-sample-in = Sample { $sample } at { $at } is **inside** all three edges.
msaa-sample-out = Sample { $sample } at { $at } is **outside**: an edge value is negative.
msaa-sample-tie-in = Sample { $sample } at { $at } lies exactly on an edge that draws ties: **inside**.
msaa-sample-tie-out = Sample { $sample } at { $at } lies exactly on an edge that leaves ties to its neighbour: **outside**.
msaa-mask-none = No sample of pixel ({ $x }, { $y }) is inside: **it stays as it is**.
msaa-mask = { $count ->
    [one] The **only** sample of pixel ({ $x }, { $y }) is inside.
   *[other] **{ $inside } of { $count }** samples of pixel ({ $x }, { $y }) { $inside ->
        [one] is
       *[other] are
    } inside.
}
msaa-shade-centre = Shaded once, at the centre: code **{ $code }** for { $inside ->
    [one] one sample
   *[other] { $inside } samples
}.
msaa-shade-outside = Shaded at the centre, which lies **outside**: code **{ $code }** is extrapolated.
msaa-shade-centroid = Shaded once, at sample { $sample }, the first one inside: code **{ $code }** for { $inside ->
    [one] one sample
   *[other] { $inside } samples
}.
msaa-shade-sample = Shaded at sample { $sample }: code **{ $code }**.
msaa-resolve = Pixel ({ $x }, { $y }) shows the mean of its samples: **{ $code }**.
msaa-done = Done: { $tested } { $tested ->
    [one] sample
   *[other] samples
} tested, { $inside } inside, **{ $shades } { $shades ->
    [one] shade
   *[other] shades
}** computed.
msaa-marker-triangle = { $object }
msaa-samples = Samples of the pixel
msaa-counts = What it cost
msaa-key-inside = sample inside
msaa-key-outside = sample not inside
msaa-key-found = found outside now
msaa-hint-in = sample { $sample }: inside { $object }  E0 { $e0 }  E1 { $e1 }  E2 { $e2 }
msaa-hint-out = sample { $sample }: outside { $object }  E0 { $e0 }  E1 { $e1 }  E2 { $e2 }
