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
/// Cost: a few ns; 1 to 2 us for the tail with what `exact` computes. It is counted in `tally`.
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
/// *Source:* Direct3D 11.3 functional specification, section 3.2.3 (FLOAT to UNORM).
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

#[cfg(test)]
mod tests {
    use super::super::predicates::edge_value;
    use super::super::testing::{KINDS, Xorshift, dependent, independent};
    use super::super::ulp::next_up;
    use super::*;

    const CASES: u32 = 20_000;

    fn to_f32(number: &Dyadic) -> f32 {
        Dyadic::ratio_to_f32(number, &Dyadic::one())
    }

    /// The middle between an f32 and the next, of any magnitude, as an f64 (which holds it exactly).
    fn midpoint(rng: &Xorshift) -> f64 {
        let below = rng.pick(&[rng.any_f32(), (rng.unit() * 2.0) as f32, 1e-45, 0.0, 1.0, -2.0]);
        let above = if below == f32::MAX { 2f64.powi(128) } else { f64::from(next_up(below)) };
        (f64::from(below) + above) / 2.0
    }

    #[test]
    fn a_rounding_is_certain_only_if_both_ends_agree() {
        let rng = Xorshift::new(1991);
        let (mut some, mut none) = (0, 0);
        for _ in 0..CASES {
            let middle = midpoint(&rng);
            let ulp = middle.abs() * f64::EPSILON;
            let value = middle + ulp * f64::from(rng.below(9) as i32 - 4);
            let error = ulp * rng.pick(&[0.0, 0.5, 1.0, 3.0, 1e6, 1e9]);
            let (exact, reach) = (Dyadic::from(value), Dyadic::from(error));
            let (low, high) = (to_f32(&(&exact - &reach)), to_f32(&(&exact + &reach)));
            match round_to_f32(Approx { value, error }) {
                Some(rounded) => {
                    assert_eq!((low.to_bits(), high.to_bits()), (rounded.to_bits(), rounded.to_bits()));
                    some += 1;
                }
                // Being widened outward it may decline next to a midpoint, never without error.
                None => {
                    assert!(error > 0.0);
                    none += 1;
                }
            }
        }
        assert!(some > CASES / 10 && none > CASES / 10);
    }

