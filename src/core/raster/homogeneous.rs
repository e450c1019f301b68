//! Homogeneous rasterization: edges from the (x, y, w) of the vertices, no division and no clipping.
//!
//! The adjugate of the matrix with the rows (x, y, w) holds one edge function a column: a pseudo-attribute
//! that is 1 at one vertex and 0 along the edge opposite to it, over w. A centre is inside if all three
//! have the sign of the determinant; their sum has it too then, so that 1/w is positive: vertices
//! behind the eye need no care. The near plane is a fourth edge.
//!
//! *Source:* Olano and Greer, Triangle Scan Conversion using 2D Homogeneous Coordinates, 1997. Deviation:
//! signs are exact, by expansions behind a filter.

mod explain;
mod form;
mod formulas;
mod marks;
mod report;

pub use explain::Snapshot;

use super::{
    Counts, Mistake, Settings, Span,
    aabb::Aabb,
    first_centre,
    traversal::{self, Area, Traversal},
};
use crate::{
    math::{Arithmetic, Real, Sign, Tally, orient3d_homogeneous},
    replay::{Budget, Player},
    trace::{Lift, NoTrace, Tracer},
};
use form::{Exact, Form, Taught, ends};
use serde::Serialize;

/// x and y in pixels, each times w; and w. A point of the screen is x/w, y/w.
pub type Vertex = [f32; 3];

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", rename_all_fields = "snake_case")]
pub enum Event {
    /// One number of the adjugate: a coefficient of an edge function `a x + b y + c`.
    Coefficient {
        /// Which edge: the one opposite to this vertex.
        edge: u8,
        /// 0: a, 1: b, 2: c.
        term: u8,
        /// As computed.
        value: f64,
    },
    /// The determinant of the three vertices.
    Determinant {
        /// As computed; 0 if it is exactly 0.
        value: f64,
    },
    /// The determinant is exactly zero: the triangle has no area, or is seen edge-on.
    ZeroArea,
    /// The determinant is negative: all signs are turned.
    Turned,
    /// One coefficient of the sum of the edge functions, which is det/w.
    InverseW {
        /// 0: a, 1: b, 2: c.
        term: u8,
        /// As computed.
        value: f64,
    },
    /// One coefficient of the near plane's edge function.
    Near {
        /// 0: a, 1: b, 2: c.
        term: u8,
        /// As computed.
        value: f64,
    },
    /// The centres that may be covered.
    Box {
        /// First column, and one past the last.
        columns: [u16; 2],
        /// First row, and one past the last.
        rows: [u16; 2],
        /// Whether a vertex is not in front of the eye, so that it is the whole image.
        whole: bool,
    },
    /// A step of the way over the centres.
    Walk {
        /// What it did.
        event: traversal::Event,
        /// Whether centres are compared with the near plane, too.
        near: bool,
    },
    /// All is done.
    Done,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Covers the pixels whose centres lie inside, in front of the eye and not nearer than `near`.
///
/// All finite vertices are legal, any sign of w, either winding; a triangle seen edge-on covers nothing.
/// With all w = 1 it is [`cover`](super::cover) of the other algorithms, bit for bit. `near` is a
/// smallest w; more than zero. Cost: three edge functions for each centre of the bounding box, about 1 ns
/// each, and an exact sign where one is doubtful; of the whole image if a vertex is not in front of the
/// eye. The near plane costs about 30 ns a centre.
pub fn fill(
    vertices: [Vertex; 3],
    near: Option<f32>,
    settings: &Settings,
    tally: &mut Tally,
    emit: &mut impl FnMut(Span),
) -> Counts {
    fill_traced(vertices, near, settings, tally, &mut NoTrace, emit)
}

/// [`fill`] as a run that can be scrubbed.
pub fn play(
    vertices: [Vertex; 3],
    near: Option<f32>,
    settings: Settings,
    budget: Budget,
) -> Player<Snapshot> {
    Player::new(Snapshot::new(vertices, near, settings), budget, move |t| {
        fill_traced(vertices, near, &settings, &mut Tally::default(), t, &mut |_| {});
    })
}

/// The algorithm, in any arithmetic, with the way over the centres of [`aabb`](super::aabb).
///
/// `F32` and `F64` round the adjugate and the edge functions as they are printed.
pub fn fill_traced<T: Tracer<Event>>(
    vertices: [Vertex; 3],
    near: Option<f32>,
    settings: &Settings,
    tally: &mut Tally,
    t: &mut T,
    emit: &mut impl FnMut(Span),
) -> Counts {
    let subject = (rasterized(vertices, settings), near);
    if settings.arithmetic == Arithmetic::F32 {
        let walk = |area: &Area, form, _: &mut Tally, t: &mut Lifted<'_, T>, emit: &mut _| {
            Aabb::walk(area, &mut Taught::<f32>(form), t, emit)
        };
        run(subject, settings, tally, t, emit, walk)
    } else {
        let exact = is_exact(settings);
        let walk = |area: &Area, form, tally: &mut Tally, t: &mut Lifted<'_, T>, emit: &mut _| {
            if exact {
                Aabb::walk(area, &mut Exact::new(form, area.columns.end, tally), t, emit)
            } else {
                Aabb::walk(area, &mut Taught::<f64>(form), t, emit)
            }
        };
        run(subject, settings, tally, t, emit, walk)
    }
}

/// The way over the centres as part of this run.
type Lifted<'t, T> = Lift<'t, T, fn(traversal::Event) -> Event>;

