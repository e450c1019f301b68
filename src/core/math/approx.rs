//! An f64 that knows how wrong it can be: the filters are built from it.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::sign::Sign;

/// The unit roundoff of f64, 2^-53: rounding to nearest changes a normal result by at most this factor.
pub(crate) const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// Makes up for the roundings within the computation of a bound.
///
/// Each bound below is computed with at most 9 roundings, each of which makes it too small by a factor
/// of no less than 1 - u; and (1 - u)^9 (1 + 16u) > 1 for u = 2^-53.
const ROUND_UP: f64 = 1.0 + 16.0 * UNIT_ROUNDOFF;

/// Makes up for underflow within the computation of a bound: at most 6 times 2^-1075, far below this.
const UNDERFLOW: f64 = f64::MIN_POSITIVE;

/// A real number known up to an error: it lies within `value - error ..= value + error`.
///
/// `+`, `-`, `*`, `/` propagate the errors of the operands and add their own rounding, so that a filter
/// reads like the formula it is for. The bounds are proven, never estimated. A bound that is infinite or
/// NaN says that nothing is known; overflow and division by an interval around zero end there, and so
/// does all that is computed from it.
///
/// Cost: an addition takes about 5 floating-point operations, a product 8, a quotient 10.
///
/// *Source:* running error analysis, Wilkinson 1963; Higham, Accuracy and Stability of Numerical
/// Algorithms, 2nd ed. 2002, section 3.3. Deviation: the bounds' own roundings are covered, too.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Approx {
    /// The number, nearly.
    pub value: f64,
    /// The largest possible distance to the number itself; not negative.
    pub error: f64,
}

impl Approx {
    /// Nothing is known.
    pub const UNKNOWN: Self = Self { value: 0.0, error: f64::INFINITY };

    /// The number `value` itself, without error; `value` is finite.
    #[inline]
    #[must_use]
    pub const fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// The product of two f32, which f64 holds without error (24 + 24 bits of 53).
    #[inline]
    #[must_use]
    pub fn product(a: f32, b: f32) -> Self {
        Self::exact(f64::from(a) * f64::from(b))
    }

    /// The sign, if the error leaves only one.
    #[inline]
    #[must_use]
    pub fn sign(self) -> Option<Sign> {
        let certain = self.value.abs() > self.error || (self.value == 0.0 && self.error == 0.0);
        certain.then_some(Sign::of(self.value))
    }

    /// Two f64 that enclose the number: the lower and the upper end, rounded outward.
    ///
    /// If nothing is known, these are infinite or NaN.
    #[inline]
    #[must_use]
    pub fn bounds(self) -> (f64, f64) {
        if self.error == 0.0 {
            return (self.value, self.value);
        }
        // The two sums below round by at most u (|value| + slack). Asking for twice u |value| covers
        // that, and the factor the rest and the roundings of the slack itself. (Stepping to the
        // neighbouring f64 would do, too, but costs more than all the rest of a filter.)
        let slack = (self.error + 2.0 * UNIT_ROUNDOFF * self.value.abs()) * ROUND_UP;
        (self.value - slack, self.value + slack)
    }
}

/// Exact.
impl From<f32> for Approx {
    #[inline]
    fn from(value: f32) -> Self {
        Self::exact(f64::from(value))
    }
}

/// Exact.
impl Neg for Approx {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, error: self.error }
    }
}

/// `|(a + da) + (b + db) - fl(a + b)| <= |da| + |db| + u |fl(a + b)|`.
///
/// No allowance for underflow: a sum of f64 below 2^-1021 is exact, and above that half an ulp of the
/// sum, 2^(E-53), is a number, so that `u |sum|` does not round below it. So a difference of equals has
/// no error of its own.
impl Add for Approx {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        let error = (self.error + other.error + UNIT_ROUNDOFF * value.abs()) * ROUND_UP;
        Self { value, error }
    }
}

/// As for addition.
impl Sub for Approx {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// `|(a + da) (b + db) - fl(a b)| <= (|a| + |da|) |db| + |b| |da| + u |fl(a b)|`, and underflow.
impl Mul for Approx {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        let inherited = (self.value.abs() + self.error) * other.error + other.value.abs() * self.error;
        Self { value, error: (inherited + UNIT_ROUNDOFF * value.abs()) * ROUND_UP + UNDERFLOW }
    }
}

