# Words of figures: what a drawing says by itself, whatever the lab.

figure-undefined = not defined yet
figure-nan = an operation without a defined result
figure-infinity = beyond the largest finite number
figure-values-hidden = { $cells ->
    [one] One value is hidden
   *[other] { $cells } values are hidden
}: they show from { $size } px cells on. Zoom { $zoom }× more.

figure-dark = Dark
figure-light = Light
figure-projector = Projector

figure-film-too-fine = An animated picture has at most { $most } frames; this one would have { $frames }. Choose larger steps.
figure-film-too-long = An animated picture has at most { $most } frames; even with the largest steps this one would have { $frames }. Choose a smaller scene.
