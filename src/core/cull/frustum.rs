//! What lies wholly outside one plane of the frustum need not be looked at further.
//!
//! *Source:* Assarsson and Möller, Optimized View Frustum Culling Algorithms, 2000; Moore, Interval
//! Analysis, 1966 (the bounds of a box's image). Deviation: no plane is ever computed; coordinates are
//! compared in clip space.

use crate::{
    clip::polygon::{Plane, distance_is_negative},
    transform::{
        DepthRange, Matrix,
        matrices::{round_once, row},
    },
};

/// The first plane of [`Plane::ALL`] that all three vertices lie strictly outside of.
///
/// Exact for all finite vertices: two coordinates are compared, nothing is computed. Such a triangle
/// clips to nothing; others may, too. At most six comparisons a vertex.
#[inline]
pub fn triangle_outside(clip: [[f32; 4]; 3], range: DepthRange) -> Option<Plane> {
    Plane::ALL.into_iter().find(|&plane| clip.iter().all(|&v| distance_is_negative(plane, v, range)))
}

/// Which planes a point of clip space lies strictly outside of: a bit for each of [`Plane::ALL`], the first lowest.
///
/// *Source:* Blinn and Newell, Clipping Using Homogeneous Coordinates, 1978 (outcodes before the divide).
#[inline]
pub fn outcode(point: [f32; 4], range: DepthRange) -> u8 {
    let bit = |plane: Plane| u8::from(distance_is_negative(plane, point, range)) << plane as u8;
    let sides = bit(Plane::Left) | bit(Plane::Right) | bit(Plane::Bottom) | bit(Plane::Top);
    sides | bit(Plane::Near) | bit(Plane::Far)
}

/// The smallest and largest coordinates of some points; homogeneous.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The smallest of each coordinate.
    pub min: [f32; 4],
    /// The largest of each coordinate.
    pub max: [f32; 4],
}

impl Bounds {
    /// The box around points of object space (w = 1); `None` if there are none.
    pub fn of(points: &[[f32; 3]]) -> Option<Self> {
        let first = *points.first()?;
        let (min, max) = points.iter().fold((first, first), |(min, max), point| {
            let axes = [0, 1, 2];
            (axes.map(|i| point[i].min(min[i])), axes.map(|i| point[i].max(max[i])))
        });
        let homogeneous = |[x, y, z]: [f32; 3]| [x, y, z, 1.0];
        Some(Self { min: homogeneous(min), max: homogeneous(max) })
    }

    /// Bounds of [`apply`](crate::transform::apply) for any point within: with the same operations in
    /// the same order, each of which rounds monotonically. So no rounded image lies outside, not even
    /// by one ULP, and no error needs to be estimated.
    #[must_use]
    pub fn through(&self, matrix: &Matrix) -> Self {
        let end = |i: usize, low: bool| {
            let factors = row(matrix, i);
            let product = |j: usize| {
                let take_min = (factors[j] >= 0.0) == low;
                f64::from(factors[j]) * f64::from(if take_min { self.min[j] } else { self.max[j] })
            };
            round_once(product(0) + product(1) + product(2) + product(3))
        };
        Self { min: [0, 1, 2, 3].map(|i| end(i, true)), max: [0, 1, 2, 3].map(|i| end(i, false)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transform::{apply, matrices};

    #[test]
    fn no_rounded_vertex_leaves_the_bounds() {
        let points: Vec<[f32; 3]> = (0..200)
            .map(|i| [i as f32 * 0.37 - 31.0, (i * i % 97) as f32 / 7.0, -(i as f32) / 3.0])
            .collect();
        let bounds = Bounds::of(&points).expect("there are points");
        let matrix = matrices::model([0.1, -3.3, 1e-3], [33.0, -70.0, 12.5], [1.5, -0.3, 7.0]);
        let image = bounds.through(&matrix);
        for [x, y, z] in points {
            let point = apply(&matrix, [x, y, z, 1.0]);
            let ends = image.min.into_iter().zip(image.max);
            assert!(point.iter().zip(ends).all(|(value, (min, max))| (min..=max).contains(value)));
        }
    }
}
