//! The sign of a number, as a type that cannot be mistaken for a number.

use std::cmp::Ordering;
use std::ops::{Mul, Neg};

/// Negative, zero or positive; ordered in that order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
pub enum Sign {
    /// Less than zero.
    Negative,
    /// Exactly zero (of either floating-point sign).
    Zero,
    /// Greater than zero.
    Positive,
}

impl Sign {
    /// The sign of `value`.
    ///
    /// Valid for every number; NaN has no sign and is never passed (it would give `Zero`).
    #[inline]
    #[must_use]
    pub const fn of(value: f64) -> Self {
        if value > 0.0 {
            Self::Positive
        } else if value < 0.0 {
            Self::Negative
        } else {
            Self::Zero
        }
    }

    /// Whether this is `Positive`.
    #[inline]
    #[must_use]
    pub const fn is_positive(self) -> bool {
        matches!(self, Self::Positive)
    }

    /// Whether this is `Zero`.
    #[inline]
    #[must_use]
    pub const fn is_zero(self) -> bool {
        matches!(self, Self::Zero)
    }

    /// Whether this is `Negative`.
    #[inline]
    #[must_use]
    pub const fn is_negative(self) -> bool {
        matches!(self, Self::Negative)
    }
}

/// `a.cmp(&b)` is the sign of `a - b`.
impl From<Ordering> for Sign {
    #[inline]
    fn from(ordering: Ordering) -> Self {
        match ordering {
            Ordering::Less => Self::Negative,
            Ordering::Equal => Self::Zero,
            Ordering::Greater => Self::Positive,
        }
    }
}

impl Neg for Sign {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        match self {
            Self::Negative => Self::Positive,
            Self::Zero => Self::Zero,
            Self::Positive => Self::Negative,
        }
    }
}

/// The sign of the product of two numbers with these signs.
impl Mul for Sign {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        match self {
            Self::Negative => -other,
            Self::Zero => Self::Zero,
            Self::Positive => other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_multiply_like_the_numbers_they_are_of() {
        let numbers = [-2.0, -0.0, 0.0, 5e-324, 3.0];
        for x in numbers {
            assert_eq!(-Sign::of(x), Sign::of(-x));
            for y in numbers.map(f64::signum).into_iter().chain([0.0]) {
                assert_eq!(Sign::of(x) * Sign::of(y), Sign::of(x * y));
            }
        }
    }

    #[test]
    fn signs_are_ordered_and_named() {
        assert!(Sign::Negative < Sign::Zero && Sign::Zero < Sign::Positive);
        assert!(Sign::of(-0.0).is_zero() && Sign::of(1.0).is_positive() && Sign::of(-1.0).is_negative());
        assert_eq!(Sign::from(1.cmp(&2)), Sign::Negative);
    }
}
