//! Numbers that look random and are the same on every run and machine.

/// SplitMix64: 64 bits a call, about a nanosecond each.
///
/// *Source:* Steele, Lea and Flood, Fast Splittable Pseudorandom Number Generators, 2014.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The sequence that belongs to a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// Uniform in `0..n`; 0 if `n` is 0.
    pub fn below(&mut self, n: usize) -> usize {
        ((u128::from(self.bits()) * n as u128) >> 64) as usize
    }

    /// One of some; there must be one.
    pub fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len())]
    }

    /// Uniform in `low..high`, rounded to binary32.
    pub fn uniform(&mut self, low: f64, high: f64) -> f32 {
        (low + (high - low) * (self.bits() >> 11) as f64 / (1_u64 << 53) as f64) as f32
    }

    /// 10 to the power of something between `low` and `high`, of either sign.
    pub fn magnitude(&mut self, low: f64, high: f64) -> f32 {
        let size = libm::exp10(f64::from(self.uniform(low, high))) as f32;
        if self.below(2) == 0 { size } else { -size }
    }

    /// `value`, or a number up to two steps beside it.
    pub fn beside(&mut self, value: f32) -> f32 {
        let (up, down) = (value.next_up(), value.next_down());
        self.pick(&[value, up, up.next_up(), down, down.next_down()])
    }
}
