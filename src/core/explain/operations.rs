//! What a run costs, counted in operations on numbers.

use std::ops::{Add, AddAssign};

/// Operations on coordinates and depths, as a listing states them in rounded arithmetic; additions,
/// loop counters and bits are not counted. What exact arithmetic adds to that, a
/// [`Tally`](crate::math::Tally) counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Of two numbers with each other, or of one with zero.
    pub comparisons: u64,
    /// Products.
    pub multiplications: u64,
    /// Quotients.
    pub divisions: u64,
}

impl Operations {
    /// Nothing is computed.
    pub const NONE: Self = Self::new(0, 0, 0);

    /// Comparisons, multiplications and divisions.
    pub const fn new(comparisons: u64, multiplications: u64, divisions: u64) -> Self {
        Self { comparisons, multiplications, divisions }
    }
}

impl Add for Operations {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            comparisons: self.comparisons + other.comparisons,
            multiplications: self.multiplications + other.multiplications,
            divisions: self.divisions + other.divisions,
        }
    }
}

impl AddAssign for Operations {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
