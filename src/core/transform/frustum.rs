//! The visible part of space, as the corners of a body.
//!
//! *Source:* Shirley, Marschner, Fundamentals of Computer Graphics, 4th ed. 2015, section 7.2.

use glam::{DMat4, DVec4};

/// The eight corners of a frustum, near then far, each counter-clockwise from the lower left.
///
/// `clip_from_world` is column by column; `near_z` is the smallest visible z of NDC (0 or -1).
/// `None` if the matrix cannot be inverted or a corner is at infinity.
pub fn frustum_corners(clip_from_world: &[f32; 16], near_z: f32) -> Option<[[f32; 3]; 8]> {
    let matrix = DMat4::from_cols_array(&clip_from_world.map(f64::from));
    if matrix.determinant() == 0.0 {
        return None;
    }
    let inverse = matrix.inverse();
    let mut corners = [[0.0; 3]; 8];
    for (i, corner) in corners.iter_mut().enumerate() {
        let [x, y] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]][i % 4];
        let z = if i < 4 { f64::from(near_z) } else { 1.0 };
        let world = inverse * DVec4::new(x, y, z, 1.0);
        let world = world.truncate() / world.w;
        if !world.is_finite() {
            return None;
        }
        *corner = world.as_vec3().to_array();
    }
    Some(corners)
}

/// The twelve edges of a frustum, as indices of its corners: near, far, sides.
pub const FRUSTUM_EDGES: [[usize; 2]; 12] =
    [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];

/// The faces of a frustum, as indices of its corners: left, right, bottom, top, near, far.
pub const FRUSTUM_FACES: [[usize; 4]; 6] =
    [[0, 3, 7, 4], [1, 5, 6, 2], [0, 4, 5, 1], [3, 2, 6, 7], [0, 1, 2, 3], [4, 7, 6, 5]];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_of_a_frustum_are_those_of_its_matrix() {
        // Orthographic, 4 wide, 2 high, from z = -1 to z = -5, depths 0..1.
        let mut matrix = [0.0; 16];
        (matrix[0], matrix[5], matrix[10], matrix[14], matrix[15]) = (0.5, 1.0, -0.25, -0.25, 1.0);
        let corners = frustum_corners(&matrix, 0.0).unwrap();
        assert_eq!(corners[0], [-2.0, -1.0, -1.0]);
        assert_eq!(corners[6], [2.0, 1.0, -5.0]);
        for face in FRUSTUM_FACES {
            for (i, a) in face.iter().enumerate() {
                let edge = [*a, face[(i + 1) % 4]];
                assert!(FRUSTUM_EDGES.iter().any(|e| *e == edge || [e[1], e[0]] == edge));
            }
        }
        assert_eq!(frustum_corners(&[0.0; 16], 0.0), None);
    }
}
