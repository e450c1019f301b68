//! Exact sums of f64 on the stack: floating-point expansions.
//!
//! An expansion is a sum of f64 whose bits do not overlap, in ascending order of magnitude, so that its
//! last component outweighs all others and has the sign of the whole.
//!
//! The transformations below are exact unless an operation overflows or underflows. Neither can happen to
//! sums of products of at most three f32: an f32 is a multiple of 2^-149 below 2^128, so all these numbers
//! and all their rounding errors are multiples of 2^-447, which is far above the least f64 (2^-1074), and
//! even the sum of 2^100 of them lies below 2^484, far below the greatest (2^1024). Splitting scales by
//! 2^27 + 1 in between and changes nothing of that.
//!
//! *Source:* Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates,
//! 1997, sections 2.2 to 2.5; Knuth, The Art of Computer Programming 2, section 4.2.2; Dekker, A
//! Floating-Point Technique for Extending the Available Precision, 1971.

use super::approx::Approx;
use super::sign::Sign;

/// Adds exactly: `a + b = sum + tail`, where `sum` is the rounded sum.
///
/// Valid unless `a + b` overflows. Six operations, no condition on the magnitudes.
///
/// *Source:* Knuth, theorem 4.2.2 B; Shewchuk 1997, theorem 7 (TWO-SUM).
#[inline]
#[must_use]
pub fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_virtual = sum - a;
    let a_virtual = sum - b_virtual;
    (sum, (a - a_virtual) + (b - b_virtual))
}

/// Subtracts exactly: `a - b = difference + tail`, where `difference` is the rounded difference.
///
/// Valid unless `a - b` overflows. *Source:* Shewchuk 1997, section 2.3 (TWO-DIFF).
#[inline]
#[must_use]
pub fn two_diff(a: f64, b: f64) -> (f64, f64) {
    two_sum(a, -b)
}

/// Splits into two halves of at most 26 bits, high and low: `a = high + low`.
///
/// Valid for `|a| < 2^996`. The product of two halves is exact.
///
/// *Source:* Dekker 1971; Shewchuk 1997, theorem 17 (SPLIT).
#[inline]
#[must_use]
pub fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2^27 + 1
    let scaled = SPLITTER * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// Multiplies exactly: `a b = product + tail`, where `product` is the rounded product.
///
/// Valid for `|a|, |b| < 2^996` whose product neither overflows nor has bits below 2^-1074. Seventeen
/// operations: a fused multiply-add would do it in two, but is a slow library call where the processor
/// lacks it.
///
/// *Source:* Dekker 1971; Shewchuk 1997, theorem 18 (TWO-PRODUCT).
#[inline]
#[must_use]
pub fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    let rest = product - a_high * b_high - a_low * b_high - a_high * b_low;
    (product, a_low * b_low - rest)
}

/// A sum of at most `N` f64, held without error and without allocation.
///
/// Valid range: see the module. Zero components are dropped, so that sums which cancel stay short.
#[derive(Clone, Copy, Debug)]
pub struct Expansion<const N: usize> {
    /// The first `len` are not zero, do not overlap, and ascend in magnitude.
    components: [f64; N],
    len: usize,
}

impl<const N: usize> Expansion<N> {
    /// Zero.
    pub const ZERO: Self = Self { components: [0.0; N], len: 0 };

    /// The exact sum of `terms`. Cost: about 3 N^2 operations, fewer if terms cancel.
    #[inline]
    #[must_use]
    pub fn sum_of(terms: [f64; N]) -> Self {
        let mut sum = Self::ZERO;
        for term in terms {
            sum.grow(term);
        }
        sum
    }

    /// Adds `term`. There is room for `N` terms from zero on.
    ///
    /// # Panics
    ///
    /// If more than `N` components would be needed; not before the `N + 1`st term.
    /// [`sum_of`](Self::sum_of) cannot panic.
    ///
    /// *Source:* Shewchuk 1997, theorem 10 (GROW-EXPANSION) with zero elimination.
    #[inline]
    pub fn grow(&mut self, term: f64) {
        let mut sum = term;
        let mut kept = 0;
        for i in 0..self.len {
            let (next, tail) = two_sum(sum, self.components[i]);
            sum = next;
            if tail != 0.0 {
                self.components[kept] = tail;
                kept += 1;
            }
        }
        if sum != 0.0 {
            self.components[kept] = sum;
            kept += 1;
        }
        self.len = kept;
    }

