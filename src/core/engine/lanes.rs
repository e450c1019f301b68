//! The vector unit: found at run time, the widest first; any narrower one can be forced.
//!
//! The engine's inner loops are plain loops over arrays of [`LANES`] numbers. They are compiled once for each unit
//! and one of these copies is called: a plain build uses what the processor has. None of them fuses a product
//! with a sum, so that all give the same bits.

/// Numbers that go through the loops together: a vector of the widest unit.
pub(super) const LANES: usize = 8;

/// One binary64 number a lane.
pub(super) type Wide = [f64; LANES];

/// A vector unit of this machine.
#[derive(Clone, Copy, Debug)]
pub struct Lanes(Unit);

#[derive(Clone, Copy, Debug)]
enum Unit {
    Baseline,
    #[cfg(target_arch = "x86_64")]
    Avx2(pulp::x86::V3),
    #[cfg(target_arch = "x86_64")]
    Avx512(pulp::x86::V4),
}

impl Lanes {
    /// Those of this machine, the narrowest first; never empty.
    pub fn all() -> Vec<Self> {
        #[cfg_attr(not(target_arch = "x86_64"), expect(unused_mut, reason = "no other units are known"))]
        let mut all = vec![Unit::Baseline];
        #[cfg(target_arch = "x86_64")]
        {
            all.extend(pulp::x86::V3::try_new().map(Unit::Avx2));
            all.extend(pulp::x86::V4::try_new().map(Unit::Avx512));
        }
        all.into_iter().map(Self).collect()
    }

    /// The widest one of this machine.
    pub fn widest() -> Self {
        Self::all().pop().unwrap_or(Self(Unit::Baseline))
    }

    /// Its name: `baseline` is what the program was built for.
    pub fn name(self) -> &'static str {
        match self.0 {
            Unit::Baseline => "baseline",
            #[cfg(target_arch = "x86_64")]
            Unit::Avx2(_) => "avx2",
            #[cfg(target_arch = "x86_64")]
            Unit::Avx512(_) => "avx512",
        }
    }

    /// Runs a copy of `work` that was compiled for this unit, as far as it is inlined.
    #[inline]
    pub(crate) fn run<R>(self, work: impl FnOnce() -> R) -> R {
        match self.0 {
            Unit::Baseline => work(),
            #[cfg(target_arch = "x86_64")]
            Unit::Avx2(unit) => pulp::Simd::vectorize(unit, work),
            #[cfg(target_arch = "x86_64")]
            Unit::Avx512(unit) => pulp::Simd::vectorize(unit, work),
        }
    }
}

impl Default for Lanes {
    fn default() -> Self {
        Self::widest()
    }
}

/// The smaller of two numbers that are not NaN, in one instruction.
#[inline(always)]
pub(crate) fn least(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The greater of two numbers that are not NaN, in one instruction.
#[inline(always)]
pub(crate) fn greatest(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The smaller of two binary32 numbers that are not NaN.
#[inline(always)]
pub(super) fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The greater of two binary32 numbers that are not NaN.
#[inline(always)]
pub(super) fn larger(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// A whole binary32 number from -2^22 to 2^22 as an integer: the low bits after adding 1.5 * 2^23.
#[inline(always)]
pub(super) fn whole(number: f32) -> u32 {
    const SHIFT: f32 = 12_582_912.0;
    (number + SHIFT).to_bits().wrapping_sub(SHIFT.to_bits())
}

/// A whole number from 0 to 2^31 as an integer: the low bits after adding 1.5 * 2^52.
#[inline(always)]
pub(super) fn integer(whole: f64) -> u32 {
    const SHIFT: f64 = 6_755_399_441_055_744.0;
    (whole + SHIFT).to_bits() as u32
}

/// All bits or none: branches on lanes become bit operations.
#[inline(always)]
pub(super) fn mask(condition: bool) -> u32 {
    u32::from(condition).wrapping_neg()
}
