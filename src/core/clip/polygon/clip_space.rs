//! A triangle against the six planes of a body in space, above all of clip space before the divide.
//!
//! Corners are known by where they come from (a vertex; an edge and a plane; the inside and two
//! planes), never by rounded coordinates. Every decision is the exact sign of an expression in the
//! original vertices, and each coordinate is rounded once. So a corner depends on nothing but the edge
//! and the plane: triangles that share an edge meet in the same bits.
//!
//! The text of the algorithm is `run`, generic over the arithmetic and the tracer: what the pipeline
//! runs, what is stepped, and what rounds as taught is one source.
//!
//! *Source:* Sutherland and Hodgman, Reentrant Polygon Clipping, 1974; Blinn and Newell, Clipping Using
//! Homogeneous Coordinates, 1978. Deviations: provenance and exact signs; one vertex is never emitted
//! twice; a result without area is empty.

mod exact;
mod region;
mod result;
mod taught;

pub use region::{CameraSpace, ClipSpace, Region};
pub use result::{Polygon, fan};
pub use taught::Order;

use super::{Plane, PlaneSet};
use crate::{
    math::{Real, Sign, Tally},
    trace::{NoTrace, Tracer},
    transform::DepthRange,
};
use exact::{Exact, Triangle};
use serde::Serialize;
use taught::{Taught, Values};

/// Where a corner comes from. An edge is named by the vertex opposite to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
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

/// What the algorithm did. A new corner has four numbers in the arithmetic of the run, so an event is
/// longer than 16 bytes; there are never more than some hundred of them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The next plane was taken, and each vertex tried against it: in exact arithmetic those of the
    /// triangle, else the corners as they stand.
    Plane {
        /// The plane.
        plane: Plane,
        /// One bit for each, the first lowest: 1 lies outside.
        outside: u16,
        /// How many were tried.
        of: u8,
    },
    /// All lie inside: the plane cuts nothing.
    Keep,
    /// All lie outside: nothing is left.
    Reject,
    /// A corner's side of the plane is known.
    Side {
        /// Its number, from 0.
        corner: u8,
        /// Negative outside, zero on the plane.
        side: Sign,
        /// Its distance, rounded.
        distance: f64,
    },
    /// An edge is done: what of it is kept went to the new polygon.
    Edge {
        /// The corner where it begins.
        from: u8,
        /// Whether that corner is kept.
        kept: bool,
        /// The crossing, if its ends lie strictly on different sides.
        crossing: Option<Crossing>,
    },
    /// The new polygon took the old one's place.
    Next {
        /// How many corners it has; none if it has no area.
        corners: u8,
    },
    /// A corner was rounded to binary32.
    Round {
        /// Its number in the clipped polygon, from 0.
        corner: u8,
        /// The coordinates.
        at: [f32; 4],
    },
    /// Rounding has put a corner on the one before it: it goes.
    Merge {
        /// Its number before.
        corner: u8,
    },
}

/// A new corner on a plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Crossing {
    /// Where it comes from.
    pub origin: Origin,
    /// `db / (db - da)`: what `a` weighs, the end inside (with [`Order::Walk`] the end walked from).
    pub t: f64,
    /// Its coordinates.
    pub at: [f64; 4],
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
    let region = ClipSpace { range, guard: planes.guard() };
    clip_exact(vertices, region, planes.planes(), tally, &mut NoTrace)
}

/// [`clip_triangle`] in any space and with any planes, for any tracer.
///
/// In camera space the planes are slanted: a rounded corner can lie beyond one by half a unit in the
/// last place; clip space has no such planes.
pub fn clip_exact<R: Region, T: Tracer<Event>>(
    vertices: [[f32; 4]; 3],
    region: R,
    planes: &[Plane],
    tally: &mut Tally,
    t: &mut T,
) -> Polygon<R> {
    let triangle = Triangle { vertices, region };
    let nodes = run(&mut Exact { triangle, tally }, planes, t);
    Polygon::new(triangle, &nodes, tally, t)
}

/// A corner in rounded arithmetic, rounded to binary32 at the end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaughtCorner {
    /// In the space of the input.
    pub corner: Corner,
    /// The attribute there.
    pub attribute: f32,
}

/// The same as taught, in the arithmetic `N`: from the corners as they stand, with one attribute.
///
/// It may answer wrongly or with numbers that are not finite: showing that is what it is for.
pub fn clip_taught<N: Real, R: Region, T: Tracer<Event>>(
    (vertices, attribute): ([[f32; 4]; 3], [f32; 3]),
    region: R,
    planes: &[Plane],
    order: Order,
    t: &mut T,
) -> Vec<TaughtCorner> {
    let mut form = Taught::<N, R>::new(vertices, attribute, region, order);
    let nodes = run(&mut form, planes, t);
    let rounded = |(corner, node): (u8, &Node<Values<N>>)| {
        let position = node.value.at.map(N::to_f32);
        t.emit(|| Event::Round { corner, at: position });
        let corner = Corner { position, origin: node.origin };
        TaughtCorner { corner, attribute: node.value.attribute.to_f32() }
    };
    (0..).zip(nodes.all()).map(rounded).collect()
}

/// The line that an edge of the polygon lies on.
#[derive(Clone, Copy, Debug)]
enum Line {
    Edge(u8),
    Plane(Plane),
}

/// A corner during clipping, and the line from it to the next one.
#[derive(Clone, Copy, Debug)]
struct Node<V> {
    origin: Origin,
    next: Line,
    value: V,
}

