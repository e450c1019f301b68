//! The plane equation: drag the vertices, and the row through the point is filled anew.

use super::interpolation::Interpolate;

/// The lab.
pub(crate) const LAB: Interpolate = Interpolate("plane-equation");
