//! In which arithmetic an algorithm runs: exactly, or rounding as the lecture does.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use serde::{Deserialize, Serialize};

/// The arithmetic a stage computes in; part of the document, one choice per stage.
///
/// `F32` and `F64` follow the textbook's order of operations and round after each; f64 results are
/// rounded to f32 at the end of the stage. Fixed point exists for scan conversion only: it snaps the
/// vertices and is exact then, so that everything else is exact in it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Arithmetic {
    /// As if in real numbers, rounded once at the end of the stage.
    #[default]
    Exact,
    /// Binary32 throughout, as taught.
    F32,
    /// Binary64 throughout, as taught.
    F64,
    /// Fixed point with eight fractional bits, as graphics hardware snaps vertices.
    #[serde(rename = "fixed-8")]
    Fixed8,
    /// Fixed point with four fractional bits, as older graphics hardware.
    #[serde(rename = "fixed-4")]
    Fixed4,
    /// Whole pixels: no fractional bit.
    #[serde(rename = "fixed-0")]
    Fixed0,
}

impl Arithmetic {
    /// Every arithmetic, in the order in which menus show them.
    pub const ALL: [Self; 6] = [Self::Exact, Self::F32, Self::F64, Self::Fixed8, Self::Fixed4, Self::Fixed0];

    /// The name on the command line and in documents.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::Fixed8 => "fixed-8",
            Self::Fixed4 => "fixed-4",
            Self::Fixed0 => "fixed-0",
        }
    }

    /// Whether nothing is rounded in it but, by fixed point, the vertices of scan conversion.
    #[must_use]
    pub const fn is_exact(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }

    /// Fractional bits of the vertices of scan conversion; `None`: they are not snapped.
    #[must_use]
    pub const fn sub_pixel_bits(self) -> Option<u8> {
        match self {
            Self::Exact | Self::F32 | Self::F64 => None,
            Self::Fixed8 => Some(8),
            Self::Fixed4 => Some(4),
            Self::Fixed0 => Some(0),
        }
    }

    /// A coordinate in pixels as scan conversion takes it: the nearest multiple of 1/2^bits, ties to
    /// even, or the coordinate itself. Exact, since every f32 from 2^24 on is a whole number; zero is
    /// always 0.0.
    #[must_use]
    pub fn snap(self, coordinate: f32) -> f32 {
        match self.sub_pixel_bits() {
            Some(bits) if coordinate.abs() < 16_777_216.0 => {
                let steps = f32::from(1_u16 << bits);
                (coordinate * steps).round_ties_even() / steps + 0.0
            }
            _ => coordinate,
        }
    }

    /// Message id of its name.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Exact => "word-arithmetic-exact",
            Self::F32 => "word-arithmetic-f32",
            Self::F64 => "word-arithmetic-f64",
            Self::Fixed8 => "word-arithmetic-fixed-8",
            Self::Fixed4 => "word-arithmetic-fixed-4",
            Self::Fixed0 => "word-arithmetic-fixed-0",
        }
    }

    /// The arithmetic called `name`, or `None`; the inverse of [`name`](Self::name).
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|arithmetic| arithmetic.name() == name)
    }
}

/// A floating-point type to write an "as taught" algorithm in, once for f32 and f64.
///
/// It has no fused multiply-add on purpose: fusing changes results, and not on every machine.
pub trait Real:
    Copy
    + PartialOrd
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;

    /// Half of it, exact above the subnormal numbers: in binary a shift, not a division.
    #[must_use]
    fn half(self) -> Self {
        self / (Self::ONE + Self::ONE)
    }

    /// The square root, rounded correctly.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Converts from f32; exact in both types.
    #[must_use]
    fn from_f32(value: f32) -> Self;

    /// Rounds to the nearest f32, ties to even; overflows to infinity.
    #[must_use]
    fn to_f32(self) -> f32;

    /// Converts to f64; exact in both types.
    #[must_use]
    fn to_f64(self) -> f64;
}

impl Real for f32 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    #[inline]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline]
    fn from_f32(value: f32) -> Self {
        value
    }

    #[inline]
    fn to_f32(self) -> f32 {
        self
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self.into()
    }
}

impl Real for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    #[inline]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline]
    fn from_f32(value: f32) -> Self {
        Self::from(value)
    }

    #[inline]
    fn to_f32(self) -> f32 {
        self as f32
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_the_serialized_form_and_parse_back() {
        for arithmetic in Arithmetic::ALL {
            let json = serde_json::to_string(&arithmetic).unwrap();
            assert_eq!(json, format!("\"{}\"", arithmetic.name()));
            assert_eq!(serde_json::from_str::<Arithmetic>(&json).unwrap(), arithmetic);
            assert_eq!(Arithmetic::from_name(arithmetic.name()), Some(arithmetic));
        }
        assert_eq!(Arithmetic::from_name("f16"), None);
        assert_eq!(Arithmetic::default(), Arithmetic::Exact);
    }

    #[test]
    fn one_source_serves_both_types() {
        fn third<T: Real>() -> f32 {
            (T::ONE / (T::ONE + T::ONE + T::from_f32(1.0)) - T::ZERO).to_f32()
        }
        assert_eq!(third::<f32>(), 1.0 / 3.0);
        assert_eq!(third::<f64>(), 1.0 / 3.0);
        assert_eq!(f64::MAX.to_f32(), f32::INFINITY);
    }
}
