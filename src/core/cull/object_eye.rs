//! Back-face test before any vertex is transformed: the eye is taken to object space instead.
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed. 1990, sections 6.5 and
//! 15.4. The test there is that of [`camera_normal`](super::camera_normal). A mirrored model turns its
//! triangles round on the way to the screen; this test does not see that.

use crate::transform::{Matrix, matrices::round_once};
use glam::{DMat4, DVec4};

/// The eye in the space that `model` maps to world space: `W^-1 e`, one product instead of one a vertex.
///
/// `eye` in world space: a point with w = 1 or a direction with w = 0; so is what comes out. Computed in
/// binary64, rounded once. `None` for a model that has no inverse (a scale of zero), or one that takes
/// the eye to infinity.
pub fn eye_in_object_space(model: &Matrix, eye: [f32; 4]) -> Option<[f32; 4]> {
    let matrix = DMat4::from_cols_array(&model.map(f64::from));
    if matrix.determinant() == 0.0 {
        return None;
    }
    let eye = matrix.inverse() * DVec4::from_array(eye.map(f64::from));
    let eye = if eye.w == 0.0 { eye } else { eye / eye.w };
    eye.is_finite().then(|| eye.to_array().map(round_once))
}

/// Whether a model matrix mirrors: the sign of the determinant of its upper left 3 x 3 part.
pub fn mirrors(model: &Matrix) -> bool {
    let axes = [0, 4, 8].map(|i| [model[i], model[i + 1], model[i + 2]]);
    let [a, b, c] = axes;
    crate::math::orient3d_homogeneous(a, b, c, &mut crate::math::Tally::default()).is_negative()
}