    /// The components: not zero, not overlapping, ascending in magnitude; none for zero.
    #[inline]
    #[must_use]
    pub fn components(&self) -> &[f64] {
        &self.components[..self.len]
    }

    /// The exact sign: that of the greatest component, which outweighs the rest.
    #[inline]
    #[must_use]
    pub fn sign(&self) -> Sign {
        self.components().last().map_or(Sign::Zero, |&greatest| Sign::of(greatest))
    }

    /// The sum in f64, with a proven bound of its error; exact for fewer than two components.
    ///
    /// Components hardly cancel, so that the bound is a few units in the last place.
    ///
    /// *Source:* Shewchuk 1997, section 2.7 (APPROXIMATE).
    #[inline]
    #[must_use]
    pub fn approx(&self) -> Approx {
        let mut components = self.components().iter().copied().map(Approx::exact);
        let first = components.next().unwrap_or_default();
        components.fold(first, |sum, component| sum + component)
    }

    /// The sum in f64, added up from the least component on; [`approx`](Self::approx) bounds its error.
    #[inline]
    #[must_use]
    pub fn estimate(&self) -> f64 {
        self.approx().value
    }
}

#[cfg(test)]
mod tests {
    use super::super::dyadic::Dyadic;
    use super::super::testing::{Xorshift, holds};
    use super::*;

    fn exact_sum(terms: &[f64]) -> Dyadic {
        terms.iter().fold(Dyadic::zero(), |sum, &term| sum + Dyadic::from(term))
    }

    /// The value of the last bit of `x` that is set.
    fn last_bit(x: f64) -> f64 {
        let zeros = u64::from((x.to_bits() | 1 << 52).trailing_zeros());
        f64::from_bits(((x.to_bits() >> 52 & 0x7ff) - 52 + zeros) << 52)
    }

    #[test]
    fn transformations_lose_nothing() {
        let rng = Xorshift::new(1971);
        for _ in 0..20_000 {
            let (a, b) = (rng.wide_f64(300), rng.wide_f64(140));
            let [x, y] = [a, b].map(Dyadic::from);
            let (sum, tail) = two_sum(a, b);
            assert_eq!((sum, exact_sum(&[sum, tail])), (a + b, &x + &y));
            let (difference, tail) = two_diff(a, b);
            assert_eq!((difference, exact_sum(&[difference, tail])), (a - b, &x - &y));
            let (product, tail) = two_product(a, b);
            assert_eq!((product, exact_sum(&[product, tail])), (a * b, &x * &y));
            let (high, low) = split(a);
            assert_eq!(exact_sum(&[high, low]), x);
            assert_eq!([high * high, low * low, high * low].map(Dyadic::from), {
                let [h, l] = [high, low].map(Dyadic::from);
                [&h * &h, &l * &l, &h * &l]
            });
        }
    }

    #[test]
    fn sums_are_exact_ordered_and_free_of_zeros() {
        let rng = Xorshift::new(1997);
        for round in 0..20_000 {
            // Terms in pairs that nearly cancel, over many or few exponents.
            let mut terms = [0.0; 8];
            for pair in terms.chunks_exact_mut(2) {
                pair[0] = rng.wide_f64([3, 60, 390][round % 3]);
                pair[1] = rng.pick(&[0.0, -pair[0], -pair[0].next_up(), rng.wide_f64(60)]);
            }
            let sum = Expansion::sum_of(terms);
            let exact = exact_sum(&terms);
            assert_eq!(exact_sum(sum.components()), exact);
            assert_eq!(sum.sign(), exact.sign());
            assert!(sum.components().iter().all(|&component| component != 0.0));
            assert!(sum.components().is_sorted_by(|low, high| low.abs() < last_bit(*high)));
            assert!(holds(sum.approx(), &exact));
            assert!(sum.approx().error <= 1e-14 * sum.estimate().abs());
        }
    }

    #[test]
    fn an_empty_sum_is_positive_zero() {
        let sum = Expansion::sum_of([1.0, 1e-300, -1.0, -1e-300]);
        assert_eq!((sum.components().len(), sum.sign()), (0, Sign::Zero));
        assert!(sum.estimate().to_bits() == 0 && Expansion::<0>::ZERO.estimate().to_bits() == 0);
    }
}
