//! Where the line through two points meets a border, exactly.

use super::{Border, Outcode, Point, Segment, Window};
use crate::math::{Approx, Dyadic, Sign, Tally, orient2d, rounded_ratio};

/// The intersection with a border that the segment crosses, rounded once.
///
/// The border's coordinate is assigned, not computed. The other is
/// `(x1 (y2 - c) + x2 (c - y1)) / (y2 - y1)` (for a horizontal border): the quotient in binary64
/// if its error bound leaves no doubt about the rounding, else the exact one.
///
/// A coordinate that is equal to one of the window's has that border's bits, sign of zero included: the
/// point lies on that border too.
///
/// Both ends must lie on different sides of the border, or one on it.
///
/// *Source:* Skala 2023 (doi 10.15388/23-INFOR508) for clipping by signs; the filter is ours.
#[inline]
pub(in crate::clip) fn intersection(
    segment: Segment,
    border: Border,
    window: &Window,
    tally: &mut Tally,
) -> Point {
    let (fixed, free) = (border.axis(), 1 - border.axis());
    let c = window.at(border);
    let [[a1, b1], [a2, b2]] = segment.map(|p| [p[fixed], p[free]]);
    let value = if b1 == b2 {
        b1 + 0.0 // parallel to the axis: every point has this coordinate, and +0 is its zero
    } else {
        tally.calls += 1;
        let [fa1, fb1, fa2, fb2, fc] = [a1, b1, a2, b2, c].map(Approx::from);
        let approx = (fb1 * (fa2 - fc) + fb2 * (fc - fa1)) / (fa2 - fa1);
        rounded_ratio(
            approx,
            || {
                let [a1, b1, a2, b2, c] = [a1, b1, a2, b2, c].map(Dyadic::from);
                (&b1 * &(&a2 - &c) + &b2 * &(&c - &a1), &a2 - &a1)
            },
            tally,
        )
    };
    let mut point = [c; 2];
    point[free] = window.sides(free).into_iter().find(|side| *side == value).unwrap_or(value);
    point
}

/// Where on a border the EXACT intersection lies: the sign of its other coordinate minus `value`, from
/// the given ends. The rounded point can fall on a value that the exact one only comes near to.
#[inline]
pub(in crate::clip) fn side_at(
    [p, q]: Segment,
    border: Border,
    window: &Window,
    value: f32,
    tally: &mut Tally,
) -> Sign {
    let (fixed, c) = (border.axis(), window.at(border));
    let rising = Sign::of(f64::from(q[fixed]) - f64::from(p[fixed]));
    match fixed {
        0 => -(orient2d(p, q, [c, value], tally) * rising),
        _ => orient2d(p, q, [value, c], tally) * rising,
    }
}

/// The outcode of the EXACT intersection with `border`.
#[inline]
pub(super) fn code_at(segment: Segment, border: Border, window: &Window, tally: &mut Tally) -> Outcode {
    // The side of a corner of the border decides on which side of the corner the crossing lies.
    let mut beyond = |value: f32| side_at(segment, border, window, value, tally);
    let Window { xmin, ymin, xmax, ymax } = *window;
    match border.axis() {
        0 => {
            Outcode::from_bits([beyond(ymax) == Sign::Positive, beyond(ymin) == Sign::Negative, false, false])
        }
        _ => {
            Outcode::from_bits([false, false, beyond(xmax) == Sign::Positive, beyond(xmin) == Sign::Negative])
        }
    }
}
