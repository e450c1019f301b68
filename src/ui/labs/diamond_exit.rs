//! The diamond-exit rule: drag the ends of a line over the pixels that it draws.

use super::draw_line::DrawLine;
use rasterscope_core::raster::line::Algorithm;

/// The lab.
pub(crate) const LAB: DrawLine = DrawLine(Algorithm::DiamondExit);
