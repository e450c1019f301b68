//! In which arithmetic an algorithm runs: exactly, or rounding as the lecture does.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use serde::{Deserialize, Serialize};

/// The arithmetic a stage computes in; part of the document, one choice per stage.
///
/// `F32` and `F64` follow the textbook's order of operations and round after each; f64 results are
/// rounded to f32 at the end of the stage. `Fixed8` has eight fractional bits and exists for scan
/// conversion only.
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
}

impl Arithmetic {
    /// Every arithmetic, in the order in which menus show them.
    pub const ALL: [Self; 4] = [Self::Exact, Self::F32, Self::F64, Self::Fixed8];

    /// The name on the command line and in documents.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::Fixed8 => "fixed-8",
        }
    }

    /// Whether algorithms other than scan conversion answer exactly in it: fixed point is for that alone.
    #[must_use]
    pub const fn is_exact(self) -> bool {
        matches!(self, Self::Exact | Self::Fixed8)
    }

    /// Message id of its name.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Exact => "word-arithmetic-exact",
            Self::F32 => "word-arithmetic-f32",
            Self::F64 => "word-arithmetic-f64",
            Self::Fixed8 => "word-arithmetic-fixed-8",
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
