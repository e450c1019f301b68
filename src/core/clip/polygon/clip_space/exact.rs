//! Without an error: corners are known by where they come from, decided by exact signs, rounded once.

use std::ops::{Add, Mul, Sub};

use super::{Form, Node, Origin, Outside, Region};
use crate::{
    clip::polygon::Plane,
    math::{Approx, Dyadic, Sign, Tally, expansion::two_sum, rounded_ratio},
};

/// The original triangle: what every decision is made from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triangle<R> {
    pub(super) vertices: [[f32; 4]; 3],
    pub(super) region: R,
}

/// The form of the algorithm that the pipeline runs.
pub(super) struct Exact<'a, R> {
    pub(super) triangle: Triangle<R>,
    pub(super) tally: &'a mut Tally,
}

impl<R: Region> Form for Exact<'_, R> {
    type Value = ();

    #[inline]
    fn vertex(&self, _: usize) {}

    #[inline]
    fn outside(&self, plane: Plane, _: &[Node<()>]) -> Outside {
        let Triangle { vertices, region } = self.triangle;
        Outside::of(vertices.map(|vertex| region.excludes(plane, vertex)))
    }

    #[inline]
    fn side(&mut self, plane: Plane, node: &Node<()>) -> Sign {
        self.triangle.side(node.origin, plane, self.tally)
    }

    #[inline]
    fn cross(&mut self, _: Plane, _: &Node<()>, _: &Node<()>) {}

    fn distance(&self, plane: Plane, node: &Node<()>) -> f64 {
        self.triangle.distance(node.origin, plane)
    }

    /// What [`Triangle::place`] will say when the corners are rounded, unless a later plane cuts it off.
    fn place(&self, node: &Node<()>) -> [f64; 4] {
        self.triangle.place(node.origin, &mut Tally::default()).map(f64::from)
    }

    fn share(&self, plane: Plane, from: &Node<()>, to: &Node<()>) -> f64 {
        let [mut a, mut b] = [from, to].map(|node| self.triangle.distance(node.origin, plane));
        if a < 0.0 {
            (a, b) = (b, a);
        }
        b / (b - a)
    }
}

/// What weights are computed in: first with an error bound, then without an error.
trait Number: Clone + From<f32> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {}
impl Number for Approx {}
impl Number for Dyadic {}

fn dot<N: Number>([a, b, c]: [N; 3], [x, y, z]: [N; 3]) -> N {
    a * x + b * y + c * z
}

impl<R: Region> Triangle<R> {
    fn terms(&self, plane: Plane) -> [[f64; 2]; 3] {
        self.vertices.map(|vertex| self.region.terms(plane, vertex.map(f64::from)))
    }

    /// The vertices' distances from a plane, nearly: the error is that of one sum.
    fn near_distances(&self, plane: Plane) -> [Approx; 3] {
        self.terms(plane).map(|[a, b]| {
            let (value, tail) = two_sum(a, b);
            Approx { value, error: tail.abs() }
        })
    }

    fn exact_distances(&self, plane: Plane) -> [Dyadic; 3] {
        self.terms(plane).map(|[a, b]| Dyadic::from(a) + Dyadic::from(b))
    }

    /// Barycentric coordinates of a corner, times a common factor of either sign, not zero.
    ///
    /// On an edge they are the other end's distance; inside they are the direction in which two
    /// distances, as functions of the barycentric coordinates, vanish together.
    fn weights<N: Number>(origin: Origin, distances: impl Fn(Plane) -> [N; 3]) -> [N; 3] {
        let mut weights = [0.0; 3].map(N::from);
        match origin {
            Origin::Vertex(i) => weights[usize::from(i)] = N::from(1.0),
            Origin::Edge { edge, plane } => {
                let d = distances(plane);
                let [i, j] = [1, 2].map(|k| (usize::from(edge) + k) % 3);
                weights[i] = d[j].clone();
                weights[j] = N::from(0.0) - d[i].clone();
            }
            Origin::Interior { planes } => {
                let [a, b] = planes.map(distances);
                for (i, weight) in weights.iter_mut().enumerate() {
                    let [j, k] = [(i + 1) % 3, (i + 2) % 3];
                    *weight = a[j].clone() * b[k].clone() - a[k].clone() * b[j].clone();
                }
            }
        }
        weights
    }

    fn near_weights(&self, origin: Origin) -> [Approx; 3] {
        Self::weights(origin, |plane| self.near_distances(plane))
    }

    fn exact_weights(&self, origin: Origin) -> [Dyadic; 3] {
        Self::weights(origin, |plane| self.exact_distances(plane))
    }

    /// On which side of a plane a corner lies, exactly.
    fn side(&self, origin: Origin, plane: Plane, tally: &mut Tally) -> Sign {
        match origin {
            Origin::Vertex(i) => {
                let vertex = self.vertices[usize::from(i)];
                let [a, b] = self.region.terms(plane, vertex.map(f64::from));
                if a < -b {
                    return Sign::Negative;
                }
                return if a > -b { Sign::Positive } else { Sign::Zero };
            }
            Origin::Edge { plane: own, .. } if own == plane => return Sign::Zero,
            Origin::Interior { planes } if planes.contains(&plane) => return Sign::Zero,
            _ => {}
        }
        tally.calls += 1;
        let weights = self.near_weights(origin);
        let scale = weights[0] + weights[1] + weights[2];
        let distance = dot(weights, self.near_distances(plane));
        if let (Some(scale), Some(distance)) = (scale.sign(), distance.sign()) {
            return scale * distance;
        }
        tally.exact += 1;
        let weights = self.exact_weights(origin);
        let distance = dot(weights.clone(), self.exact_distances(plane));
        let [a, b, c] = weights;
        (a + b + c).sign() * distance.sign()
    }

    /// The distance of a corner from a plane, rounded: to be shown, never to decide.
    fn distance(&self, origin: Origin, plane: Plane) -> f64 {
        if self.side(origin, plane, &mut Tally::default()) == Sign::Zero {
            return 0.0;
        }
        let weights = self.near_weights(origin);
        let scale = weights[0] + weights[1] + weights[2];
        (dot(weights, self.near_distances(plane)) / scale).value
    }

    /// An affine function with these values at the vertices, at a corner, correctly rounded.
    pub(super) fn interpolate(&self, origin: Origin, values: [f32; 3], tally: &mut Tally) -> f32 {
        if let Origin::Vertex(i) = origin {
            return values[usize::from(i)];
        }
        let weights = self.near_weights(origin);
        let scale = weights[0] + weights[1] + weights[2];
        let near = dot(weights, values.map(Approx::from)) / scale;
        let exact = || {
            let weights = self.exact_weights(origin);
            let value = dot(weights.clone(), values.map(Dyadic::from));
            let [a, b, c] = weights;
            (value, a + b + c)
        };
        rounded_ratio(near, exact, tally)
    }

    /// Where a corner is, each coordinate correctly rounded.
    pub(super) fn place(&self, origin: Origin, tally: &mut Tally) -> [f32; 4] {
        match origin {
            Origin::Vertex(i) => self.vertices[usize::from(i)],
            _ => [0, 1, 2, 3].map(|k| self.interpolate(origin, self.vertices.map(|v| v[k]), tally)),
        }
    }
}
