//! A triangle against the planes of clip space, before the divide, without an error.
//!
//! Corners are known by where they come from (a vertex; an edge and a plane; the inside and two
//! planes), never by rounded coordinates. Every decision is the exact sign of an expression in the
//! original vertices, and each coordinate is rounded once. So a corner depends on nothing but the edge
//! and the plane: triangles that share an edge meet in the same bits.
//!
//! *Source:* Sutherland and Hodgman, Reentrant Polygon Clipping, 1974; Blinn and Newell, Clipping Using
//! Homogeneous Coordinates, 1978. Deviations: provenance and exact signs; one vertex is never emitted
//! twice; a result without area is empty.

use std::ops::{Add, Mul, Sub};

use super::{Plane, PlaneSet, distance_is_negative, distance_terms};
use crate::{
    math::{Approx, Dyadic, Sign, Tally, expansion::two_sum, rounded_ratio},
    transform::DepthRange,
};

/// Where a corner comes from. An edge is named by the vertex opposite to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Origin {
    /// A vertex of the triangle.
    Vertex(u8),
    /// Where an edge crosses a plane.
    Edge {
        /// The edge.
        edge: u8,
        /// The plane.
        plane: Plane,
    },
    /// Where the edge of the frustum between two planes pierces the triangle.
    Interior {
        /// The planes.
        planes: [Plane; 2],
    },
}

/// One corner of a clipped triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// In clip space; correctly rounded, a vertex of the triangle bit for bit.
    pub position: [f32; 4],
    /// Where it comes from.
    pub origin: Origin,
}

/// Most corners: each plane adds at most one to the three.
pub const MOST_CORNERS: usize = 9;

/// A clipped triangle: a convex polygon that turns like the triangle. It fulfils the planes'
/// inequalities exactly and no corner occurs twice; it has no corner or at least three.
#[derive(Clone, Debug)]
pub struct Polygon {
    corners: [Corner; MOST_CORNERS],
    len: usize,
    triangle: Triangle,
}

/// The original triangle: what every decision is made from.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    vertices: [[f32; 4]; 3],
    range: DepthRange,
}

/// The line that an edge of the polygon lies on.
#[derive(Clone, Copy, Debug)]
enum Line {
    Edge(u8),
    Plane(Plane),
}

/// A corner during clipping, and the line from it to the next one.
#[derive(Clone, Copy, Debug)]
struct Node {
    origin: Origin,
    next: Line,
}

/// Clips a triangle against the planes of clip space.
///
/// All finite vertices are legal, any w, any shape; a triangle inside comes back bit for bit. The result
/// depends on the order of the vertices only in where it starts and which way it turns. Costs three
/// comparisons a plane if nothing is cut, about 100 ns a corner otherwise; `tally` counts signs and
/// roundings of cut triangles.
pub fn clip_triangle(
    vertices: [[f32; 4]; 3],
    range: DepthRange,
    planes: PlaneSet,
    tally: &mut Tally,
) -> Polygon {
    let triangle = Triangle { vertices, range };
    let node = |i: u8| Node { origin: Origin::Vertex(i), next: Line::Edge((i + 2) % 3) };
    let mut nodes = Nodes { nodes: [node(0); MOST_CORNERS], len: 0 };
    (0..3).for_each(|i| nodes.push(node(i)));
    for &plane in planes.planes() {
        let outside = vertices.map(|vertex| distance_is_negative(plane, vertex, range));
        if outside == [true; 3] {
            nodes.len = 0;
            break;
        }
        if outside != [false; 3] {
            nodes = nodes.cut(plane, &triangle, tally);
        }
    }
    triangle.polygon(&nodes, tally)
}

/// The polygon during clipping.
#[derive(Clone, Copy)]
struct Nodes {
    nodes: [Node; MOST_CORNERS],
    len: usize,
}

impl Nodes {
    fn push(&mut self, node: Node) {
        self.nodes[self.len] = node;
        self.len += 1;
    }

