//! Integers times powers of two: exact arithmetic on floating-point numbers, of any size.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use dashu_int::{IBig, UBig};

use super::{nearest, sign::Sign};

/// A number `mantissa * 2^exponent`, without error and without limit.
///
/// Every finite float is one, and so are sums, differences and products of these: whatever a stage
/// computes without dividing. It serves the exact tails and, in tests, the oracles.
///
/// Cost: some 10 ns an operation; beyond 128 bits each allocates.
#[derive(Clone, Debug, Default)]
pub struct Dyadic {
    pub(super) mantissa: IBig,
    pub(super) exponent: i64,
}

impl Dyadic {
    /// Zero; also the default.
    #[must_use]
    pub fn zero() -> Self {
        Self::default()
    }

    /// One.
    #[must_use]
    pub fn one() -> Self {
        Self::from(1)
    }

    /// The sign.
    #[must_use]
    pub fn sign(&self) -> Sign {
        match self.mantissa.cmp(&IBig::ZERO) {
            Ordering::Less => Sign::Negative,
            Ordering::Equal => Sign::Zero,
            Ordering::Greater => Sign::Positive,
        }
    }

    /// Whether this is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.sign().is_zero()
    }

    /// The magnitude.
    #[must_use]
    pub fn abs(&self) -> Self {
        Self { mantissa: magnitude(self).into(), exponent: self.exponent }
    }

    /// `self * 2^power`, at the cost of a copy.
    #[must_use]
    pub fn mul_pow2(&self, power: i32) -> Self {
        Self { mantissa: self.mantissa.clone(), exponent: self.exponent + i64::from(power) }
    }

    /// The nearest f64, ties to even; overflows to infinity, zero is 0.0. For display.
    #[must_use]
    pub fn to_f64_nearest(&self) -> f64 {
        nearest::quotient_to_f64(self, &Self::one())
    }

    /// Rounds `num / den` to the nearest f32, ties to even.
    ///
    /// `den` is not zero (the result would be NaN). Subnormal results are rounded once like all others.
    /// From 2^128 - 2^103 on, half a step beyond `f32::MAX`, the result is infinite. -0.0 is never returned.
    ///
    /// *Source:* IEEE 754-2019, sections 4.3.1 and 7.4; deviation: the sign of zero.
    #[must_use]
    pub fn ratio_to_f32(num: &Self, den: &Self) -> f32 {
        nearest::rounded(num, den, 24, -149, 104) as f32
    }

    /// Rounds `num / den` to an unsigned normalized code: `floor(max num / den + 1/2)` within `0..=max`.
    ///
    /// `den` is not zero (the result would be 0).
    ///
    /// *Source:* Direct3D 11.3 functional specification, section 3.2.3 (FLOAT to UNORM).
    #[must_use]
    pub fn ratio_to_code(num: &Self, den: &Self, max: u32) -> u32 {
        if !(num.sign() * den.sign()).is_positive() {
            return 0;
        }
        let (num, den) = (num.abs(), den.abs());
        if num >= den {
            return max;
        }
        // floor(max n / d + 1/2) = floor((2 max n + d) / 2d), now on integers.
        let (num, den) = aligned(&(&num.mul_pow2(1) * &Self::from(max) + &den), &den.mul_pow2(1));
        u32::try_from(&(num / den)).unwrap_or(max)
    }
}

/// The mantissas of `a` and `b` for their smaller exponent.
fn aligned(a: &Dyadic, b: &Dyadic) -> (IBig, IBig) {
    let shift = a.exponent.abs_diff(b.exponent) as usize;
    if a.exponent < b.exponent {
        (a.mantissa.clone(), &b.mantissa << shift)
    } else {
        (&a.mantissa << shift, b.mantissa.clone())
    }
}

/// The mantissa without its sign.
pub(super) fn magnitude(number: &Dyadic) -> UBig {
    number.mantissa.clone().into_parts().1
}

