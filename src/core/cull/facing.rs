//! Which side of a triangle the eye sees, decided without a division and without an error.
//!
//! *Source:* Olano and Greer, Triangle Scan Conversion using 2D Homogeneous Coordinates, 1997, section
//! 5; WebGPU, "Polygon Rasterization" (front face, cull mode).

use super::{CullMode, FrontFace, xyw_determinant};
use crate::math::{Sign, Tally};
use serde::Serialize;

/// How a triangle stands to the eye.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Facing {
    /// Its front is seen.
    Front,
    /// Its back is seen.
    Back,
    /// It has no area as seen from the eye: edge-on, collinear or coincident vertices. It covers nothing.
    Degenerate,
}

/// Decides the facing of a triangle in clip space, y up, before clipping: by the sign of the determinant
/// with the rows (x, y, w), which is positive for a counter-clockwise image.
///
/// Exact for all finite vertices, also with w of mixed signs, where the signed area of the divided
/// vertices would lie. A mirrored transform flips it, as in WebGPU. A few ns; `tally` counts exact tails.
#[inline]
pub fn facing(clip: [[f32; 4]; 3], front: FrontFace, tally: &mut Tally) -> Facing {
    let rows = clip.map(|[x, y, _, w]| [x, y, w]);
    match (xyw_determinant::sign(rows, tally), front) {
        (Sign::Zero, _) => Facing::Degenerate,
        (Sign::Positive, FrontFace::Ccw) | (Sign::Negative, FrontFace::Cw) => Facing::Front,
        _ => Facing::Back,
    }
}

impl CullMode {
    /// Whether a triangle that faces this way is not drawn. A degenerate one never is.
    #[inline]
    pub fn drops(self, facing: Facing) -> bool {
        match facing {
            Facing::Degenerate => true,
            Facing::Front => self == Self::Front,
            Facing::Back => self == Self::Back,
        }
    }
}