    #[test]
    fn the_ends_of_the_range_round_like_all_else() {
        let round = |value, error| round_to_f32(Approx { value, error });
        assert_eq!(round(-0.0, 0.0).map(f32::to_bits), Some(0));
        assert_eq!(round(-1e-60, 1e-61).map(f32::to_bits), Some(0));
        assert_eq!(round(1e300, 1e299), Some(f32::INFINITY));
        assert_eq!(round(1.1e-45, 1e-47), Some(1e-45));
        assert_eq!(round(f64::from(f32::MAX), 1e20), Some(f32::MAX));
        for error in [f64::INFINITY, f64::NAN] {
            assert_eq!(round(1.0, error), None);
        }
        for value in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            assert_eq!((round(value, 0.0), round(value, f64::INFINITY)), (None, None));
        }
    }

    /// `(e0 z0 + e1 z1) / (e0 + e1)` with the edge values of a triangle: nearly and exactly.
    fn weighted([a, b, c]: [[f32; 2]; 3], z: [f32; 2]) -> (Approx, Dyadic, Dyadic) {
        let [p, q] = [edge_value(a, b, c), edge_value(b, a, [c[1], c[0]])];
        let approx = (p * Approx::from(z[0]) + q * Approx::from(z[1])) / (p + q);
        let exact = |a: [f32; 2], b: [f32; 2], c: [f32; 2]| {
            let ([ax, ay], [bx, by], [cx, cy]) =
                (a.map(Dyadic::from), b.map(Dyadic::from), c.map(Dyadic::from));
            (bx - &ax) * (cy - &ay) - (by - ay) * (cx - ax)
        };
        let (p, q) = (exact(a, b, c), exact(b, a, [c[1], c[0]]));
        let [y, z] = z.map(Dyadic::from);
        (approx, &p * y + &q * z, p + q)
    }

    #[test]
    fn interpolated_values_are_those_of_real_arithmetic() {
        let rng = Xorshift::new(2013);
        for kind in KINDS {
            for nearly_collinear in [false, true] {
                let (mut tally, mut asked) = (Tally::default(), 0);
                for _ in 0..CASES / 8 {
                    let points =
                        if nearly_collinear { dependent(&rng, kind, true) } else { independent(&rng, kind) };
                    let z = [rng.unit() as f32, rng.any_f32()];
                    let (approx, num, den) = weighted(points, z);
                    if den.is_zero() {
                        continue;
                    }
                    let exact = || (num.clone(), den.clone());
                    let rounded = rounded_ratio(approx, exact, &mut tally);
                    assert_eq!(rounded.to_bits(), Dyadic::ratio_to_f32(&num, &den).to_bits());
                    let max = rng.pick(&[1, 255, 65_535, 16_777_215, u32::MAX]);
                    let code = rounded_code(approx, max, exact, &mut tally);
                    assert_eq!(code, Dyadic::ratio_to_code(&num, &den, max));
                    asked += 2;
                }
                assert_eq!(tally.calls, asked);
                assert!(nearly_collinear || kind.0 != "random" || tally.exact <= 2, "{tally:?}");
            }
        }
    }

    #[test]
    fn quotients_next_to_a_midpoint_round_to_the_right_side() {
        let rng = Xorshift::new(2);
        let mut tally = Tally::default();
        for _ in 0..CASES {
            let den = Dyadic::from(rng.wide_f64(90));
            let off = Dyadic::from(rng.pick(&[-1, 0, 1])).mul_pow2(rng.pick(&[-500, -60, -30]));
            let num = &den * (Dyadic::from(midpoint(&rng)) + off);
            let approx = Approx::exact(num.to_f64_nearest()) + Approx { value: 0.0, error: 1e-300 };
            let approx = approx / Approx::exact(den.to_f64_nearest());
            let rounded = rounded_ratio(approx, || (num.clone(), den.clone()), &mut tally);
            assert_eq!(rounded.to_bits(), Dyadic::ratio_to_f32(&num, &den).to_bits());
        }
        assert!(tally.share() > 0.1, "{tally:?}");
    }

    #[test]
    fn codes_next_to_a_step_fall_on_the_right_side() {
        let rng = Xorshift::new(10);
        let mut tally = Tally::default();
        for _ in 0..CASES {
            let max = rng.pick(&[1, 255, 65_535, 16_777_215, u32::MAX]);
            let step = f64::from(rng.below(max)) + 0.5;
            let off = Dyadic::from(rng.pick(&[-1, 0, 1])).mul_pow2(rng.pick(&[-500, -60, -3]));
            let (num, den) = (Dyadic::from(step) + off, Dyadic::from(max));
            let approx = Approx::exact(num.to_f64_nearest()) / Approx::exact(f64::from(max));
            let code = rounded_code(approx, max, || (num.clone(), den.clone()), &mut tally);
            assert_eq!(code, Dyadic::ratio_to_code(&num, &den, max), "{step} / {max}");
        }
        assert!(tally.share() > 0.1, "{tally:?}");
    }

    #[test]
    fn codes_clamp_and_survive_an_unknown_value() {
        let mut tally = Tally::default();
        let mut code = |value: f64| {
            rounded_code(Approx::exact(value), 255, || (Dyadic::from(value), Dyadic::one()), &mut tally)
        };
        assert_eq!([-1e300, -3.0, -0.001, 0.0, 0.499].map(&mut code), [0, 0, 0, 0, 127]);
        assert_eq!([0.5, 1.0, 1.001, 1e300].map(&mut code), [128, 255, 255, 255]);
        assert_eq!(tally, Tally { calls: 9, exact: 1 });
        let one = || (Dyadic::one(), Dyadic::one());
        assert_eq!(rounded_code(Approx::UNKNOWN, u32::MAX, one, &mut tally), u32::MAX);
        assert_eq!(rounded_ratio(Approx::UNKNOWN, one, &mut tally), 1.0);
        assert_eq!(tally.exact, 3);
    }
}
