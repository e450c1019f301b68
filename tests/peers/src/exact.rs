//! Rational numbers, and their nearest binary32: the oracle shares no arithmetic with any contender.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

pub type Rational = BigRational;

/// Exact; `value` is finite.
pub fn rational(value: impl Into<f64>) -> Rational {
    Rational::from_float(value.into()).expect("the workloads are finite")
}

/// The nearest binary32, ties to even; zero is +0.
pub fn nearest(value: &Rational) -> f32 {
    if value.is_zero() {
        return 0.0;
    }
    // Within a few units; then the neighbours are compared exactly.
    let guess = value.to_f64().expect("the workloads are of moderate size") as f32;
    let distance = |candidate: f32| {
        let difference = rational(candidate) - value;
        if difference < Rational::zero() { -difference } else { difference }
    };
    let candidates = [guess, guess.next_down(), guess.next_up()];
    let least = candidates.iter().map(|&c| distance(c)).min().expect("there are three");
    let mut nearest = candidates.into_iter().filter(|&c| distance(c) == least);
    let first = nearest.next().expect("one has the least distance");
    match nearest.next() {
        Some(second) if first.to_bits() & 1 == 1 => second,
        _ => first,
    }
}

/// `a + t (b - a)`.
pub fn between(a: &Rational, b: &Rational, t: &Rational) -> Rational {
    a + t * (b - a)
}

pub fn integer(value: i32) -> Rational {
    Rational::from_integer(BigInt::from(value))
}
