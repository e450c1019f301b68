# Nicholl-Lee-Nicholl line clipping. What stands between two ** is bold.

nicholl-lee-nicholl = Nicholl–Lee–Nicholl
nicholl-lee-nicholl-about = Find the region of P2 as seen from P1; compute only the points of the answer.
nicholl-lee-nicholl-opening = Lines from P1 through the window's corners divide the plane. The region of P2 names the borders that cut.
nicholl-lee-nicholl-place-inside = **P1** lies inside, so it stays. The line can leave at any border.
nicholl-lee-nicholl-place = **P1** lies beyond { $borders ->
    [one] the **{ $first }** border, so the line can enter only there
   *[other] the **{ $first }** and the **{ $second }** border, so the line can enter at either
}: code { $code }.
nicholl-lee-nicholl-same-beyond = P2 lies beyond the **{ $border }** border, too: the line never crosses it.
nicholl-lee-nicholl-same = P2 does not lie beyond the **{ $border }** border: the line crosses it.
nicholl-lee-nicholl-far-beyond = P2 lies beyond the **{ $border }** border: the line crosses it on its way out.
nicholl-lee-nicholl-far = P2 does not lie beyond the **{ $border }** border: the line does not leave there.
nicholl-lee-nicholl-slope-entry = Against the slope to their corner: the { $border } border is crossed first, the { $other } border last. So the line enters at the **{ $other }** border.
nicholl-lee-nicholl-slope-exit = Against the slope to their corner: the { $border } border is crossed first. So the line leaves at the **{ $border }** border.
nicholl-lee-nicholl-slope-hit = Against the slope to their corner: the { $border } border is crossed before the { $other } border. So the line **meets** the window.
nicholl-lee-nicholl-slope-missed = Against the slope to their corner: the { $border } border is crossed before the { $other } border. So the line **misses** the window.
nicholl-lee-nicholl-cut = **{ $end }** moves to the **{ $border }** border, at { $to }.
nicholl-lee-nicholl-accept = { $cuts ->
    [0] What is between the ends is **visible**.
    [one] P2 lies in region **{ $region }**: one end was cut, the rest is **visible**.
   *[other] P2 lies in region **{ $region }**: both ends were cut, the rest is **visible**.
} { $divisions ->
    [0] Nothing was divided.
    [one] It took one division.
   *[other] It took { $divisions } divisions.
}
nicholl-lee-nicholl-reject = **Nothing is visible**, and nothing was divided.
nicholl-lee-nicholl-ends = Ends
nicholl-lee-nicholl-work = Operations so far
nicholl-lee-nicholl-marker-slope = slope
nicholl-lee-nicholl-marker-cut = cut
