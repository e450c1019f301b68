//! Points of triangles on the screen, with an attribute at the vertices.

use super::{Family, Random};
use crate::{
    interpolate::{Mode, interpolate},
    math::{Arithmetic, Tally},
};

/// The families that points have.
pub const FAMILIES: &[Family] = &[
    Family::Ordinary,
    Family::Beside,
    Family::NearlyParallel,
    Family::Sliver,
    Family::NearWZero,
    Family::Huge,
    Family::Denormal,
    Family::Long,
];

/// Columns and rows of the image that a family is for.
pub fn size(family: Family) -> [u32; 2] {
    if family == Family::Long { [4_096, 32] } else { [640, 480] }
}

/// A point of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// x and y in pixels, w of clip space.
    pub vertices: [[f32; 3]; 3],
    /// The attribute at the vertices, from 0 to 1.
    pub attribute: [f32; 3],
    /// In the triangle, in pixels.
    pub at: [f32; 2],
}

/// Points at which there is a value.
pub fn points(family: Family, count: usize) -> Vec<Point> {
    let mut random = Random::new(500 + family as u64);
    std::iter::repeat_with(|| point(family, &mut random)).filter(has_value).take(count).collect()
}

fn has_value(point: &Point) -> bool {
    let Point { vertices, attribute, at } = *point;
    interpolate(Mode::Perspective, vertices, attribute, at, Arithmetic::Exact, &mut Tally::default()).is_ok()
}

fn point(family: Family, random: &mut Random) -> Point {
    let scale = match family {
        Family::Huge => random.magnitude(20.0, 35.0).abs(),
        Family::Denormal => 1e-40,
        _ => 1.0,
    };
    let [width, height] = size(family).map(f64::from);
    let mut vertices: [[f32; 3]; 3] = std::array::from_fn(|_| {
        let w = if family == Family::NearWZero {
            random.magnitude(-8.0, 0.0).abs()
        } else {
            random.uniform(0.5, 9.0)
        };
        [random.uniform(0.0, width) * scale, random.uniform(0.0, height) * scale, w]
    });
    if family == Family::Sliver {
        let [a, b, _] = vertices;
        let t = random.uniform(0.2, 0.8);
        for axis in 0..2 {
            vertices[2][axis] = random.beside(a[axis] + t * (b[axis] - a[axis]));
        }
    }
    if family == Family::Long {
        vertices[0][0] = random.uniform(0.0, 8.0);
        vertices[2][0] = random.uniform(width - 8.0, width);
    }
    // One side along a row.
    if family == Family::NearlyParallel {
        vertices[1][1] = random.beside(vertices[0][1]) + random.uniform(-1e-4, 1e-4);
    }
    let [k, l] = [random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)];
    let [k, l] = if k + l > 1.0 { [1.0 - k, 1.0 - l] } else { [k, l] };
    let [a, b, c] = vertices;
    let between = |k: f32, l: f32| [0, 1].map(|i| a[i] + k * (b[i] - a[i]) + l * (c[i] - a[i]));
    let at = match family {
        Family::Beside => between(k, 0.0).map(|x| random.beside(x)),
        Family::NearlyParallel => between(k, 1e-6 * l),
        // The row that is as long as the triangle.
        Family::Long => [0, 1].map(|axis| (vertices[0][axis] + vertices[1][axis] + vertices[2][axis]) / 3.0),
        // The middle of a side is a point of most slivers.
        Family::Sliver => [0, 1].map(|axis| a[axis] / 2.0 + b[axis] / 2.0),
        _ => between(k, l),
    };
    Point { vertices, attribute: std::array::from_fn(|_| random.uniform(0.0, 1.0)), at }
}
