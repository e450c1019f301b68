//! Correct rounding behind a filter: nearly always an f64 with an error bound tells the nearest result.
//!
//! A number is correctly rounded if it is the result nearest to the exact value, ties to even. It depends
//! on nothing else: not on the order of operations, nor on whether the filter or the exact tail found it.

use super::approx::Approx;
use super::dyadic::Dyadic;
use super::tally::Tally;

/// Rounds to the nearest f32, ties to even, if every number within the error rounds to the same.
///
/// `None` if the error reaches across a midpoint between two f32, or if nothing is known. Subnormal
/// results and overflow to infinity are those of the exact value; zero is always 0.0, never -0.0.
///
/// A few ns. *Source:* the rounding test of Ziv, Fast Evaluation of Elementary Mathematical Functions with
/// Correctly Rounded Last Bit, 1991.
#[inline]
#[must_use]
pub fn round_to_f32(approx: Approx) -> Option<f32> {
    if !approx.value.is_finite() {
        return None;
    }
    // Rounding is monotone: if both ends agree, so does all between. Infinite and NaN errors disagree.
    let (low, high) = approx.bounds();
    let (low, high) = (low as f32, high as f32);
    (low == high).then_some(low + 0.0)
}

/// Rounds a quotient to the nearest f32, ties to even: by the filter if it decides, else exactly.
///
/// `approx` is the quotient nearly; `exact` makes its numerator and denominator and is called only if the
/// filter fails, about once in 2^27 random quotients and at every exact tie. Both must describe the same
/// number, and the denominator is not zero. Subnormals, overflow and zero as in [`round_to_f32`].
///
/// Cost: a few ns, about 1 us for the tail, which is counted in `tally`.
#[inline]
#[must_use]
pub fn rounded_ratio(approx: Approx, exact: impl FnOnce() -> (Dyadic, Dyadic), tally: &mut Tally) -> f32 {
    tally.calls += 1;
    if let Some(rounded) = round_to_f32(approx) {
        return rounded;
    }
    tally.exact += 1;
    exact_ratio(exact)
}

#[cold]
#[inline(never)]
fn exact_ratio(exact: impl FnOnce() -> (Dyadic, Dyadic)) -> f32 {
    let (num, den) = exact();
    Dyadic::ratio_to_f32(&num, &den)
}

/// Rounds a quotient to an unsigned normalized code: `floor(max v + 1/2)`, clamped to `0..=max`.
///
/// `max` is 255 for 8 bits of colour, 2^n - 1 for n bits of depth. `approx` and `exact` are as in
/// [`rounded_ratio`]; exactly half-way values, such as 1/2 at 255, always need the tail, so a caller with
/// a constant converts it once.
///
/// *Source:* Direct3D 11.3 functional specification, section 3.2.3.6 (float to UNORM).
#[inline]
#[must_use]
pub fn rounded_code(
    approx: Approx,
    max: u32,
    exact: impl FnOnce() -> (Dyadic, Dyadic),
    tally: &mut Tally,
) -> u32 {
    tally.calls += 1;
    let scaled = approx * Approx::exact(f64::from(max)) + Approx::exact(0.5);
    if scaled.error < f64::INFINITY {
        let (low, high) = scaled.bounds();
        // `as` truncates, which is the floor above zero, and saturates, which clamps at zero.
        let (low, high) = ((low as u32).min(max), (high as u32).min(max));
        if low == high {
            return low;
        }
    }
    tally.exact += 1;
    exact_code(max, exact)
}

#[cold]
#[inline(never)]
fn exact_code(max: u32, exact: impl FnOnce() -> (Dyadic, Dyadic)) -> u32 {
    let (num, den) = exact();
    Dyadic::ratio_to_code(&num, &den, max)
}