/// The text of the algorithm, for coefficients of any type.
fn run<R: Real, T: Tracer<Event>, E: FnMut(Span)>(
    (vertices, near): ([Vertex; 3], Option<f32>),
    settings: &Settings,
    tally: &mut Tally,
    t: &mut T,
    emit: &mut E,
    walk: impl FnOnce(&Area, Form<R>, &mut Tally, &mut Lifted<'_, T>, &mut E) -> Counts,
) -> Counts {
    let adjugate = Adjugate::<R>::new(vertices);
    for (edge, coefficients) in (0..).zip(adjugate.edges) {
        for (term, value) in (0..).zip(coefficients) {
            t.emit(|| Event::Coefficient { edge, term, value: value.to_f64() });
        }
    }
    let [a, b, c] = vertices;
    let turned = orient3d_homogeneous(a, b, c, tally);
    let determinant = adjugate.determinant.to_f64();
    t.emit(|| Event::Determinant { value: if turned.is_zero() { 0.0 } else { determinant } });
    if turned.is_zero() {
        t.emit(|| Event::ZeroArea);
        return Counts::default();
    }
    if turned.is_negative() {
        t.emit(|| Event::Turned);
    }
    let form = Form::new((vertices, near), turned, adjugate.turned(turned), settings);
    for (term, value) in (0..).zip(form.adjugate.sum()) {
        t.emit(|| Event::InverseW { term, value: value.to_f64() });
    }
    for (term, value) in (0..).zip(form.near_edge().into_iter().flatten()) {
        t.emit(|| Event::Near { term, value: value.to_f64() });
    }
    let area = area(vertices, settings);
    t.emit(|| Event::Box {
        columns: [area.columns.start as u16, area.columns.end as u16],
        rows: [area.rows.start as u16, area.rows.end as u16],
        whole: !all_in_front(vertices),
    });
    let lift: fn(traversal::Event) -> Event = match near {
        Some(_) => |event| Event::Walk { event, near: true },
        None => |event| Event::Walk { event, near: false },
    };
    let counts =
        if area.is_empty() { Counts::default() } else { walk(&area, form, tally, &mut Lift(t, lift), emit) };
    t.emit(|| Event::Done);
    counts
}

/// Whether signs are asked for exactly: not by who rounds, nor by who has an epsilon.
fn is_exact(settings: &Settings) -> bool {
    settings.arithmetic.is_exact() && settings.epsilon().is_none()
}

/// The vertices that are rasterized: as given, or divided first by mistake, which forgets the sign of w.
/// What has no finite quotient stays as it is.
fn rasterized(vertices: [Vertex; 3], settings: &Settings) -> [Vertex; 3] {
    if settings.mistake != Some(Mistake::DivideFirst) {
        return vertices;
    }
    vertices.map(|vertex @ [x, y, w]| {
        let divided = [x / w, y / w, 1.0];
        if divided.iter().all(|value| value.is_finite()) { divided } else { vertex }
    })
}

/// The columns of the adjugate, each the edge function opposite to a vertex, and the determinant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Adjugate<R> {
    edges: [[R; 3]; 3],
    determinant: R,
}

impl<R: Real> Adjugate<R> {
    /// Each column is the cross product of the other two vertices.
    fn new(vertices: [Vertex; 3]) -> Self {
        let edges = [0, 1, 2].map(|edge| {
            let [p, q] = ends(vertices, edge).map(|vertex| vertex.map(R::from_f32));
            [[1, 2], [2, 0], [0, 1]].map(|[i, j]| p[i] * q[j] - p[j] * q[i])
        });
        let [a, _, _] = vertices.map(|vertex| vertex.map(R::from_f32));
        let [u, _, _] = edges;
        Self { edges, determinant: a[0] * u[0] + a[1] * u[1] + a[2] * u[2] }
    }

    /// With every sign turned if the determinant is negative.
    fn turned(self, sign: Sign) -> Self {
        let turn = |value: R| if sign.is_negative() { -value } else { value };
        Self { edges: self.edges.map(|edge| edge.map(turn)), determinant: turn(self.determinant) }
    }

    /// The sum of the edge functions: det/w.
    fn sum(&self) -> [R; 3] {
        let [u, v, w] = self.edges;
        [0, 1, 2].map(|i| u[i] + v[i] + w[i])
    }

    /// The near plane as an edge function: `det - near det/w`.
    fn near_edge(&self, near: R) -> [R; 3] {
        let [a, b, c] = self.sum();
        [-(near * a), -(near * b), self.determinant - near * c]
    }
}

fn all_in_front(vertices: [Vertex; 3]) -> bool {
    vertices.iter().all(|[_, _, w]| *w > 0.0)
}

/// The centres that may be covered: around the projected vertices if all lie in front of the eye.
fn area(vertices: [Vertex; 3], settings: &Settings) -> Area {
    let [columns, rows] = [0, 1].map(|axis| bounds(vertices, axis, settings.size[axis]));
    Area { start: columns.start, columns, rows, y_axis: settings.y_axis, skip_row: settings.skip_row }
}

fn bounds(vertices: [Vertex; 3], axis: usize, limit: u32) -> std::ops::Range<u32> {
    if !all_in_front(vertices) {
        return 0..limit;
    }
    let [a, b, c] = vertices.map(|vertex| f64::from(vertex[axis]) / f64::from(vertex[2]));
    // One rounding of a quotient, which is monotone: a neighbour covers it.
    let (least, greatest) = (a.min(b).min(c).next_down(), a.max(b).max(c).next_up());
    let begin = first_centre(least, false, limit);
    begin..first_centre(greatest, true, limit).max(begin)
}
