# The pages of measurements in the window.

measure-title = Measure
measure-errors = Run time against error
measure-claims = Claims of the lectures
measure-growth = How cost grows
measure-palette = Measure: { $name }
measure-leave = Back to the lab (Esc)

measure-operation = Operation
measure-inputs = Inputs
measure-error = Error
measure-what-grows = By

measure-start = Measure now
measure-start-shown = Measure this
measure-start-all = Measure everything
measure-nothing = Nothing is measured yet. It takes some seconds, and runs beside the window.
measure-busy = { $number } of { $all }: { $what }
measure-save-picture = Save picture or table…
measure-copy-table = Copy table

measure-point = { $algorithm }, { $arithmetic }
    { $family }
    { $ns } ns { $item }
    { $what }: { $error }
measure-column-algorithm = algorithm
measure-column-arithmetic = in
measure-column-error = error
measure-column-times = × the first
measure-detail-time = time, median
measure-detail-quartiles = quartiles
measure-detail-worst = worst error
measure-detail-mean = mean error
measure-detail-not-finite = not finite
measure-detail-wrong = wrong answers
measure-detail-tail = decided by the exact tail

measure-skips-skip = Skip
measure-skips-work = left out of all
measure-skips-time = without it
measure-skips-same = same bytes
measure-skip-object-frustum = Objects outside
measure-skip-frustum = Triangles outside
measure-skip-back-face = Back faces
measure-skip-degenerate = Without area
measure-skip-tile = Tiles beside
measure-skip-row = Rest of a row
measure-skip-early-z = Early z
measure-skip-hierarchical-z = Hierarchical z
measure-skip-deferred = Colour at the end
measure-skip-clear = Clean pixels
measure-skip-memo = Same input
measure-skips-ask = Measure the time
measure-skips-counts = Counts of this image. Measuring draws it with and without each skip.
measure-skips-done = Without any skip a frame takes { $times } times as long. Colour, depth and stencil stay equal, byte for byte.
measure-skips-wrong = A skip changed a byte of colour, depth or stencil.
measure-skips-busy = Frames with and without each skip
