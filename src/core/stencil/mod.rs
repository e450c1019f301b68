//! The stencil test: a small integer for each pixel that draws compare and change.

mod enlarge;
mod operations;
pub mod stencil_test;

pub use enlarge::{Enlarge, Way};
pub use operations::StencilOutcome;

use crate::depth::CompareFunction;
use serde::{Deserialize, Deserializer, Serialize};

/// What happens to the stored stencil value (WebGPU's names).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[expect(missing_docs, reason = "the names are the meaning")]
pub enum StencilOperation {
    #[default]
    Keep,
    Zero,
    Replace,
    Invert,
    IncrementClamp,
    DecrementClamp,
    IncrementWrap,
    DecrementWrap,
}

/// Stencil state of a draw (both facings alike).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub struct StencilState {
    /// `(reference & read_mask) compare (stored & read_mask)` must hold.
    pub compare: CompareFunction,
    /// When the stencil test fails.
    pub fail_op: StencilOperation,
    /// When the stencil test passes and the depth test fails.
    pub depth_fail_op: StencilOperation,
    /// When both pass.
    pub pass_op: StencilOperation,
    /// Bits compared.
    #[serde(deserialize_with = "low_bits")]
    pub read_mask: u8,
    /// Bits changed.
    #[serde(deserialize_with = "low_bits")]
    pub write_mask: u8,
    /// The draw's own value.
    #[serde(deserialize_with = "low_bits")]
    pub reference: u8,
}

/// WebGPU's numbers have 32 bits, of which a stencil of 8 bits uses the lowest.
fn low_bits<'de, D: Deserializer<'de>>(deserializer: D) -> Result<u8, D::Error> {
    u32::deserialize(deserializer).map(|bits| bits as u8)
}

impl Default for StencilState {
    fn default() -> Self {
        Self {
            compare: CompareFunction::Always,
            fail_op: StencilOperation::Keep,
            depth_fail_op: StencilOperation::Keep,
            pass_op: StencilOperation::Keep,
            read_mask: 0xFF,
            write_mask: 0xFF,
            reference: 0,
        }
    }
}