/// The polygon during clipping.
#[derive(Clone, Copy)]
struct Nodes<V> {
    nodes: [Node<V>; MOST_CORNERS],
    len: usize,
}

impl<V: Copy> Nodes<V> {
    fn push(&mut self, node: Node<V>) {
        self.nodes[self.len] = node;
        self.len += 1;
    }

    fn all(&self) -> &[Node<V>] {
        &self.nodes[..self.len]
    }
}

/// Which of a few vertices lie strictly outside a plane.
#[derive(Clone, Copy)]
struct Outside {
    bits: u16,
    of: u8,
}

impl Outside {
    #[inline]
    fn of([a, b, c]: [bool; 3]) -> Self {
        Self { bits: u16::from(a) | u16::from(b) << 1 | u16::from(c) << 2, of: 3 }
    }

    fn of_all(outside: impl Iterator<Item = bool>) -> Self {
        outside.fold(Self { bits: 0, of: 0 }, |Self { bits, of }, outside| Self {
            bits: bits | u16::from(outside) << of,
            of: of + 1,
        })
    }
}

/// The arithmetic in which the text of the algorithm runs.
trait Form {
    /// What a corner has besides its provenance.
    type Value: Copy;
    /// That of a vertex.
    fn vertex(&self, index: usize) -> Self::Value;
    /// Which vertices lie strictly outside a plane; all or none decides without looking at the corners.
    fn outside(&self, plane: Plane, nodes: &[Node<Self::Value>]) -> Outside;
    /// On which side of a plane a corner lies.
    fn side(&mut self, plane: Plane, node: &Node<Self::Value>) -> Sign;
    /// Where the edge between two corners on different sides crosses the plane.
    fn cross(&mut self, plane: Plane, from: &Node<Self::Value>, to: &Node<Self::Value>) -> Self::Value;
    // For the trace only: what the exact form knows without having it as a number.
    /// The distance of a corner, rounded.
    fn distance(&self, plane: Plane, node: &Node<Self::Value>) -> f64;
    /// The coordinates of a corner.
    fn place(&self, node: &Node<Self::Value>) -> [f64; 4];
    /// t of the crossing of an edge, see [`Crossing`].
    fn share(&self, plane: Plane, from: &Node<Self::Value>, to: &Node<Self::Value>) -> f64;
}

/// The text of the algorithm, in any form of arithmetic.
fn run<F: Form, T: Tracer<Event>>(form: &mut F, planes: &[Plane], t: &mut T) -> Nodes<F::Value> {
    let node = |i: u8, value| Node { origin: Origin::Vertex(i), next: Line::Edge((i + 2) % 3), value };
    let mut nodes = Nodes { nodes: [node(0, form.vertex(0)); MOST_CORNERS], len: 0 };
    (0..3).for_each(|i| nodes.push(node(i, form.vertex(usize::from(i)))));
    for &plane in planes {
        let Outside { bits, of } = form.outside(plane, nodes.all());
        t.emit(|| Event::Plane { plane, outside: bits, of });
        if bits == (1 << of) - 1 {
            t.emit(|| Event::Reject);
            nodes.len = 0;
            break;
        }
        if bits == 0 {
            t.emit(|| Event::Keep);
        } else {
            nodes = cut(&nodes, plane, form, t);
        }
    }
    nodes
}

/// One round of Sutherland-Hodgman. A corner exactly on the plane stays what it is; a new one is
/// made only where the sides differ strictly, so that none occurs twice. A call of its own: most
/// triangles never come here.
#[inline(never)]
fn cut<F: Form, T: Tracer<Event>>(
    nodes: &Nodes<F::Value>,
    plane: Plane,
    form: &mut F,
    t: &mut T,
) -> Nodes<F::Value> {
    let mut sides = [Sign::Zero; MOST_CORNERS];
    for ((side, node), corner) in sides.iter_mut().zip(nodes.all()).zip(0..) {
        *side = form.side(plane, node);
        t.emit(|| Event::Side { corner, side: *side, distance: form.distance(plane, node) });
    }
    let mut out = Nodes { len: 0, ..*nodes };
    for i in 0..nodes.len {
        let next = (i + 1) % nodes.len;
        let node = nodes.nodes[i];
        let to_plane = Line::Plane(plane);
        let (here, there) = (sides[i], sides[next]);
        let crosses =
            matches!((here, there), (Sign::Positive, Sign::Negative) | (Sign::Negative, Sign::Positive));
        let crossing = crosses.then(|| {
            let origin = match node.next {
                Line::Edge(edge) => Origin::Edge { edge, plane },
                Line::Plane(other) => Origin::Interior { planes: [other, plane] },
            };
            let value = form.cross(plane, &node, &nodes.nodes[next]);
            Node { origin, next: if here == Sign::Positive { to_plane } else { node.next }, value }
        });
        if here != Sign::Negative {
            let leaves = (here, there) == (Sign::Zero, Sign::Negative);
            out.push(Node { next: if leaves { to_plane } else { node.next }, ..node });
        }
        t.emit(|| Event::Edge {
            from: i as u8,
            kept: here != Sign::Negative,
            crossing: crossing.map(|new| Crossing {
                origin: new.origin,
                t: form.share(plane, &node, &nodes.nodes[next]),
                at: form.place(&new),
            }),
        });
        if let Some(new) = crossing {
            out.push(new);
        }
    }
    if out.len < 3 {
        out.len = 0; // only a point or an edge touches the plane
    }
    t.emit(|| Event::Next { corners: out.len as u8 });
    out
}
