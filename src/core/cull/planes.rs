//! The frustum's planes in the space of an object, and bodies against them.
//!
//! *Source:* Gribb and Hartmann, Fast Extraction of Viewing Frustum Planes from the World-View-Projection
//! Matrix, 2001; Assarsson and Möller, Optimized View Frustum Culling Algorithms, 2000 (nearest and
//! farthest corner, plane masks). Deviation: each distance has a slack for all that is rounded on the way
//! to clip space, so that a body is never called outside or inside of which the pipeline sees otherwise.

use super::sphere::Sphere;
use crate::{
    clip::polygon::Plane,
    transform::{DepthRange, Matrix, matrices::row},
};
use serde::Serialize;

/// Of each product's component, how far it can be from the exact one, relative to the product of the
/// magnitudes: three matrices round by 2^-24 each (and a little: 4 roundings of binary64); the fourth
/// 2^-24 is far more than all roundings of binary64 in this file.
const ROUNDING: f64 = 4.0 * 5.960_464_477_539_063e-8;

/// A component below the smallest normal number rounds by half of the smallest one there is.
const UNDERFLOW: f64 = 1.401_298_464_324_817e-45;

/// Where a body lies against a plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// All of it lies strictly outside.
    Outside,
    /// None of it does.
    Inside,
    /// Neither is certain.
    Crosses,
}

/// A body that holds an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Volume {
    /// A ball.
    Sphere(Sphere),
    /// A box with sides along the axes: its smallest and largest corner.
    Box([[f32; 3]; 2]),
}

/// A set of planes, those that are still to be tested.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
pub struct PlaneMask(u8);

impl PlaneMask {
    /// All six.
    pub const ALL: Self = Self(0b11_1111);
    /// None: what has this mask is inside all planes.
    pub const NONE: Self = Self(0);

    /// Whether a plane is in it.
    pub fn has(self, plane: Plane) -> bool {
        self.0 & 1 << plane as u8 != 0
    }

    /// The same without a plane.
    #[must_use]
    pub fn without(self, plane: Plane) -> Self {
        Self(self.0 & !(1 << plane as u8))
    }

    /// Its planes, in order.
    pub fn planes(self) -> impl Iterator<Item = Plane> {
        Plane::ALL.into_iter().filter(move |plane| self.has(*plane))
    }
}

/// How a body stands to a plane, in numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// The middle's distance times the normal's length; positive inside.
    pub distance: f64,
    /// How far the body reaches to both sides, in the same measure.
    pub spread: f64,
    /// What rounding may move.
    pub slack: f64,
}

impl Reach {
    /// What is certain.
    pub fn side(&self) -> Side {
        if self.distance + self.spread + self.slack < 0.0 {
            Side::Outside
        } else if self.distance - self.spread - self.slack >= 0.0 {
            Side::Inside
        } else {
            Side::Crosses
        }
    }
}

/// A plane `n . p + d`, positive inside, with the slack of each coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Halfspace {
    normal: [f64; 3],
    offset: f64,
    slack: [f64; 4],
}

/// The frustum in the space before some matrices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frustum {
    planes: [Halfspace; 6],
    /// The largest factor of each coordinate, through any of the matrices: what may overflow.
    largest: [f64; 4],
}

/// A product of matrices, and of their magnitudes: rows of columns.
#[derive(Clone, Copy)]
struct Product {
    exact: [[f64; 4]; 4],
    magnitude: [[f64; 4]; 4],
    /// What underflow adds to each component.
    underflow: [f64; 4],
}

impl Product {
    fn then(&self, matrix: &Matrix) -> Self {
        let rows = [0, 1, 2, 3].map(|i| row(matrix, i).map(f64::from));
        let times = |rows: &[[f64; 4]; 4], by: &[[f64; 4]; 4]| {
            rows.map(|row| [0, 1, 2, 3].map(|j| (0..4).map(|k| row[k] * by[k][j]).sum()))
        };
        let sizes = rows.map(|row| row.map(f64::abs));
        Self {
            exact: times(&rows, &self.exact),
            magnitude: times(&sizes, &self.magnitude),
            underflow: sizes
                .map(|row| row.iter().zip(self.underflow).map(|(a, b)| a * b).sum::<f64>() + UNDERFLOW),
        }
    }
}

