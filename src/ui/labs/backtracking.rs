//! Edge functions, row by row from the left side.

use super::fill_triangle::FillTriangle;
use rasterscope_core::raster::Algorithm;

/// The lab.
pub(crate) const LAB: FillTriangle = FillTriangle(Algorithm::Backtracking);
