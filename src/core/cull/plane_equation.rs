//! Back-face test by the plane's equation: on which side of `Ax + By + Cz + D = 0` is the eye?
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed. 1990, sections 11.1.3 and
//! 15.4. Deviation: an eye at infinity is put in with w = 0.

use super::number::{Number, cross, dot, exact_sign, minus, vector};
use crate::math::{Sign, Tally};

/// What the test computes.
#[derive(Clone, Debug)]
pub struct Terms<N> {
    /// A, B, C, D; A, B, C is the normal `(p1 - p0) x (p2 - p0)`, D is `-(A x0 + B y0 + C z0)`.
    pub plane: [N; 4],
    /// `A ex + B ey + C ez + D ew`: negative where the back is seen.
    pub value: N,
}

/// The formula in any arithmetic.
///
/// Vertices and eye in one affine space, usually the world; counter-clockwise seen from the front. An eye
/// with w = 0 is a direction. The plane can be kept with the model: then a test costs three products.
#[inline]
pub fn formula<N: Number>(vertices: [[f32; 3]; 3], eye: [f32; 4]) -> Terms<N> {
    let [p0, p1, p2] = vertices.map(vector::<N, 3>);
    let normal = cross(&minus(&p1, &p0), &minus(&p2, &p0));
    let d = N::from(0.0) - dot(&normal, &p0);
    let [ex, ey, ez, w] = eye;
    let value = dot(&normal, &vector([ex, ey, ez])) + d.clone() * N::from(w);
    let [a, b, c] = normal;
    Terms { plane: [a, b, c, d], value }
}

/// The exact sign of the value: negative where the back is seen, zero where the triangle is edge-on or
/// has no area. For all finite coordinates. About 15 ns; `tally` counts exact tails.
#[inline]
pub fn sign(vertices: [[f32; 3]; 3], eye: [f32; 4], tally: &mut Tally) -> Sign {
    exact_sign(formula(vertices, eye).value, || formula(vertices, eye).value, tally)
}
