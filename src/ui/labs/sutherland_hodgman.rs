//! Sutherland-Hodgman: drag the corners of a polygon and the window that clips it.

use super::clip_polygon::ClipPolygon;
use rasterscope_core::clip::polygon::Algorithm;

/// The lab.
pub(crate) const LAB: ClipPolygon = ClipPolygon(Algorithm::SutherlandHodgman);
