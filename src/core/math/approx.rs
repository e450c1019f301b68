//! An f64 that knows how wrong it can be: the filters are built from it.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::sign::Sign;

/// The unit roundoff of f64, 2^-53: rounding to nearest changes a normal result by at most this factor.
pub(super) const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

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
            (self.value, self.value)
        } else {
            // The sums round to nearest, so the true ends are less than one step away.
            ((self.value - self.error).next_down(), (self.value + self.error).next_up())
        }
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
