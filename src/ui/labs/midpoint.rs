//! Midpoint subdivision: drag the ends of a line and see it halved.

use super::clip_line::ClipLine;
use rasterscope_core::clip::line::Algorithm;

/// The lab.
pub(crate) const LAB: ClipLine = ClipLine(Algorithm::Midpoint);