/// `|(a + da) / (b + db) - fl(a / b)| <= (|da| + |a / b| |db|) / (|b| - |db|) + u |fl(a / b)|`.
///
/// [`UNKNOWN`](Self::UNKNOWN) if the denominator can be zero.
impl Div for Approx {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let least = other.value.abs() - other.error;
        if least > 0.0 {
            let value = self.value / other.value;
            // A quotient or a product that underflows is off by 2^-1075 before it is divided by `least`.
            let inherited = (self.error + (value.abs() + UNDERFLOW) * other.error + UNDERFLOW) / least;
            Self { value, error: (inherited + UNIT_ROUNDOFF * value.abs()) * ROUND_UP + UNDERFLOW }
        } else {
            Self::UNKNOWN
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::dyadic::Dyadic;
    use super::super::testing::{Xorshift, holds};
    use super::*;

    /// A number that is exact, at an end of its error or within, and what is known of it.
    fn operand(rng: &Xorshift, limit: u32) -> (Dyadic, Approx) {
        let value = rng.pick(&[rng.wide_f64(limit), rng.wide_f64(limit), rng.wide_f64(2), 0.0]);
        let scale = rng.pick(&[0.0, 1e-16, 1e-8, 0.5, 2.0]);
        let error = rng.pick(&[scale * value.abs(), rng.wide_f64(limit).abs() * scale]);
        let place = rng.pick(&[-1.0, -0.75, 0.0, 1.0]);
        let number = Dyadic::from(value) + Dyadic::from(place) * Dyadic::from(error);
        (number, Approx { value, error })
    }

    #[test]
    fn every_operation_bounds_its_error() {
        let rng = Xorshift::new(1963);
        // Up to the ends of the exponent range: bounds hold when results overflow and underflow, too.
        for limit in [2, 30, 500, 1020] {
            for _ in 0..10_000 {
                let ((x, a), (y, b)) = (operand(&rng, limit), operand(&rng, limit));
                for (approx, exact) in [(a + b, &x + &y), (a - b, &x - &y), (a * b, &x * &y), (-a, -&x)] {
                    let known = approx.error.is_finite() && approx.value.is_finite();
                    assert!(!known || holds(approx, &exact), "{a:?} {b:?} {approx:?}");
                    assert!(!known || approx.sign().is_none_or(|sign| sign == exact.sign()));
                    assert!(known || limit > 500);
                }
                let quotient = a / b;
                if quotient.error.is_finite() && quotient.value.is_finite() {
                    assert!(!y.is_zero());
                    let off = (x - Dyadic::from(quotient.value) * &y).abs();
                    assert!(off <= Dyadic::from(quotient.error) * y.abs(), "{a:?} / {b:?} {quotient:?}");
                }
            }
        }
    }

    #[test]
    fn bounds_are_tight_enough_to_be_of_use() {
        let rng = Xorshift::new(53);
        for _ in 0..1000 {
            let [a, b] = std::array::from_fn(|_| Approx::exact(rng.wide_f64(100)));
            for approx in [a + b, a - b, a * b, a / b] {
                assert!(approx.error <= 1.2e-16 * approx.value.abs());
            }
            assert_eq!(a - a, Approx::exact(0.0));
        }
    }

    #[test]
    fn bounds_enclose_the_number() {
        let rng = Xorshift::new(8);
        for _ in 0..10_000 {
            let (number, approx) = operand(&rng, 300);
            let (low, high) = approx.bounds();
            assert!(Dyadic::from(low) <= number && number <= Dyadic::from(high));
        }
        assert_eq!(Approx::exact(0.1).bounds(), (0.1, 0.1));
    }

    #[test]
    fn nothing_is_known_after_division_by_an_interval_around_zero() {
        let around_zero = Approx { value: 1.0, error: 1.0 };
        for unknown in [Approx::exact(1.0) / around_zero, Approx::exact(0.0) / Approx::exact(0.0)] {
            assert_eq!(unknown, Approx::UNKNOWN);
            assert_eq!((unknown * Approx::exact(0.0) + Approx::from(1.0)).sign(), None);
            assert_eq!((Approx::product(1.0, 2.0) / unknown).sign(), None);
        }
    }
}