/// Exact. Finite numbers only; infinity and NaN are read as if the exponent range went on.
impl From<f64> for Dyadic {
    fn from(value: f64) -> Self {
        let bits = value.to_bits();
        let field = (bits >> 52 & 0x7ff) as i64;
        let fraction = bits & ((1 << 52) - 1);
        let significand = if field == 0 { fraction } else { fraction | 1 << 52 };
        if significand == 0 {
            return Self::zero();
        }
        // Odd mantissas keep the sums of small integers small.
        let zeros = significand.trailing_zeros();
        let magnitude = IBig::from(significand >> zeros);
        Self {
            mantissa: if value.is_sign_negative() { -magnitude } else { magnitude },
            exponent: field.max(1) - 1075 + i64::from(zeros),
        }
    }
}

/// Exact. Finite numbers only.
impl From<f32> for Dyadic {
    fn from(value: f32) -> Self {
        Self::from(f64::from(value))
    }
}

impl From<i32> for Dyadic {
    fn from(value: i32) -> Self {
        Self { mantissa: IBig::from(value), exponent: 0 }
    }
}

impl From<u32> for Dyadic {
    fn from(value: u32) -> Self {
        Self { mantissa: IBig::from(value), exponent: 0 }
    }
}

impl PartialEq for Dyadic {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Dyadic {}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Dyadic {
    fn cmp(&self, other: &Self) -> Ordering {
        let (a, b) = aligned(self, other);
        a.cmp(&b)
    }
}

impl Add for &Dyadic {
    type Output = Dyadic;

    fn add(self, other: Self) -> Dyadic {
        let (a, b) = aligned(self, other);
        Dyadic { mantissa: a + b, exponent: self.exponent.min(other.exponent) }
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;

    fn sub(self, other: Self) -> Dyadic {
        let (a, b) = aligned(self, other);
        Dyadic { mantissa: a - b, exponent: self.exponent.min(other.exponent) }
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;

    fn mul(self, other: Self) -> Dyadic {
        Dyadic { mantissa: &self.mantissa * &other.mantissa, exponent: self.exponent + other.exponent }
    }
}

impl Neg for &Dyadic {
    type Output = Dyadic;

    fn neg(self) -> Dyadic {
        Dyadic { mantissa: -&self.mantissa, exponent: self.exponent }
    }
}

impl Neg for Dyadic {
    type Output = Self;

    fn neg(self) -> Self {
        -&self
    }
}

/// The other three mixtures of values and references.
macro_rules! by_value {
    ($($operator:ident, $method:ident;)*) => {$(
        impl $operator for Dyadic {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                (&self).$method(&other)
            }
        }

        impl $operator<&Self> for Dyadic {
            type Output = Self;

            fn $method(self, other: &Self) -> Self {
                (&self).$method(other)
            }
        }

        impl $operator<Dyadic> for &Dyadic {
            type Output = Dyadic;

            fn $method(self, other: Dyadic) -> Dyadic {
                self.$method(&other)
            }
        }
    )*};
}

by_value! {
    Add, add;
    Sub, sub;
    Mul, mul;
}

#[cfg(test)]
mod tests {
    use super::super::testing::Xorshift;
    use super::*;

    #[test]
    fn sums_and_products_round_like_ieee_754() {
        let rng = Xorshift::new(754);
        for round in 0..30_000 {
            // Every bit pattern, and pairs of similar exponents.
            let [a, b] = if round % 2 == 0 {
                [rng.bits(), rng.bits()].map(f64::from_bits).map(|x| if x.is_finite() { x } else { 0.0 })
            } else {
                [rng.wide_f64(540), rng.wide_f64(540)]
            };
            let [x, y] = [a, b].map(Dyadic::from);
            assert_eq!(x.to_f64_nearest(), a);
            assert_eq!((&x + &y).to_f64_nearest(), a + b);
            assert_eq!((&x - &y).to_f64_nearest(), a - b);
            assert_eq!((&x * &y).to_f64_nearest(), a * b, "{a:e} * {b:e}");
            assert_eq!(x.cmp(&y), a.partial_cmp(&b).unwrap());
            assert_eq!((-&x).sign(), Sign::of(-a));
            assert_eq!(x.abs(), Dyadic::from(a.abs()));
        }
    }

