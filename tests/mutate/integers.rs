//! Exact numbers for the oracles: every binary32 value is a whole multiple of 2^-149.

use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive};

/// The value times 2^149.
pub(crate) fn integer(value: f32) -> BigInt {
    let bits = value.to_bits();
    let exponent = bits >> 23 & 0xFF;
    let fraction = bits & 0x007F_FFFF;
    let magnitude = match exponent {
        0 => BigInt::from(fraction),
        _ => BigInt::from(fraction | 0x0080_0000) << (exponent - 1),
    };
    if value.is_sign_negative() { -magnitude } else { magnitude }
}

/// The binary32 value nearest to `numerator / denominator` times 2^-149; ties to even, zero is +0.
pub(crate) fn nearest(numerator: &BigInt, denominator: &BigInt) -> f32 {
    let negative = numerator.is_negative() != denominator.is_negative();
    let (n, d) = (numerator.abs(), denominator.abs());
    let whole = &n / &d;
    // As many bits as a binary32 value has; below 2^24 the spacing is one.
    let shift = whole.bits().saturating_sub(24);
    let step = d << shift;
    let (quotient, twice_rest) = (&n / &step, (&n % &step) * 2);
    let up = twice_rest > step || twice_rest == step && quotient.bit(0);
    let quotient = quotient + i32::from(up);
    // 24 bits and a power of two that binary64 holds.
    let exponent = i32::try_from(shift).unwrap_or(i32::MAX).saturating_sub(149);
    let magnitude = quotient.to_f64().unwrap_or(f64::INFINITY) * 2.0_f64.powi(exponent);
    let value = magnitude as f32;
    if negative && value != 0.0 { -value } else { value }
}

/// `floor(max v + 1/2)` of `v = numerator / denominator`, within `0..=max`.
pub(crate) fn code(numerator: &BigInt, denominator: &BigInt, max: u32) -> u32 {
    let (n, d) = match denominator.is_negative() {
        true => (-numerator, -denominator),
        false => (numerator.clone(), denominator.clone()),
    };
    if n.is_negative() {
        return 0;
    }
    let code: BigInt = (n * 2 * max + &d) / (d * 2);
    code.to_u32().map_or(max, |code| code.min(max))
}

/// -1, 0 or 1.
pub(crate) fn sign(value: &BigInt) -> i32 {
    i32::from(value.is_positive()) - i32::from(value.is_negative())
}

/// The cross product of two vectors.
pub(crate) fn cross(a: &[BigInt; 3], b: &[BigInt; 3]) -> [BigInt; 3] {
    [[1, 2], [2, 0], [0, 1]].map(|[j, k]| &a[j] * &b[k] - &a[k] * &b[j])
}

/// The dot product of two vectors.
pub(crate) fn dot(a: &[BigInt; 3], b: &[BigInt; 3]) -> BigInt {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}
