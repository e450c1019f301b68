//! The arithmetics in which a triangle is clipped at a plane.

use super::HalfSpace;
use crate::math::{Approx, Dyadic, Real, Sign, Tally, rounded_ratio};

/// What the text of the algorithm asks for.
pub(super) trait Form {
    /// On which side a vertex lies.
    fn side(&mut self, vertex: usize) -> Sign;
    /// Its distance, rounded.
    fn distance(&mut self, vertex: usize) -> f64;
    /// What the end `a` inside weighs where its edge to `b` outside crosses the plane.
    fn share(&mut self, a: usize, b: usize) -> f64;
    /// That point.
    fn cross(&mut self, a: usize, b: usize) -> [f64; 3];
}

/// Exact signs; each number rounded once to binary32.
pub(super) struct Exact<'a> {
    vertices: [[f32; 3]; 3],
    plane: HalfSpace,
    near: [Approx; 3],
    tally: &'a mut Tally,
}

impl<'a> Exact<'a> {
    pub(super) fn new(vertices: [[f32; 3]; 3], plane: HalfSpace, tally: &'a mut Tally) -> Self {
        let near = vertices.map(|vertex| dot(vertex, plane));
        Self { vertices, plane, near, tally }
    }

    fn exact(&self, vertex: usize) -> Dyadic {
        dot(self.vertices[vertex], self.plane)
    }

    /// A sum of the ends' values, weighted by the other end's distance, over the sum of the weights.
    fn mix(&mut self, a: usize, b: usize, values: [f32; 2]) -> f64 {
        let [da, db] = [a, b].map(|vertex| self.near[vertex]);
        let [near_a, near_b] = values.map(Approx::from);
        let (vertices, plane) = (self.vertices, self.plane);
        let exact = || {
            let [da, db] = [a, b].map(|vertex| dot::<Dyadic>(vertices[vertex], plane));
            let [a, b] = values.map(Dyadic::from);
            (&db * &a - &da * &b, db - da)
        };
        f64::from(rounded_ratio((db * near_a - da * near_b) / (db - da), exact, self.tally))
    }
}

/// `(v - p) · n`
fn dot<N>(vertex: [f32; 3], plane: HalfSpace) -> N
where
    N: From<f32> + std::ops::Add<Output = N> + std::ops::Sub<Output = N> + std::ops::Mul<Output = N>,
{
    let term =
        |axis: usize| (N::from(vertex[axis]) - N::from(plane.point[axis])) * N::from(plane.normal[axis]);
    term(0) + term(1) + term(2)
}

impl Form for Exact<'_> {
    fn side(&mut self, vertex: usize) -> Sign {
        self.tally.calls += 1;
        self.near[vertex].sign().unwrap_or_else(|| {
            self.tally.exact += 1;
            self.exact(vertex).sign()
        })
    }

    fn distance(&mut self, vertex: usize) -> f64 {
        let exact = self.exact(vertex);
        f64::from(Dyadic::ratio_to_f32(&exact, &Dyadic::from(1.0_f32)))
    }

    fn share(&mut self, a: usize, b: usize) -> f64 {
        self.mix(a, b, [1.0, 0.0])
    }

    fn cross(&mut self, a: usize, b: usize) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.mix(a, b, [self.vertices[a][axis], self.vertices[b][axis]]))
    }
}

/// As taught, in the rounded arithmetic `R`.
pub(super) struct Taught<R> {
    vertices: [[R; 3]; 3],
    distances: [R; 3],
}

impl<R: Real> Taught<R> {
    pub(super) fn new(vertices: [[f32; 3]; 3], plane: HalfSpace) -> Self {
        let vertices = vertices.map(|vertex| vertex.map(R::from_f32));
        let (p, n) = (plane.point.map(R::from_f32), plane.normal.map(R::from_f32));
        let distances = vertices.map(|v| (v[0] - p[0]) * n[0] + (v[1] - p[1]) * n[1] + (v[2] - p[2]) * n[2]);
        Self { vertices, distances }
    }

    fn t(&self, a: usize, b: usize) -> R {
        let (da, db) = (self.distances[a], self.distances[b]);
        db / (db - da)
    }
}

impl<R: Real> Form for Taught<R> {
    fn side(&mut self, vertex: usize) -> Sign {
        let distance = self.distances[vertex];
        if distance > R::ZERO {
            Sign::Positive
        } else if distance == R::ZERO {
            Sign::Zero
        } else {
            Sign::Negative
        }
    }

    fn distance(&mut self, vertex: usize) -> f64 {
        self.distances[vertex].to_f64()
    }

    fn share(&mut self, a: usize, b: usize) -> f64 {
        self.t(a, b).to_f64()
    }

    fn cross(&mut self, a: usize, b: usize) -> [f64; 3] {
        let t = self.t(a, b);
        let (va, vb) = (self.vertices[a], self.vertices[b]);
        [0, 1, 2].map(|axis| (t * va[axis] + (R::ONE - t) * vb[axis]).to_f64())
    }
}
