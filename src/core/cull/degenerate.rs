//! Why a triangle has no area as seen from the eye.
//!
//! *Source:* Akenine-Möller et al., Real-Time Rendering, 4th ed. 2018, section 16.2 (degenerate
//! triangles). Deviation: no tolerance; each reason is an exact fact about the given coordinates.

use crate::math::{Tally, orient2d};
use serde::Serialize;

/// The reason, the first that holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Degeneracy {
    /// Two vertices, or all three, are the same point of the model.
    Coincident,
    /// The vertices lie on one line of the model.
    Collinear,
    /// It has an area as modelled, but none in camera space: the transform flattened it, or rounding did.
    Flattened,
    /// It has an area, and the eye lies in its plane.
    EdgeOn,
}

impl Degeneracy {
    /// The id of the word for it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Coincident => "back-face-coincident",
            Self::Collinear => "back-face-collinear",
            Self::Flattened => "back-face-flattened",
            Self::EdgeOn => "back-face-edge-on",
        }
    }
}

/// Whether three points of space lie on one line; two that are the same always do.
///
/// Exact for all finite coordinates: a triangle without area has none in any of the three coordinate
/// planes, and the other way round.
pub fn is_collinear([a, b, c]: [[f32; 3]; 3], tally: &mut Tally) -> bool {
    [[0, 1], [1, 2], [2, 0]].into_iter().all(|axes: [usize; 2]| {
        let flat = |p: [f32; 3]| axes.map(|axis| p[axis]);
        orient2d(flat(a), flat(b), flat(c), tally).is_zero()
    })
}

/// Why a triangle that covers nothing does so: from its vertices as modelled and in camera space, of
/// which the facing is known to be degenerate.
pub fn degeneracy(object: [[f32; 3]; 3], camera: [[f32; 3]; 3], tally: &mut Tally) -> Degeneracy {
    let [a, b, c] = object;
    if a == b || b == c || c == a {
        Degeneracy::Coincident
    } else if is_collinear(object, tally) {
        Degeneracy::Collinear
    } else if is_collinear(camera, tally) {
        Degeneracy::Flattened
    } else {
        Degeneracy::EdgeOn
    }
}
