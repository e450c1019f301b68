//! Back-face test after the divide: the sign of the normal's z.
//!
//! All lines of sight are parallel to z there, so x and y of the normal do not matter. An odd number of
//! vertices behind the eye turns the answer round, for each of these comes out of the divide mirrored.
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed. 1990, section 15.4.

use super::number::Number;
use crate::math::{Sign, Tally, orient2d};

/// The formula in any arithmetic: z of `(p1 - p0) x (p2 - p0)`, positive where the front is seen.
///
/// NDC, x to the right, y up; counter-clockwise seen from the front. Two products.
#[inline]
pub fn formula<N: Number>(ndc: [[f32; 2]; 3]) -> N {
    let [[x0, y0], [x1, y1], [x2, y2]] = ndc.map(|point| point.map(N::from));
    (x1 - x0.clone()) * (y2 - y0.clone()) - (y1 - y0) * (x2 - x0)
}

/// Its exact sign, for all finite coordinates; zero for a triangle without area. About 2 ns.
#[inline]
pub fn sign([a, b, c]: [[f32; 2]; 3], tally: &mut Tally) -> Sign {
    orient2d(a, b, c, tally)
}
