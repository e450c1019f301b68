//! Edge functions over the bounding box.

use super::fill_triangle::FillTriangle;
use rasterscope_core::raster::Algorithm;

/// The lab.
pub(crate) const LAB: FillTriangle = FillTriangle(Algorithm::Aabb);
