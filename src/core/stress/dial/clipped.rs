//! Cases to be clipped: lines and polygons against a window, triangles against the frustum.

use super::{Drive, narrow};
use crate::{
    labs::{ClipLine, ClipPolygon, ClipTriangle, Family as _},
    scene::Scene,
    stress::{Family, segments},
    transform::{Projection, matrices},
};

type Point = [f64; 2];

impl Drive {
    /// The ends of a line that touches the window in a corner, but for less and less; and a point beyond that corner.
    ///
    /// Nearly parallel lines come down to one border, too.
    fn past_a_corner(&mut self) -> [Point; 3] {
        let sides = segments::sides(Family::Ordinary).map(f64::from);
        let out = [self.sign(), self.sign()];
        let corner = [0, 1].map(|axis| sides[if out[axis] > 0.0 { axis + 2 } else { axis }]);
        let mut along = [self.uniform(1.0, 6.0) * out[0], -self.uniform(1.0, 6.0) * out[1]];
        if self.family == Family::NearlyParallel {
            along[self.random.below(2)] *= self.shrunk(20.0);
        }
        let back = self.uniform(0.5, 1.5);
        let by = self.uniform(-1.5, 1.5) * self.shrunk(24.0);
        let away = self.uniform(1.0, 3.0);
        [
            [0, 1].map(|axis| corner[axis] + along[axis]),
            [0, 1].map(|axis| corner[axis] - along[axis] * back + out[axis] * by),
            [0, 1].map(|axis| corner[axis] + out[axis] * away),
        ]
    }

    /// The ends of a line through the origin, farther and farther away, and a point near the window.
    fn far_ends(&mut self) -> [Point; 3] {
        let turn = self.uniform(0.0, std::f64::consts::TAU);
        let (sin, cos) = libm::sincos(turn);
        let far = self.uniform(4.0, 9.0) * self.grown(118.0);
        // Binary32 numbers, and a power of two: the line goes exactly through the origin.
        let end = [cos * far, sin * far].map(narrow).map(f64::from);
        let back = self.random.pick(&[0.5, 1.0, 2.0]);
        let side = self.uniform(3.0, 9.0) * self.sign();
        [end, end.map(|c| -c * back), [-sin * side, cos * side]]
    }

    fn ends(&mut self) -> [Point; 3] {
        if self.family == Family::Huge { self.far_ends() } else { self.past_a_corner() }
    }

    pub(super) fn line(&mut self) -> ClipLine {
        let [[x0, y0], [x1, y1], _] = self.ends().map(|end| end.map(narrow));
        let window = segments::sides(Family::Ordinary);
        ClipLine { window, segment: [x0, y0, x1, y1], ..ClipLine::first() }
    }

    pub(super) fn polygon(&mut self) -> ClipPolygon {
        let polygon = self.ends().map(|corner| corner.map(narrow)).to_vec();
        ClipPolygon { window: segments::sides(Family::Ordinary), polygon, ..ClipPolygon::first() }
    }

    /// A triangle in camera space.
    pub(super) fn triangle(&mut self, scene: &Scene) -> ClipTriangle {
        let vertices = match self.family {
            Family::Huge => self.far_vertices(scene),
            _ => self.past_an_edge(scene),
        };
        ClipTriangle { vertices: Some(vertices.map(|vertex| vertex.map(narrow))), ..ClipTriangle::first() }
    }

    /// One side along an edge of the frustum, but for less and less: the rest is beyond it, or where the plane of the
    /// triangle nearly holds that edge.
    fn past_an_edge(&mut self, scene: &Scene) -> [[f64; 3]; 3] {
        let [width, height] = scene.size.map(f64::from);
        let matrix = matrices::projection(&scene.camera, width / height, scene.depth_range, false);
        let perspective = matches!(scene.camera.projection, Projection::Perspective { .. });
        let out = [self.sign(), self.sign()];
        let [near, far] = [scene.camera.near, scene.camera.far].map(f64::from);
        let on = |part: f64, by: [f64; 2]| {
            let distance = near + part * (far - near);
            let w = if perspective { distance } else { 1.0 };
            let [x, y] = [matrix[0], matrix[5]].map(|scale| w / f64::from(scale));
            [out[0] * (x + w * by[0]), out[1] * (y + w * by[1]), -distance]
        };
        let by = self.shrunk(18.0);
        let [a, b] = [self.uniform(0.05, 0.3), self.uniform(0.4, 0.8)];
        let [p, q] = [self.uniform(-0.4, 0.4) * by, self.uniform(-0.4, 0.4) * by];
        let [far, mid] = [self.uniform(0.3, 0.6), self.uniform(0.2, 0.6)];
        match self.family {
            Family::Beside => [on(a, [p, q]), on(b, [q, p]), on(mid, [far, far])],
            _ => [on(a, [p, -p]), on(b, [-q, q]), on(mid, [-far, -far])],
        }
    }

    /// One vertex in the frustum, two farther and farther away on both sides of it.
    fn far_vertices(&mut self, scene: &Scene) -> [[f64; 3]; 3] {
        let near = f64::from(scene.camera.near);
        let mut vertices: [[f64; 3]; 3] = std::array::from_fn(|_| {
            let distance = near * self.uniform(0.2, 4.0);
            [self.uniform(-2.0, 2.0) * distance, self.uniform(-2.0, 2.0) * distance, -distance]
        });
        let by = self.grown(110.0);
        vertices[1..].iter_mut().for_each(|vertex| *vertex = vertex.map(|c| c * by));
        vertices
    }
}
