//! The slope scan line: row by row between two edges.

pub(super) use super::fill_triangle::{fill_rule, is_small};

use super::fill_triangle::FillTriangle;
use rasterscope_core::raster::Algorithm;

/// The lab.
pub(crate) const LAB: FillTriangle = FillTriangle(Algorithm::Scanline);
