//! Cohen-Sutherland: drag the ends of a line and the window that clips it.

use super::clip_line::ClipLine;
use rasterscope_core::clip::line::Algorithm;

/// The lab.
pub(crate) const LAB: ClipLine = ClipLine(Algorithm::CohenSutherland);
