//! Whether a segment and the window meet at all, exactly and without a division.

use super::{Segment, Window};
use crate::math::{Sign, Tally, orient2d};

/// Whether some point of the segment lies in the closed window: their boxes overlap, and the
/// window's corners do not all lie strictly on one side of the line.
///
/// *Source:* the separating axis theorem for convex shapes, such as Ericson, Real-Time Collision
/// Detection, 2005, section 5.3.3.
pub(super) fn meets(segment: Segment, window: &Window, tally: &mut Tally) -> bool {
    let [p, q] = segment;
    let overlap = (0..2).all(|axis| {
        let [low, high] = window.sides(axis);
        p[axis].max(q[axis]) >= low && p[axis].min(q[axis]) <= high
    });
    let mut on_side = |side| window.corners().into_iter().all(|corner| orient2d(p, q, corner, tally) == side);
    overlap && !on_side(Sign::Positive) && !on_side(Sign::Negative)
}