    /// One round of Sutherland-Hodgman. A corner exactly on the plane stays what it is; a new one is
    /// made only where the sides differ strictly, so that none occurs twice.
    fn cut(&self, plane: Plane, triangle: &Triangle, tally: &mut Tally) -> Self {
        let mut sides = [Sign::Zero; MOST_CORNERS];
        for (side, node) in sides.iter_mut().zip(&self.nodes[..self.len]) {
            *side = triangle.side(node.origin, plane, tally);
        }
        let mut out = Self { len: 0, ..*self };
        for i in 0..self.len {
            let node = self.nodes[i];
            let (here, there) = (sides[i], sides[(i + 1) % self.len]);
            let crossing = match node.next {
                Line::Edge(edge) => Origin::Edge { edge, plane },
                Line::Plane(other) => Origin::Interior { planes: [other, plane] },
            };
            match (here, there) {
                (Sign::Positive, Sign::Negative) => {
                    out.push(node);
                    out.push(Node { origin: crossing, next: Line::Plane(plane) });
                }
                (Sign::Negative, Sign::Positive) => out.push(Node { origin: crossing, next: node.next }),
                (Sign::Zero, Sign::Negative) => out.push(Node { next: Line::Plane(plane), ..node }),
                (Sign::Negative, _) => {}
                (Sign::Positive | Sign::Zero, _) => out.push(node),
            }
        }
        if out.len < 3 {
            out.len = 0; // only a point or an edge touches the plane
        }
        out
    }
}

impl Polygon {
    /// The corners in order.
    pub fn corners(&self) -> &[Corner] {
        &self.corners[..self.len]
    }

    /// Whether the triangle came through as it was.
    pub fn is_whole(&self) -> bool {
        self.len == 3 && self.corners().iter().all(|corner| matches!(corner.origin, Origin::Vertex(_)))
    }

    /// An attribute at a corner, from its values at the triangle's vertices: the correctly rounded value of
    /// the affine function on the unclipped triangle; at a vertex its value bit for bit.
    pub fn attribute(&self, corner: &Corner, values: [f32; 3], tally: &mut Tally) -> f32 {
        self.triangle.interpolate(corner.origin, values, tally)
    }

    /// Triangles that make up the polygon, as indices of corners, turning like it.
    ///
    /// All share the corner with the largest y (then x, z, w), wherever the polygon starts, so that the
    /// order of the vertices does not show in the triangles. Three corners are left in their order.
    pub fn fan(&self) -> impl Iterator<Item = [usize; 3]> {
        let len = self.len;
        let highest = (0..len).max_by(|&i, &j| {
            let [a, b] = [i, j].map(|i| self.corners[i].position);
            let by = |axis: usize| a[axis].total_cmp(&b[axis]);
            by(1).then(by(0)).then(by(2)).then(by(3))
        });
        let apex = if len == 3 { 0 } else { highest.unwrap_or(0) };
        (2..len).map(move |i| [apex, (apex + i - 1) % len, (apex + i) % len])
    }
}

/// What weights are computed in: first with an error bound, then without an error.
trait Number: Clone + From<f32> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {}
impl Number for Approx {}
impl Number for Dyadic {}

fn dot<N: Number>([a, b, c]: [N; 3], [x, y, z]: [N; 3]) -> N {
    a * x + b * y + c * z
}

impl Triangle {
    fn terms(&self, plane: Plane) -> [[f32; 2]; 3] {
        self.vertices.map(|vertex| distance_terms(plane, vertex, self.range))
    }

    /// The vertices' distances from a plane, nearly: the error is that of one sum.
    fn near_distances(&self, plane: Plane) -> [Approx; 3] {
        self.terms(plane).map(|[a, b]| {
            let (value, tail) = two_sum(f64::from(a), f64::from(b));
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
                let [a, b] = distance_terms(plane, vertex, self.range);
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

    /// An affine function with these values at the vertices, at a corner, correctly rounded.
    fn interpolate(&self, origin: Origin, values: [f32; 3], tally: &mut Tally) -> f32 {
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

    /// Rounds the corners. Two that become the same are one, and what has no third corner is empty.
    fn polygon(self, nodes: &Nodes, tally: &mut Tally) -> Polygon {
        let nothing = Corner { position: [0.0; 4], origin: Origin::Vertex(0) };
        let mut polygon = Polygon { corners: [nothing; MOST_CORNERS], len: 0, triangle: self };
        for &Node { origin, .. } in &nodes.nodes[..nodes.len] {
            let position = match origin {
                Origin::Vertex(i) => self.vertices[usize::from(i)],
                _ => [0, 1, 2, 3].map(|k| self.interpolate(origin, self.vertices.map(|v| v[k]), tally)),
            };
            polygon.corners[polygon.len] = Corner { position, origin };
            polygon.len += 1;
        }
        if !polygon.is_whole() {
            polygon.merge();
        }
        polygon
    }
}

impl Polygon {
    /// Removes corners that rounding has put on the corner before them.
    fn merge(&mut self) {
        let all = self.corners;
        let len = self.len;
        self.len = 0;
        for i in 0..len {
            if all[i].position != all[(i + len - 1) % len].position {
                self.corners[self.len] = all[i];
                self.len += 1;
            }
        }
        if self.len < 3 {
            self.len = 0;
        }
    }
}
