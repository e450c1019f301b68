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
