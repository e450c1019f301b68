//! A triangle against one plane: three signed distances, four cases, at most two triangles.
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 3.14.1, for one
//! plane with a point p and a normal n, `d = (v - p) · n`, and the intersection
//! `t = db / (db - da)`, `x = t a + (1 - t) b`. Deviations: in exact arithmetic each decision is the exact
//! sign and each number is rounded once; a triangle with two equal corners is dropped; the quadrangle is
//! always split at the corner after the vertex outside.

mod explain;
mod form;
mod picture;

pub use explain::Snapshot;

use crate::{
    math::{Arithmetic, Sign, Tally},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use form::{Exact, Form, Taught};
use serde::Serialize;

/// A plane by a point on it and a normal that points inwards, of any length but zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace {
    /// p.
    pub point: [f32; 3],
    /// n; distances are multiples of its length.
    pub normal: [f32; 3],
}

/// A corner of the result.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Corner {
    /// A vertex of the triangle.
    Vertex(u8),
    /// A new one: `x0` on the edge that ends at the vertex alone on its side, `x1` on the edge that begins
    /// there.
    New(u8),
}

/// What the algorithm did. A point in binary64 takes more than 16 bytes; there are at most nine events.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The distance of a vertex is known.
    Distance {
        /// Which vertex.
        vertex: u8,
        /// Zero counts as inside.
        side: Sign,
        /// The distance, rounded.
        distance: f64,
    },
    /// All three are inside: the triangle stays.
    Keep,
    /// None is inside: nothing is left.
    Reject,
    /// One vertex is alone on its side.
    Alone {
        /// Which.
        vertex: u8,
        /// Whether it is the one inside.
        inside: bool,
    },
    /// Where an edge crosses the plane: what the end inside weighs.
    Share {
        /// x0 or x1.
        new: u8,
        /// The end inside.
        a: u8,
        /// The end outside.
        b: u8,
        /// db / (db - da).
        t: f64,
    },
    /// A new corner.
    Cross {
        /// x0 or x1.
        new: u8,
        /// Its coordinates.
        at: [f64; 3],
    },
    /// A triangle of the result, turning like the given one.
    Triangle {
        /// Its corners.
        corners: [Corner; 3],
    },
    /// A triangle has two equal corners, since a vertex lies on the plane: it is dropped.
    Flat {
        /// Its corners.
        corners: [Corner; 3],
    },
}

/// What is left of a triangle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// The new corners, if there are any: x0 and x1.
    pub new: Vec<[f32; 3]>,
    /// At most two triangles.
    pub triangles: Vec<[Corner; 3]>,
}

/// Clips a triangle of finite vertices at a plane.
///
/// A vertex on the plane counts as inside, and a normal of zero has everything inside. What lies inside
/// stays as it is. The space is any in which points have three coordinates, such as camera space. Costs
/// three scalar products, and one division for each new corner.
pub fn clip(vertices: [[f32; 3]; 3], plane: HalfSpace, arithmetic: Arithmetic) -> Outcome {
    clip_traced(vertices, plane, arithmetic, &mut Tally::default(), &mut NoTrace)
}

/// [`clip`] as a run that can be scrubbed.
pub fn play(
    vertices: [[f32; 3]; 3],
    plane: HalfSpace,
    arithmetic: Arithmetic,
    budget: Budget,
) -> Player<Snapshot> {
    Player::new(Snapshot::new(vertices, plane, arithmetic), budget, move |t| {
        clip_traced(vertices, plane, arithmetic, &mut Tally::default(), t);
    })
}

/// The algorithm: [`clip`] and [`play`] are this with two tracers.
///
/// `F32` and `F64` compute as the lecture prints it. Fixed point is the exact form here. `tally` counts
/// exact decisions.
pub fn clip_traced<T: Tracer<Event>>(
    vertices: [[f32; 3]; 3],
    plane: HalfSpace,
    arithmetic: Arithmetic,
    tally: &mut Tally,
    t: &mut T,
) -> Outcome {
    match arithmetic {
        Arithmetic::F32 => run(&mut Taught::<f32>::new(vertices, plane), t),
        Arithmetic::F64 => run(&mut Taught::<f64>::new(vertices, plane), t),
        _ => run(&mut Exact::new(vertices, plane, tally), t),
    }
}

/// The text of the algorithm, in any form of arithmetic.
fn run<F: Form, T: Tracer<Event>>(form: &mut F, t: &mut T) -> Outcome {
    let sides = [0, 1, 2].map(|vertex| {
        let side = form.side(vertex);
        t.emit(|| Event::Distance { vertex: vertex as u8, side, distance: form.distance(vertex) });
        side
    });
    let inside = sides.map(|side| side != Sign::Negative);
    let count = inside.iter().filter(|inside| **inside).count();
    if count == 3 {
        t.emit(|| Event::Keep);
        return Outcome { new: Vec::new(), triangles: vec![[0, 1, 2].map(Corner::Vertex)] };
    }
    if count == 0 {
        t.emit(|| Event::Reject);
        return Outcome::default();
    }
    // The one that is alone on its side; the others follow it in the order of the triangle.
    let one_in = count == 1;
    let alone = inside.iter().position(|&inside| inside == one_in).unwrap_or(0);
    t.emit(|| Event::Alone { vertex: alone as u8, inside: one_in });
    let (next, last) = ((alone + 1) % 3, (alone + 2) % 3);
    let new = [(0, last), (1, next)].map(|(new, other)| {
        let [a, b] = if one_in { [alone, other] } else { [other, alone] };
        let share = form.share(a, b);
        t.emit(|| Event::Share { new, a: a as u8, b: b as u8, t: share });
        let at = form.cross(a, b);
        t.emit(|| Event::Cross { new, at });
        at
    });
    let vertex = |i: usize| Corner::Vertex(i as u8);
    let (x0, x1) = (Corner::New(0), Corner::New(1));
    // Where the end inside lies on the plane the crossing is that vertex again.
    let on_plane = |vertex: usize| sides[vertex] == Sign::Zero;
    let all = if one_in {
        vec![([vertex(alone), x1, x0], on_plane(alone))]
    } else {
        vec![([vertex(next), vertex(last), x0], on_plane(last)), ([vertex(next), x0, x1], on_plane(next))]
    };
    let mut triangles = Vec::with_capacity(2);
    for (corners, flat) in all {
        if flat {
            t.emit(|| Event::Flat { corners });
        } else {
            t.emit(|| Event::Triangle { corners });
            triangles.push(corners);
        }
    }
    Outcome { new: new.map(|at| at.map(|c| c as f32)).to_vec(), triangles }
}
