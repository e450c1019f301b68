//! Back-face test by the normal: does the triangle's plane turn its front to the eye?
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed. 1990, section 15.4;
//! Shirley, Marschner, Fundamentals of Computer Graphics, 4th ed. 2015, section 8.4. Deviation: the eye is
//! homogeneous, so that one formula serves lines of sight that meet and parallel ones.

use super::number::{Number, cross, dot, exact_sign, minus, vector};
use crate::math::{Sign, Tally};

/// The eye of a perspective in camera space: the origin.
pub const EYE_AT_ORIGIN: [f32; 4] = [0.0, 0.0, 0.0, 1.0];

/// The eye of an orthographic camera in camera space: infinitely far along +z.
pub const EYE_FAR_ALONG_Z: [f32; 4] = [0.0, 0.0, 1.0, 0.0];

/// What the test computes.
#[derive(Clone, Debug)]
pub struct Terms<N> {
    /// `n = (p1 - p0) x (p2 - p0)`; of any length.
    pub normal: [N; 3],
    /// `(e - p0) . n`: positive where the front is seen.
    pub value: N,
}

/// The formula in any arithmetic.
///
/// Vertices and eye in one affine space, of any unit and right-handed; the triangle turns
/// counter-clockwise seen from its front. An eye with w = 1 is a point, one with w = 0 a direction to
/// look from. Six products for the normal, three for the value; nothing is divided.
#[inline]
pub fn formula<N: Number>(vertices: [[f32; 3]; 3], eye: [f32; 4]) -> Terms<N> {
    let [p0, p1, p2] = vertices.map(vector::<N, 3>);
    let normal = cross(&minus(&p1, &p0), &minus(&p2, &p0));
    let [ex, ey, ez, w] = eye;
    // A direction is the same seen from every vertex.
    let to_eye = if w == 0.0 { vector([ex, ey, ez]) } else { minus(&vector([ex, ey, ez]), &p0) };
    let value = dot(&to_eye, &normal);
    Terms { normal, value }
}

/// The exact sign of the value: positive where the front is seen, zero where the triangle is edge-on or
/// has no area.
///
/// For all finite coordinates. About 15 ns; `tally` counts exact tails.
#[inline]
pub fn sign(vertices: [[f32; 3]; 3], eye: [f32; 4], tally: &mut Tally) -> Sign {
    exact_sign(formula(vertices, eye).value, || formula(vertices, eye).value, tally)
}
