//! Blending: what a fragment's colour becomes over the colour that is there.

mod alpha_test;
mod equation;
pub mod layers;
mod mode;

pub use alpha_test::AlphaTest;
pub use equation::{ExactColor, Terms, blend, blend_channel};
pub use mode::Mode;

use serde::{Deserialize, Serialize};

/// What a colour is multiplied by (WebGPU's names).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[expect(missing_docs, reason = "the names are the meaning")]
pub enum BlendFactor {
    Zero,
    #[default]
    One,
    Src,
    OneMinusSrc,
    SrcAlpha,
    OneMinusSrcAlpha,
    Dst,
    OneMinusDst,
    DstAlpha,
    OneMinusDstAlpha,
    SrcAlphaSaturated,
    Constant,
    OneMinusConstant,
}

impl BlendFactor {
    /// In WebGPU's order.
    pub const ALL: [Self; 13] = [
        Self::Zero,
        Self::One,
        Self::Src,
        Self::OneMinusSrc,
        Self::SrcAlpha,
        Self::OneMinusSrcAlpha,
        Self::Dst,
        Self::OneMinusDst,
        Self::DstAlpha,
        Self::OneMinusDstAlpha,
        Self::SrcAlphaSaturated,
        Self::Constant,
        Self::OneMinusConstant,
    ];

    /// WebGPU's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Zero => "zero",
            Self::One => "one",
            Self::Src => "src",
            Self::OneMinusSrc => "one-minus-src",
            Self::SrcAlpha => "src-alpha",
            Self::OneMinusSrcAlpha => "one-minus-src-alpha",
            Self::Dst => "dst",
            Self::OneMinusDst => "one-minus-dst",
            Self::DstAlpha => "dst-alpha",
            Self::OneMinusDstAlpha => "one-minus-dst-alpha",
            Self::SrcAlphaSaturated => "src-alpha-saturated",
            Self::Constant => "constant",
            Self::OneMinusConstant => "one-minus-constant",
        }
    }
}

/// How the two products are joined (WebGPU's names; `Min` and `Max` ignore the factors).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[expect(missing_docs, reason = "the names are the meaning")]
pub enum BlendOperation {
    #[default]
    Add,
    Subtract,
    ReverseSubtract,
    Min,
    Max,
}

impl BlendOperation {
    /// In WebGPU's order.
    pub const ALL: [Self; 5] = [Self::Add, Self::Subtract, Self::ReverseSubtract, Self::Min, Self::Max];

    /// WebGPU's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Add => "add",
            Self::Subtract => "subtract",
            Self::ReverseSubtract => "reverse-subtract",
            Self::Min => "min",
            Self::Max => "max",
        }
    }
}

/// One equation: `operation(src * src_factor, dst * dst_factor)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub struct BlendComponent {
    /// Multiplies the fragment's value.
    pub src_factor: BlendFactor,
    /// Multiplies the stored value.
    pub dst_factor: BlendFactor,
    /// Joins them.
    pub operation: BlendOperation,
}

impl Default for BlendComponent {
    fn default() -> Self {
        Self { src_factor: BlendFactor::One, dst_factor: BlendFactor::Zero, operation: BlendOperation::Add }
    }
}

/// Blend state of a draw.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct BlendState {
    /// For red, green and blue.
    pub color: BlendComponent,
    /// For alpha.
    pub alpha: BlendComponent,
    /// What the factors `constant` and `one-minus-constant` stand for: red, green, blue, alpha in 0..=1
    /// (WebGPU's `setBlendConstant`).
    #[serde(skip_serializing_if = "is_black")]
    pub constant: [f32; 4],
}

fn is_black(constant: &[f32; 4]) -> bool {
    *constant == [0.0; 4]
}

impl BlendState {
    /// The equation of a channel: 0 red, 1 green, 2 blue, 3 alpha.
    #[inline]
    pub fn component(&self, channel: usize) -> &BlendComponent {
        if channel == 3 { &self.alpha } else { &self.color }
    }

    /// Whether a factor is the constant.
    pub fn uses_constant(&self) -> bool {
        let constants = [BlendFactor::Constant, BlendFactor::OneMinusConstant];
        let uses =
            |of: BlendComponent| constants.contains(&of.src_factor) || constants.contains(&of.dst_factor);
        uses(self.color) || uses(self.alpha)
    }
}
