//! Blending: what a fragment's colour becomes over the colour that is there.

mod equation;

pub use equation::{ExactColor, blend};

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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct BlendState {
    /// For red, green and blue.
    pub color: BlendComponent,
    /// For alpha.
    pub alpha: BlendComponent,
}