impl Frustum {
    /// The planes in the space that `matrices`, at most three, one after the other, take to clip space.
    ///
    /// In the pipeline's products each component is rounded to binary32. About 300 ns.
    pub fn before(matrices: &[&Matrix], range: DepthRange) -> Self {
        let one = [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| f64::from(u8::from(i == j))));
        let mut product = Product { exact: one, magnitude: one, underflow: [0.0; 4] };
        let mut largest = [1.0_f64; 4];
        for matrix in matrices {
            product = product.then(matrix);
            for row in product.magnitude {
                largest = [0, 1, 2, 3].map(|j| largest[j].max(row[j]));
            }
        }
        let planes = Plane::ALL.map(|plane| {
            // The distance is a sum or a difference of w and a coordinate; near may be z alone.
            let (axis, sign, with_w) = match plane {
                Plane::Left => (0, 1.0, true),
                Plane::Right => (0, -1.0, true),
                Plane::Bottom => (1, 1.0, true),
                Plane::Top => (1, -1.0, true),
                Plane::Near => (2, 1.0, range == DepthRange::MinusOneToOne),
                Plane::Far => (2, -1.0, true),
            };
            let w = if with_w { 1.0 } else { 0.0 };
            let Product { exact, magnitude, underflow } = &product;
            let [a, b, c, d] = [0, 1, 2, 3].map(|j| w * exact[3][j] + sign * exact[axis][j]);
            let mut slack = [0, 1, 2, 3].map(|j| ROUNDING * (w * magnitude[3][j] + magnitude[axis][j]));
            slack[3] += w * underflow[3] + underflow[axis];
            Halfspace { normal: [a, b, c], offset: d, slack }
        });
        Self { planes, largest }
    }

    /// How a body stands to one plane.
    #[inline]
    pub fn reach(&self, plane: Plane, volume: &Volume) -> Reach {
        let Halfspace { normal, offset, slack } = &self.planes[plane as usize];
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let (middle, spread, size) = match *volume {
            Volume::Sphere(Sphere { center, radius }) => {
                let (center, radius) = (center.map(f64::from), f64::from(radius));
                (center, dot(*normal, *normal).sqrt() * radius, center.map(|c| c.abs() + radius))
            }
            Volume::Box([min, max]) => {
                let (min, max) = (min.map(f64::from), max.map(f64::from));
                let middle = [0, 1, 2].map(|i| (min[i] + max[i]) / 2.0);
                let half = [0, 1, 2].map(|i| (max[i] - min[i]) / 2.0);
                let size = [0, 1, 2].map(|i| min[i].abs().max(max[i].abs()));
                (middle, dot(normal.map(f64::abs), half), size)
            }
        };
        let [a, b, c, d] = *slack;
        let mut slack = dot([a, b, c], size) + d;
        let [x, y, z, w] = self.largest;
        if dot([x, y, z], size) + w > f64::from(f32::MAX) {
            slack = f64::INFINITY; // a product may leave the range of binary32
        }
        Reach { distance: dot(*normal, middle) + offset, spread, slack }
    }

    /// Tests a body against the planes of a mask, in order, up to the first that it lies outside of;
    /// each is reported.
    ///
    /// `Err`: that plane; all vertices of the pipeline within the body lie strictly outside of it. `Ok`:
    /// the planes that the body crosses; of all others its vertices lie inside. A few ns a plane.
    #[inline]
    pub fn test(
        &self,
        volume: &Volume,
        mask: PlaneMask,
        mut report: impl FnMut(Plane, Side),
    ) -> Result<PlaneMask, Plane> {
        let mut crossed = mask;
        for plane in mask.planes() {
            let side = self.reach(plane, volume).side();
            report(plane, side);
            match side {
                Side::Outside => return Err(plane),
                Side::Inside => crossed = crossed.without(plane),
                Side::Crosses => {}
            }
        }
        Ok(crossed)
    }
}
