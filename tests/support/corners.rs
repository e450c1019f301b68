//! An exact clipper of triangles that knows no order of planes: it enumerates corners.

use rasterscope_core::math::{Dyadic, Sign};

/// Four coordinates of each vertex.
pub(crate) type Triangle = [[f32; 4]; 3];

pub(crate) fn cross(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> [Dyadic; 3] {
    [[1, 2], [2, 0], [0, 1]].map(|[j, k]| &a[j] * &b[k] - &a[k] * &b[j])
}

pub(crate) fn dot(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> Dyadic {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

pub(crate) fn unit(i: usize) -> [Dyadic; 3] {
    [0, 1, 2].map(|j| Dyadic::from(i32::from(i == j)))
}

/// The corners of a clipped triangle, rounded, in no order: the points where two of the lines (edges,
/// and planes by the distances of the three vertices, in barycentric coordinates) meet and that lie on no
/// wrong side of the others.
pub(crate) fn clipped_corners(
    triangle: Triangle,
    planes: impl Iterator<Item = [Dyadic; 3]>,
) -> Vec<[u32; 4]> {
    let lines: Vec<[Dyadic; 3]> = (0..3).map(unit).chain(planes).collect();
    let mut corners: Vec<[Dyadic; 3]> = Vec::new();
    for i in 0..lines.len() {
        for j in 0..i {
            let mut point = cross(&lines[i], &lines[j]);
            let sum = &point[0] + &point[1] + &point[2];
            if point.iter().all(Dyadic::is_zero) || sum.is_zero() {
                continue; // the lines are the same, or meet at no point of the plane
            }
            if sum.sign() == Sign::Negative {
                point = point.map(|p| -p);
            }
            let inside = lines.iter().all(|line| dot(line, &point).sign() != Sign::Negative);
            let new = |corner: &[Dyadic; 3]| cross(corner, &point).iter().any(|d| !d.is_zero());
            if inside && corners.iter().all(new) {
                corners.push(point);
            }
        }
    }
    let mut rounded: Vec<_> = corners.iter().map(|corner| at(corner, triangle).map(f32::to_bits)).collect();
    rounded.sort_unstable();
    if corners.len() < 3 {
        rounded.clear();
    }
    rounded
}

/// The point with these barycentric coordinates, times any factor, rounded.
fn at(weights: &[Dyadic; 3], triangle: Triangle) -> [f32; 4] {
    let sum = &weights[0] + &weights[1] + &weights[2];
    if let Some(i) = (0..3).find(|&i| weights[i] == sum) {
        return triangle[i].map(|c| c + 0.0);
    }
    [0, 1, 2, 3]
        .map(|axis| Dyadic::ratio_to_f32(&dot(weights, &triangle.map(|v| Dyadic::from(v[axis]))), &sum))
}
