//! Quotients of exact numbers: the rational field, in which a taught formula makes no error.
//!
//! A formula that is written once over [`Field`] runs in f32 and f64 as taught, and here without a
//! rounding. It is for what is shown step by step, one point at a time; where many values are wanted,
//! [`rounded_ratio`](super::rounded_ratio) decides nearly all of them in f64.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Dyadic, Real, nearest::quotient_to_f64};

/// Numbers with the four operations, rounded or not: what a taught formula is written in.
pub trait Field:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// Converts from f32, exactly.
    #[must_use]
    fn of(value: f32) -> Self;

    /// The nearest f32, ties to even.
    #[must_use]
    fn nearest_f32(&self) -> f32;

    /// The nearest f64, ties to even. For display.
    #[must_use]
    fn nearest_f64(&self) -> f64;
}

impl<R: Real> Field for R {
    #[inline]
    fn of(value: f32) -> Self {
        Self::from_f32(value)
    }

    #[inline]
    fn nearest_f32(&self) -> f32 {
        self.to_f32()
    }

    #[inline]
    fn nearest_f64(&self) -> f64 {
        self.to_f64()
    }
}

/// A rational number: a quotient of two exact numbers, never rounded.
///
/// A denominator of zero stays one through all that is computed from it, and its nearest float is NaN.
/// Cost: each operation is up to three products of big integers; numbers with the same denominator are
/// added without one, so that a sum of equal steps does not grow.
#[derive(Clone, Debug)]
pub struct Quotient {
    numerator: Dyadic,
    denominator: Dyadic,
}

impl Quotient {
    /// Numerator and denominator, not reduced.
    #[must_use]
    pub fn parts(&self) -> (&Dyadic, &Dyadic) {
        (&self.numerator, &self.denominator)
    }
}

impl Field for Quotient {
    fn of(value: f32) -> Self {
        Self { numerator: Dyadic::from(value), denominator: Dyadic::one() }
    }

    fn nearest_f32(&self) -> f32 {
        Dyadic::ratio_to_f32(&self.numerator, &self.denominator)
    }

    fn nearest_f64(&self) -> f64 {
        quotient_to_f64(&self.numerator, &self.denominator)
    }
}

impl Add for Quotient {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.denominator == other.denominator {
            return Self { numerator: self.numerator + other.numerator, ..self };
        }
        Self {
            numerator: self.numerator * &other.denominator + other.numerator * &self.denominator,
            denominator: self.denominator * other.denominator,
        }
    }
}

impl Sub for Quotient {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Quotient {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            numerator: self.numerator * other.numerator,
            denominator: self.denominator * other.denominator,
        }
    }
}

impl Div for Quotient {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if other.denominator.is_zero() {
            return other;
        }
        if self.denominator == other.denominator {
            return Self { numerator: self.numerator, denominator: other.numerator };
        }
        Self {
            numerator: self.numerator * &other.denominator,
            denominator: self.denominator * other.numerator,
        }
    }
}

impl Neg for Quotient {
    type Output = Self;

    fn neg(self) -> Self {
        Self { numerator: -self.numerator, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::Xorshift;
    use super::*;

    /// A formula with all four operations.
    fn mixed<N: Field>([a, b, c, d]: [f32; 4]) -> N {
        let [a, b, c, d] = [a, b, c, d].map(N::of);
        -(a.clone() * b.clone() - c.clone()) / (d.clone() + b) + a / c - d
    }

    #[test]
    fn a_formula_comes_out_as_with_one_quotient() {
        let rng = Xorshift::new(10);
        for _ in 0..2_000 {
            let numbers = std::array::from_fn(|_| rng.any_f32());
            let [a, b, c, d] = numbers.map(Dyadic::from);
            let divisor = (&d + &b) * &c;
            let dividend = (&c - &a * &b) * &c + (&a - &d * &c) * (&d + &b);
            let value = mixed::<Quotient>(numbers);
            assert_eq!(
                value.nearest_f32().to_bits(),
                Dyadic::ratio_to_f32(&dividend, &divisor).to_bits(),
                "{numbers:?}"
            );
            assert_eq!(value.nearest_f64().to_bits(), quotient_to_f64(&dividend, &divisor).to_bits());
        }
    }

    #[test]
    fn a_division_by_zero_never_becomes_a_number_again() {
        let [one, zero] = [1.0, 0.0].map(Quotient::of);
        let bad = one.clone() / zero.clone();
        let all = [
            bad.clone() + one.clone(),
            one.clone() - bad.clone(),
            bad.clone() * zero.clone(),
            one.clone() / bad.clone(),
            bad.clone() / one.clone(),
            bad.clone() / bad,
            zero.clone() / zero,
        ];
        assert!(all.iter().all(|value| value.nearest_f32().is_nan() && value.nearest_f64().is_nan()));
    }

    #[test]
    fn equal_steps_do_not_grow() {
        let third = Quotient::of(1.0) / Quotient::of(3.0);
        let sum = (0..300).fold(Quotient::of(0.0) / Quotient::of(3.0), |sum, _| sum + third.clone());
        assert_eq!(sum.nearest_f32(), 100.0);
        assert_eq!(sum.parts().1, &Dyadic::from(3));
    }
}
