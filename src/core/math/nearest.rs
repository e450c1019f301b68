//! Quotients of exact numbers, rounded once to the nearest binary number.

use super::dyadic::{Dyadic, magnitude};
use dashu_int::ops::{BitTest, DivRem};
use std::cmp::Ordering;

/// Rounds `num / den` to the nearest f64 as [`Dyadic::ratio_to_f32`] does to f32.
pub(super) fn quotient_to_f64(num: &Dyadic, den: &Dyadic) -> f64 {
    rounded(num, den, 53, -1074, 971)
}

/// `num / den` to so many bits, with this least and greatest exponent; NaN if `den` is zero.
pub(super) fn rounded(num: &Dyadic, den: &Dyadic, precision: i64, lowest: i64, highest: i64) -> f64 {
    if den.is_zero() {
        return f64::NAN;
    }
    let (significand, exponent) = nearest_ratio(num, den, precision, lowest);
    let magnitude = if exponent > highest { f64::INFINITY } else { significand as f64 * pow2(exponent) };
    if (num.sign() * den.sign()).is_negative() { 0.0 - magnitude } else { magnitude }
}

/// Rounds `|num / den|` to the nearest `significand * 2^exponent`, ties to even.
///
/// The significand has at most `precision` bits (or is 2^precision), the exponent is at least `lowest`.
/// `den` is not zero.
fn nearest_ratio(num: &Dyadic, den: &Dyadic, precision: i64, lowest: i64) -> (u64, i64) {
    let (n, d) = (magnitude(num), magnitude(den));
    // 2^(leading - 1) < |num / den| < 2^(leading + 1)
    let scale = num.exponent - den.exponent;
    let leading = n.bit_len() as i64 - d.bit_len() as i64 + scale;
    if num.is_zero() || leading + 1 < lowest {
        return (0, lowest); // less than half of the lowest step
    }
    let mut exponent = (leading - precision).max(lowest);
    let shift = scale - exponent;
    let by = shift.unsigned_abs() as usize;
    let (n, d) = if shift < 0 { (n, d << by) } else { (n << by, d) };
    let (mut quotient, rest) = n.div_rem(&d);
    // One bit too many, if the quotient is in the upper half of its range, goes into the rounding.
    let half_bits = if quotient.bit_len() as i64 > precision {
        let odd = quotient.bit(0);
        quotient >>= 1;
        exponent += 1;
        match (odd, rest.is_zero()) {
            (false, _) => Ordering::Less,
            (true, true) => Ordering::Equal,
            (true, false) => Ordering::Greater,
        }
    } else {
        (rest << 1).cmp(&d)
    };
    let significand = u64::try_from(&quotient).unwrap_or(u64::MAX);
    let up = half_bits.is_gt() || (half_bits.is_eq() && significand % 2 == 1);
    (significand + u64::from(up), exponent)
}

/// 2^exponent, for exponents of f64: -1074..=1023.
fn pow2(exponent: i64) -> f64 {
    let bits = if exponent < -1022 { 1 << (exponent + 1074) } else { (exponent + 1023) << 52 };
    f64::from_bits(bits as u64)
}
