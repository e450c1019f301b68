# Words of figures: what a drawing says by itself, whatever the lab.

figure-undefined = not defined yet
figure-nan = an operation without a defined result
figure-infinity = beyond the largest finite number
figure-hidden-values = Too small for { $cells } { $cells ->
    [one] value
   *[other] values
}: shown from { $size } px cells on; zoom in.

figure-dark = Dark
figure-light = Light
figure-projector = Projector
