//! One text for every arithmetic: what the formulas of this stage need of their numbers.

use crate::math::{Approx, Dyadic, Sign, Tally};
use std::ops::{Add, Mul, Sub};

/// What a formula without a division is written in: binary32 and binary64 as taught, [`Approx`] as a
/// filter, [`Dyadic`] without an error.
pub trait Number: Clone + From<f32> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// The nearest binary64 number, to be shown.
    fn to_f64(&self) -> f64;
}

impl Number for f32 {
    fn to_f64(&self) -> f64 {
        f64::from(*self)
    }
}

impl Number for f64 {
    fn to_f64(&self) -> f64 {
        *self
    }
}

impl Number for Approx {
    fn to_f64(&self) -> f64 {
        self.value
    }
}

impl Number for Dyadic {
    fn to_f64(&self) -> f64 {
        self.to_f64_nearest()
    }
}

/// The same vector in another arithmetic; exact.
#[inline]
pub(super) fn vector<N: Number, const D: usize>(v: [f32; D]) -> [N; D] {
    v.map(N::from)
}

/// `a - b`.
#[inline]
pub(super) fn minus<N: Number>(a: &[N; 3], b: &[N; 3]) -> [N; 3] {
    [0, 1, 2].map(|i| a[i].clone() - b[i].clone())
}

/// `a x b`.
#[inline]
pub(super) fn cross<N: Number>(a: &[N; 3], b: &[N; 3]) -> [N; 3] {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]| a[i].clone() * b[j].clone() - a[j].clone() * b[i].clone())
}

/// `a . b`, summed from x to z.
#[inline]
pub(super) fn dot<N: Number>(a: &[N; 3], b: &[N; 3]) -> N {
    let product = |i: usize| a[i].clone() * b[i].clone();
    product(0) + product(1) + product(2)
}

/// The exact sign of a formula: of its filtered value, or where that is too near to zero, of the exact
/// one.
#[inline]
pub(super) fn exact_sign(filtered: Approx, exact: impl FnOnce() -> Dyadic, tally: &mut Tally) -> Sign {
    tally.calls += 1;
    filtered.sign().unwrap_or_else(|| {
        tally.exact += 1;
        exact().sign()
    })
}
