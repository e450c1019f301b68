//! Back-face test without a divide: the sign of the determinant with the rows (x, y, w).
//!
//! Its magnitude is six times the volume of the tetrahedron of the three points (x, y, w) and the eye. It
//! holds for any w, so the pipeline decides by it: see [`facing`](super::facing()).
//!
//! *Source:* Olano and Greer, Triangle Scan Conversion using 2D Homogeneous Coordinates, 1997, section 5.

use super::number::{Number, cross, dot, vector};
use crate::math::{Sign, Tally, orient3d_homogeneous};

/// What the test computes.
#[derive(Clone, Debug)]
pub struct Terms<N> {
    /// The minors of the first row: `r1 x r2`.
    pub minors: [N; 3],
    /// `r0 . (r1 x r2)`: positive where the front is seen.
    pub value: N,
}

/// The formula in any arithmetic: nine products.
///
/// Rows (x, y, w) of clip space, y up, any w; counter-clockwise seen from the front.
#[inline]
pub fn formula<N: Number>(rows: [[f32; 3]; 3]) -> Terms<N> {
    let [r0, r1, r2] = rows.map(vector::<N, 3>);
    let minors = cross(&r1, &r2);
    let value = dot(&r0, &minors);
    Terms { minors, value }
}

/// Its exact sign, for all finite coordinates; zero where the triangle is edge-on or has no area.
/// About 4 ns.
#[inline]
pub fn sign([a, b, c]: [[f32; 3]; 3], tally: &mut Tally) -> Sign {
    orient3d_homogeneous(a, b, c, tally)
}
