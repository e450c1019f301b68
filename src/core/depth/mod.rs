//! The depth test: which fragment is nearest.

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
