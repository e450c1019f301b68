//! What helps to look: hints, exact values, less motion. Kept for the next start, never undone.

use egui::{Context, Style};
use serde::{Deserialize, Serialize};

/// How long a control takes to change its look, in seconds.
const ANIMATION: f32 = 0.12;

/// What helps to look.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Aids {
    /// Whether the hints of the first start are shown.
    pub(crate) hints: bool,
    /// Whether tables show every digit and the bits.
    pub(crate) exact: bool,
    /// Whether nothing moves that need not.
    pub(crate) still: bool,
}

impl Aids {
    /// Makes egui move as much as is wanted.
    pub(crate) fn apply(self, ctx: &Context) {
        let time = if self.still { 0.0 } else { ANIMATION };
        if ctx.global_style().animation_time != time {
            ctx.all_styles_mut(|style: &mut Style| style.animation_time = time);
        }
    }
}
