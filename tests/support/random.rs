//! Inputs that are the same on every run and machine.

/// xorshift64*.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub(crate) fn bits(&mut self) -> u32 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 32) as u32
    }

    /// Uniform in `0..n`.
    pub(crate) fn below(&mut self, n: u32) -> u32 {
        ((u64::from(self.bits()) * u64::from(n)) >> 32) as u32
    }

    pub(crate) fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len() as u32) as usize]
    }

    /// Uniform in `low..high`, on a grid of 1/64, so that borders and centres are hit exactly.
    pub(crate) fn grid(&mut self, low: i32, high: i32) -> f32 {
        low as f32 + self.below((high - low) as u32 * 64) as f32 / 64.0
    }

    /// Uniform in `low..high`.
    pub(crate) fn uniform(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.bits() >> 8) as f32 / (1 << 24) as f32
    }

    /// Any finite binary32: every exponent, denormals and zeros included.
    pub(crate) fn any(&mut self) -> f32 {
        loop {
            let value = f32::from_bits(self.bits());
            if value.is_finite() {
                return value;
            }
        }
    }

    /// `value`, or a neighbour one or two ULP beside it.
    pub(crate) fn near(&mut self, value: f32) -> f32 {
        match self.below(5) {
            0 => value.next_up(),
            1 => value.next_down(),
            2 => value.next_up().next_up(),
            _ => value,
        }
    }
}
