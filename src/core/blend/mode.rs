//! Blend states that have a name.
//!
//! *Source:* Porter and Duff, Compositing Digital Images, 1984 (over); WebGPU, "Blend State" (the
//! factors). Deviation: [`Mode::ColorFactors`] is a mistake on purpose.

use super::{BlendComponent, BlendFactor, BlendOperation, BlendState};
use serde::{Deserialize, Serialize};

/// What a layer does to what is there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mode {
    /// Straight alpha: colour `as cs + (1 - as) cd`, alpha `as + (1 - as) ad`.
    #[default]
    Over,
    /// The mistake: alpha with the factors of the colour, `as as + (1 - as) ad`.
    ColorFactors,
    /// Colours that are multiplied by their alpha already: `cs + (1 - as) cd`.
    Premultiplied,
    /// Light on light: `as cs + cd`; alpha is added.
    Additive,
    /// A filter: `cs cd`.
    Multiply,
    /// The darker of each channel; factors do not count.
    Min,
    /// The lighter of each channel.
    Max,
    /// The new colour alone, as without blending.
    Replace,
}

impl Mode {
    /// Every mode, the default first.
    pub const ALL: [Self; 8] = [
        Self::Over,
        Self::ColorFactors,
        Self::Premultiplied,
        Self::Additive,
        Self::Multiply,
        Self::Min,
        Self::Max,
        Self::Replace,
    ];

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::Over => "word-blend-over",
            Self::ColorFactors => "word-blend-color-factors",
            Self::Premultiplied => "word-blend-premultiplied",
            Self::Additive => "word-blend-additive",
            Self::Multiply => "word-blend-multiply",
            Self::Min => "word-blend-min",
            Self::Max => "word-blend-max",
            Self::Replace => "word-blend-replace",
        }
    }

    /// Its factors and operations.
    pub fn state(self) -> BlendState {
        use BlendFactor::{Dst, DstAlpha, One, OneMinusSrcAlpha, SrcAlpha, Zero};
        use BlendOperation::{Add, Max, Min};
        let of = |src_factor, dst_factor, operation| BlendComponent { src_factor, dst_factor, operation };
        let each = |color, alpha| BlendState { color, alpha, ..BlendState::default() };
        let both = |component| each(component, component);
        match self {
            Self::Over => each(of(SrcAlpha, OneMinusSrcAlpha, Add), of(One, OneMinusSrcAlpha, Add)),
            Self::ColorFactors => both(of(SrcAlpha, OneMinusSrcAlpha, Add)),
            Self::Premultiplied => both(of(One, OneMinusSrcAlpha, Add)),
            Self::Additive => each(of(SrcAlpha, One, Add), of(One, One, Add)),
            Self::Multiply => each(of(Dst, Zero, Add), of(DstAlpha, Zero, Add)),
            Self::Min => both(of(One, One, Min)),
            Self::Max => both(of(One, One, Max)),
            Self::Replace => both(of(One, Zero, Add)),
        }
    }
}
