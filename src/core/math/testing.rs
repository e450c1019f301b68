//! Inputs for the tests: seeded, and chosen to break what can break.

use std::cell::Cell;

use super::dyadic::Dyadic;

/// Marsaglia's xorshift with 64 bits: the same numbers on every machine.
///
/// In a cell, so that calls nest.
pub(super) struct Xorshift(Cell<u64>);

impl Xorshift {
    pub(super) fn new(seed: u64) -> Self {
        Self(Cell::new(seed | 1))
    }

    pub(super) fn bits(&self) -> u64 {
        let mut state = self.0.get();
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        self.0.set(state);
        state.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// A whole number in `0..n`.
    pub(super) fn below(&self, n: u32) -> u32 {
        (((self.bits() >> 32) * u64::from(n)) >> 32) as u32
    }

    /// A number in `-1.0..1.0`.
    pub(super) fn unit(&self) -> f64 {
        (self.bits() >> 11) as f64 * f64::EPSILON - 1.0
    }

    pub(super) fn pick<T: Copy>(&self, from: &[T]) -> T {
        from[self.below(from.len() as u32) as usize]
    }

    /// Any finite f32 bit pattern: every exponent is as likely.
    pub(super) fn any_f32(&self) -> f32 {
        loop {
            let value = f32::from_bits(self.bits() as u32);
            if value.is_finite() {
                return value;
            }
        }
    }

    /// Any f64 bit pattern with an exponent in `-limit..=limit`.
    pub(super) fn wide_f64(&self, limit: u32) -> f64 {
        let exponent = i64::from(self.below(2 * limit + 1)) - i64::from(limit);
        f64::from_bits(self.bits() & 0x800f_ffff_ffff_ffff | ((1023 + exponent) as u64) << 52)
    }

    /// One of `value` and its two f32 neighbours; stays finite.
    fn nudge(&self, value: f32) -> f32 {
        let nudged = self.pick(&[value, value, value.next_up(), value.next_down()]);
        if nudged.is_finite() { nudged } else { value }
    }
}

/// A kind of coordinate: its name, and how to draw one.
pub(super) type Kind = (&'static str, fn(&Xorshift) -> f32);

pub(super) const KINDS: [Kind; 5] = [
    ("random", |rng| (rng.unit() * 1000.0) as f32),
    ("grid", |rng| rng.below(17) as f32 * 0.5 - 4.0),
    ("denormal", |rng| (rng.below(9) as f32 - 4.0) * 1e-45),
    ("huge", |rng| rng.pick(&[-1.0, 0.5, 0.999_999_9, 1.0]) * f32::MAX),
    ("any bits", Xorshift::any_f32),
];

/// Three vectors of independent coordinates.
pub(super) fn independent<const N: usize>(rng: &Xorshift, kind: Kind) -> [[f32; N]; 3] {
    std::array::from_fn(|_| std::array::from_fn(|_| (kind.1)(rng)))
}

/// Three vectors of which the third is nearly a combination of the first two, or is one of them, or is
/// one ULP off that: nearly collinear points (`affine`), or nearly edge-on homogeneous triangles.
pub(super) fn dependent<const N: usize>(rng: &Xorshift, kind: Kind, affine: bool) -> [[f32; N]; 3] {
    let [a, b, _] = independent(rng, kind);
    let t = rng.pick(&[0.0, 0.25, 0.5, 1.0, rng.unit().abs()]);
    let s = if affine { 1.0 - t } else { rng.unit() * (1.0 - t) };
    let c = std::array::from_fn(|i| rng.nudge((s * f64::from(a[i]) + t * f64::from(b[i])) as f32));
    let mut vectors = [a, b, c];
    vectors.rotate_left(rng.below(3) as usize);
    vectors
}

/// Whether `approx` holds for the exact number: `|exact - value| <= error`.
pub(super) fn holds(approx: super::approx::Approx, exact: &Dyadic) -> bool {
    (exact - Dyadic::from(approx.value)).abs() <= Dyadic::from(approx.error)
}
