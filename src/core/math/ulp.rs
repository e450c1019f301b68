//! Distances between neighbouring f32 numbers: the unit in which errors are reported.

/// The position of `x` among all f32, in ascending order; both zeros are at 0.
fn rank(x: f32) -> i64 {
    let magnitude = i64::from(x.to_bits() & 0x7fff_ffff);
    if x.is_sign_negative() { -magnitude } else { magnitude }
}

/// Counts the steps between neighbouring f32 from `a` to `b`.
///
/// Equal numbers are 0 apart (also 0.0 and -0.0), the largest finite number and infinity 1. A NaN ranks
/// beyond the infinity of its sign, so that it is far from every number: no answer is NaN by accident.
#[must_use]
pub fn ulps_between(a: f32, b: f32) -> u64 {
    rank(a).abs_diff(rank(b))
}

/// The next f32 above `x`, one step by [`ulps_between`]: from either zero to the smallest subnormal, and
/// from the negative one of these to 0.0. Infinity and NaN stay.
#[inline]
#[must_use]
pub fn next_up(x: f32) -> f32 {
    // std goes from the negative subnormal to -0.0, which nothing here ever returns.
    x.next_up() + 0.0
}

/// The next f32 below `x`; the mirror image of [`next_up`]. Negative infinity and NaN stay.
#[inline]
#[must_use]
pub fn next_down(x: f32) -> f32 {
    x.next_down() + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distance_counts_steps() {
        assert_eq!(ulps_between(1.0, 1.0), 0);
        assert_eq!(ulps_between(0.0, -0.0), 0);
        assert_eq!(ulps_between(-1e-45, 1e-45), 2);
        assert_eq!(ulps_between(1.0, 2.0), 1 << 23);
        assert_eq!(ulps_between(f32::MAX, f32::INFINITY), 1);
        assert_eq!(ulps_between(f32::NEG_INFINITY, f32::INFINITY), 2 * 0x7f80_0000);
        assert!(ulps_between(f32::NAN, f32::INFINITY) > 1 << 20);
    }

    #[test]
    fn neighbours_are_one_step_away_and_never_negative_zero() {
        for x in [0.0, -0.0, 1e-45, -1e-45, f32::MIN_POSITIVE, 1.0, -2.0, f32::MAX, f32::MIN] {
            assert!(next_down(x) < x && x < next_up(x));
            assert_eq!((ulps_between(x, next_up(x)), ulps_between(next_down(x), x)), (1, 1));
            assert_ne!(next_up(x).to_bits(), (-0.0f32).to_bits());
        }
        assert_eq!(next_up(f32::INFINITY), f32::INFINITY);
    }
}
