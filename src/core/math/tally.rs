//! How often the exact tail was needed: the price of exactness, counted instead of guessed.

use std::ops::AddAssign;

/// Decisions asked for, and those that the floating-point filter could not settle.
///
/// Every function that may fall back takes a `&mut Tally`; there is no global counter, so that runs can
/// be compared and tests can assert on counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Signs and roundings asked for.
    pub calls: u64,
    /// Those that needed the exact tail.
    pub exact: u64,
}

impl Tally {
    /// The share of decisions that needed the exact tail, from 0 to 1; 0 if there were none.
    #[must_use]
    pub fn share(self) -> f64 {
        if self.calls == 0 { 0.0 } else { self.exact as f64 / self.calls as f64 }
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.calls += other.calls;
        self.exact += other.exact;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tallies_add_up() {
        let mut sum = Tally::default();
        assert_eq!(sum.share(), 0.0);
        sum += Tally { calls: 3, exact: 1 };
        sum += Tally { calls: 5, exact: 1 };
        assert_eq!(sum, Tally { calls: 8, exact: 2 });
        assert_eq!(sum.share(), 0.25);
    }
}
