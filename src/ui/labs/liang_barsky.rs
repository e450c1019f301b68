//! Liang-Barsky: drag the ends of a line and see the order of its crossings change.

use super::clip_line::ClipLine;
use rasterscope_core::clip::line::Algorithm;

/// The lab.
pub(crate) const LAB: ClipLine = ClipLine(Algorithm::LiangBarsky);
