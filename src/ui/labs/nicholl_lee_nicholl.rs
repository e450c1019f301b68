//! Nicholl-Lee-Nicholl: drag the ends of a line and see its regions turn with P1.

use super::clip_line::ClipLine;
use rasterscope_core::clip::line::Algorithm;

/// The lab.
pub(crate) const LAB: ClipLine = ClipLine(Algorithm::NichollLeeNicholl);
