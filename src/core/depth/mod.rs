//! The depth test: which fragment is nearest.
//!
//! Contract: a fragment's depth is the exact plane value at the pixel's centre, rounded once to
//! the buffer's format, within the vertices' range.

mod bias;
mod buffer;
mod early;
mod plane;
pub mod precision;
mod row;
mod rules;
pub mod z_buffer;

pub use bias::{DepthBias, DepthPlacement};
pub use buffer::DepthBuffer;
pub use early::Early;
pub use plane::DepthPlane;
pub use row::{DepthRow, DepthRows};
pub(crate) use rules::scissor_sentence;
pub use rules::{Cut, Cutout, Rules};

use crate::interpolate::unorm;
use serde::{Deserialize, Serialize};

/// WebGPU's eight compare functions: is the new value `op` the stored one?
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[expect(missing_docs, reason = "the names are the meaning")]
pub enum CompareFunction {
    Never,
    #[default]
    Less,
    Equal,
    LessEqual,
    Greater,
    NotEqual,
    GreaterEqual,
    Always,
}

impl CompareFunction {
    /// In WebGPU's order.
    pub const ALL: [Self; 8] = [
        Self::Never,
        Self::Less,
        Self::Equal,
        Self::LessEqual,
        Self::Greater,
        Self::NotEqual,
        Self::GreaterEqual,
        Self::Always,
    ];

    /// Whether `new` passes against `stored`.
    #[inline]
    pub fn passes<T: PartialOrd>(self, new: T, stored: T) -> bool {
        match self {
            Self::Never => false,
            Self::Less => new < stored,
            Self::Equal => new == stored,
            Self::LessEqual => new <= stored,
            Self::Greater => new > stored,
            Self::NotEqual => new != stored,
            Self::GreaterEqual => new >= stored,
            Self::Always => true,
        }
    }

    /// The function called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|compare| compare.name() == name)
    }

    /// The function that passes exactly where this one fails.
    pub fn opposite(self) -> Self {
        match self {
            Self::Never => Self::Always,
            Self::Less => Self::GreaterEqual,
            Self::Equal => Self::NotEqual,
            Self::LessEqual => Self::Greater,
            Self::Greater => Self::LessEqual,
            Self::NotEqual => Self::Equal,
            Self::GreaterEqual => Self::Less,
            Self::Always => Self::Never,
        }
    }

    /// The function that gives the same answer for values that are turned around, as reversed depths are.
    pub fn mirrored(self) -> Self {
        match self {
            Self::Less => Self::Greater,
            Self::LessEqual => Self::GreaterEqual,
            Self::Greater => Self::Less,
            Self::GreaterEqual => Self::LessEqual,
            Self::Never | Self::Equal | Self::NotEqual | Self::Always => self,
        }
    }

    /// Its sign between the new and the stored value, such as `<`; empty for never and always.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Never | Self::Always => "",
            Self::Less => "<",
            Self::Equal => "=",
            Self::LessEqual => "≤",
            Self::Greater => ">",
            Self::NotEqual => "≠",
            Self::GreaterEqual => "≥",
        }
    }

    /// The sign that holds where the test fails; empty for never and always.
    pub fn opposite_sign(self) -> &'static str {
        match self {
            Self::Never | Self::Always => "",
            Self::Less => "≥",
            Self::Equal => "≠",
            Self::LessEqual => ">",
            Self::Greater => "≤",
            Self::NotEqual => "=",
            Self::GreaterEqual => "<",
        }
    }

    /// WebGPU's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Never => "never",
            Self::Less => "less",
            Self::Equal => "equal",
            Self::LessEqual => "less-equal",
            Self::Greater => "greater",
            Self::NotEqual => "not-equal",
            Self::GreaterEqual => "greater-equal",
            Self::Always => "always",
        }
    }
}

/// How a depth is stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DepthFormat {
    /// As it is.
    #[default]
    F32,
    /// `floor(z (2^16 - 1) + 1/2)`.
    Unorm16,
    /// `floor(z (2^24 - 1) + 1/2)`.
    Unorm24,
    /// `floor(z (2^32 - 1) + 1/2)`.
    Unorm32,
}

impl DepthFormat {
    /// All formats, the default first.
    pub const ALL: [Self; 4] = [Self::F32, Self::Unorm16, Self::Unorm24, Self::Unorm32];

    /// The name on the command line and in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::Unorm16 => "unorm16",
            Self::Unorm24 => "unorm24",
            Self::Unorm32 => "unorm32",
        }
    }

    /// The largest code of a unorm format; `None` for f32.
    pub fn max_code(self) -> Option<u32> {
        match self {
            Self::F32 => None,
            Self::Unorm16 => Some(0xFFFF),
            Self::Unorm24 => Some(0xFF_FFFF),
            Self::Unorm32 => Some(u32::MAX),
        }
    }

    /// The format called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.name() == name)
    }

    /// How many bits a code has.
    pub fn bits(self) -> u8 {
        match self {
            Self::Unorm16 => 16,
            Self::Unorm24 => 24,
            Self::F32 | Self::Unorm32 => 32,
        }
    }

    /// The code of a depth: its bits if f32, else `floor(z (2^n - 1) + 1/2)` with z clamped to
    /// 0..1; exact.
    #[inline]
    pub fn encode(self, z: f32) -> u32 {
        match self.max_code() {
            None => (z + 0.0).to_bits(), // no -0: codes are ordered as the depths are
            Some(max) => unorm(z, max),
        }
    }

    /// The depth of a code; unorm codes give `code / (2^n - 1)`.
    #[inline]
    pub fn decode(self, code: u32) -> f64 {
        match self.max_code() {
            None => f32::from_bits(code).into(),
            Some(max) => f64::from(code) / f64::from(max),
        }
    }
}

/// Depth state of a draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct DepthState {
    /// Whether fragments are tested (and written) at all.
    pub test: bool,
    /// How a new depth must stand to the stored one to pass.
    pub compare: CompareFunction,
    /// Whether a passing fragment's depth is stored.
    pub write: bool,
}

impl Default for DepthState {
    fn default() -> Self {
        Self { test: true, compare: CompareFunction::Less, write: true }
    }
}