    #[test]
    fn integers_and_powers_of_two_are_what_they_say() {
        assert_eq!(Dyadic::from(-12), Dyadic::from(-1.5f32).mul_pow2(3));
        assert_eq!(Dyadic::from(u32::MAX) + Dyadic::one(), Dyadic::one().mul_pow2(32));
        assert!((Dyadic::from(3) - Dyadic::from(3u32)).is_zero());
        assert_eq!(Dyadic::from(1e-45f32), Dyadic::one().mul_pow2(-149));
    }

    #[test]
    fn quotients_of_f32_round_like_ieee_754() {
        let rng = Xorshift::new(32);
        for _ in 0..50_000 {
            let (a, b) = (rng.any_f32(), rng.any_f32());
            if b != 0.0 {
                let rounded = Dyadic::ratio_to_f32(&a.into(), &b.into());
                assert_eq!(rounded.to_bits(), (a / b + 0.0).to_bits(), "{a:e} / {b:e}");
            }
        }
        assert!(Dyadic::ratio_to_f32(&Dyadic::one(), &Dyadic::zero()).is_nan());
        let tiny = Dyadic::one().mul_pow2(-400);
        assert_eq!(Dyadic::ratio_to_f32(&-tiny, &Dyadic::one()).to_bits(), 0);
    }

    /// The number an f32 stands for when results are compared: infinity for the next power of two.
    fn position(x: f32) -> Dyadic {
        if x.is_infinite() { Dyadic::from(x.signum()).mul_pow2(128) } else { Dyadic::from(x) }
    }

    #[test]
    fn no_f32_is_nearer_than_the_rounded_quotient_and_ties_are_even() {
        let rng = Xorshift::new(24);
        for _ in 0..20_000 {
            // A denominator of many bits times a midpoint of two f32, and just off it.
            let [a, b, c] = std::array::from_fn(|_| Dyadic::from(rng.any_f32()));
            let den = a * b + c;
            let below = rng.pick(&[rng.any_f32(), 0.0, 1.0, f32::MAX, -f32::MAX, f32::MIN_POSITIVE]);
            let middle = (position(below) + position(below.next_up())).mul_pow2(-1);
            let off = Dyadic::from(rng.pick(&[-1, 0, 0, 1])).mul_pow2(-600);
            let num = &den * &middle + off;
            if den.is_zero() {
                continue;
            }
            let r = Dyadic::ratio_to_f32(&num, &den);
            let distance = |x: f32| (&num - &den * position(x)).abs();
            for neighbour in [r.next_up(), r.next_down()] {
                let order = distance(r).cmp(&distance(neighbour));
                assert!(order.is_lt() || order.is_eq() && (r.to_bits() & 1 == 0 || r == neighbour), "{r:e}");
            }
        }
    }

    #[test]
    fn codes_are_the_nearest_and_half_way_goes_up() {
        let rng = Xorshift::new(255);
        let two = Dyadic::from(2);
        for _ in 0..20_000 {
            let max = rng.pick(&[1, 3, 255, 65_535, 16_777_215, u32::MAX]);
            let scale = Dyadic::from(rng.any_f32());
            if scale.is_zero() {
                continue;
            }
            // (2 code + 1) / (2 max) is the step from `code` to the next; -1, 0, 1 is where we are beside it.
            let code = rng.below(max);
            let side = rng.pick(&[-1, 0, 1]);
            let step = (&two * Dyadic::from(code) + Dyadic::one()) * &scale;
            let num = step + Dyadic::from(side).mul_pow2(-700) * &scale;
            let den = &two * Dyadic::from(max) * &scale;
            assert_eq!(Dyadic::ratio_to_code(&num, &den, max), code + u32::from(side >= 0));
            assert_eq!(Dyadic::ratio_to_code(&-&num, &den, max), 0);
            assert_eq!(Dyadic::ratio_to_code(&den, &num, max), max);
        }
        assert_eq!(Dyadic::ratio_to_code(&Dyadic::one(), &Dyadic::zero(), 255), 0);
    }
}
