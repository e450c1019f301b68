//! Interpolation as taught: area ratios, then `(T/w) / (1/w)`, rounded at every step.
//!
//! *Source:* Heckbert and Moreton, Interpolation for Polygon Texture Mapping and Shading, State of
//! the Art in Computer Graphics, 1991.

use crate::math::Real;

/// Interpolates in one type throughout; without `w` the value is affine.
pub(super) fn interpolate<R: Real>(
    vertices: [[f32; 2]; 3],
    w: Option<[f32; 3]>,
    attribute: [f32; 3],
    at: [f32; 2],
) -> f32 {
    let [v0, v1, v2] = vertices.map(|vertex| vertex.map(R::from_f32));
    let p = at.map(R::from_f32);
    let area =
        |a: [R; 2], b: [R; 2], c: [R; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let whole = area(v0, v1, v2);
    let l = [area(v1, v2, p) / whole, area(v2, v0, p) / whole, area(v0, v1, p) / whole];
    let sum = |terms: [R; 3]| terms[0] + terms[1] + terms[2];
    let value = |l: [R; 3]| sum([0, 1, 2].map(|i| l[i] * R::from_f32(attribute[i])));
    let Some(w) = w else { return value(l).to_f32() };
    let share = [0, 1, 2].map(|i| l[i] / R::from_f32(w[i]));
    (value(share) / sum(share)).to_f32()
}
