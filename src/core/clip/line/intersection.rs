//! Where the line through two points meets a border, exactly.

use super::{Border, Point, Segment, Window};
use crate::math::{Dyadic, Expansion, Sign, Tally, next_up, orient2d};

/// An error bound of a computed crossing, relative to the greater of |b1| and |b2|, which is B.
///
/// With a across the border and b along it, a crossing is at `b1 + (b2 - b1) (c - a1) / (a2 - a1)`. Let u
/// be 2^-53. Three differences, a product and a quotient are rounded, so what is added to b1 is off by
/// less than 5.1 u of itself; where the ends are on different sides, it is at most 2 B. The sum is at most
/// B, so its rounding is off by no more than u B, and nearly so is that of the sums with the bound:
/// together less than 12.5 u B. Nothing underflows, since the products are multiples of 2^-298 and the
/// divisors below 2^129.
pub(super) const ERROR: f64 = 16.0 * (f64::EPSILON / 2.0);

/// The intersection with a border that the segment crosses, rounded once.
///
/// The border's coordinate is assigned, not computed. The other is computed in binary64; if not all
/// numbers within its error bound round to the same, exact signs decide.
///
/// A coordinate that is equal to one of the window's has that border's bits, sign of zero included: the
/// point lies on that border too.
///
/// Both ends must lie on different sides of the border, or one on it.
///
/// *Source:* Ziv 1991 for the rounding test; the bound is ours.
#[inline]
pub(in crate::clip) fn intersection(
    segment: Segment,
    border: Border,
    window: &Window,
    tally: &mut Tally,
) -> Point {
    tally.calls += 1;
    let (fixed, free) = (border.axis(), 1 - border.axis());
    let c = window.at(border);
    let [[a1, a2], [b1, b2]] = [fixed, free].map(|axis| segment.map(|p| f64::from(p[axis])));
    let value = b1 + (b2 - b1) * (f64::from(c) - a1) / (a2 - a1);
    let [b1, b2] = [b1.abs(), b2.abs()];
    let error = ERROR * if b1 > b2 { b1 } else { b2 };
    let [low, high] = [value - error, value + error].map(|bound| bound as f32);
    let value = if low == high {
        low + 0.0
    } else {
        tally.exact += 1;
        decide([low, high], segment, border, window)
    };
    let value = window.sides(free).into_iter().find(|side| *side == value).unwrap_or(value);
    if fixed == 0 { [c, value] } else { [value, c] }
}

/// The coordinate of an intersection that lies between two numbers, rounded once; never -0.
///
/// If the numbers are neighbours, the sign of the coordinate minus their middle decides. It is that of a
/// sum of six products of two f32, or of an f32 and a middle, which f64 holds without error.
#[cold]
#[inline(never)]
fn decide([low, high]: [f32; 2], segment: Segment, border: Border, window: &Window) -> f32 {
    let (fixed, free, c) = (border.axis(), 1 - border.axis(), window.at(border));
    let [[a1, a2], [b1, b2]] = [fixed, free].map(|axis| segment.map(|p| p[axis]));
    let above = |middle: f64| {
        let [a1, a2, b1, b2, c] = [a1, a2, b1, b2, c].map(f64::from);
        let terms = [b1 * a2, -(b1 * c), b2 * c, -(b2 * a1), middle * a1, -(middle * a2)];
        Expansion::sum_of(terms).sign() * Sign::of(a2 - a1)
    };
    if low <= 0.0 && high >= 0.0 && above(0.0).is_zero() {
        0.0
    } else if next_up(low) == high && high.is_finite() {
        let even = if low.to_bits().is_multiple_of(2) { low } else { high };
        let value = match above((f64::from(low) + f64::from(high)) / 2.0) {
            Sign::Negative => low,
            Sign::Zero => even,
            Sign::Positive => high,
        };
        value + 0.0
    } else {
        let [a1, a2, b1, b2, c] = [a1, a2, b1, b2, c].map(Dyadic::from);
        Dyadic::ratio_to_f32(&(&b1 * &(&a2 - &c) + &b2 * &(&c - &a1)), &(&a2 - &a1))
    }
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
