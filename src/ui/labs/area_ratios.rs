//! Area ratios: drag the point, and what the vertices weigh follows.

use super::interpolation::Interpolate;

/// The lab.
pub(crate) const LAB: Interpolate = Interpolate("area-ratios");
