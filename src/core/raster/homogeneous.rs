//! Homogeneous rasterization: edges from the (x, y, w) of the vertices, no division and no clipping.
//!
//! The adjugate of the matrix with the rows (x, y, w) holds one edge function a column: a pseudo-attribute
//! that is 1 at one vertex and 0 along the edge opposite to it, over w. A centre is inside if all three
//! have the sign of the determinant; their sum has it too then, so that 1/w is positive: vertices
//! behind the eye need no care. The near plane is a fourth edge.
//!
//! *Source:* Olano and Greer, Triangle Scan Conversion using 2D Homogeneous Coordinates, 1997. Deviation:
//! signs are exact, by expansions behind a filter.

use super::{
    Counts, FillRule, Settings, Span, YAxis,
    aabb::Aabb,
    edge::centre,
    first_centre,
    traversal::{
        Area, Event, Traversal,
        probe::{Line, Probe, RowLine, by_lines, in_doubt},
    },
};
use crate::{
    math::{Approx, Arithmetic, Dyadic, Real, Sign, Tally, orient3d_homogeneous},
    trace::{NoTrace, Tracer},
};

/// x and y in pixels, each times w; and w. A point of the screen is x/w, y/w.
pub type Vertex = [f32; 3];

/// Covers the pixels whose centres lie inside, in front of the eye and not nearer than `near`.
///
/// All finite vertices are legal, any sign of w, either winding; a triangle seen edge-on covers nothing.
/// With all w = 1 it is [`cover`](super::cover) of the other algorithms, bit for bit. `near` is a
/// smallest w; more than zero. Cost: three determinants for each centre of the bounding box, about 4 ns
/// each; of the whole image if a vertex is not in front of the eye.
pub fn fill(
    vertices: [Vertex; 3],
    near: Option<f32>,
    settings: &Settings,
    tally: &mut Tally,
    emit: &mut impl FnMut(Span),
) -> Counts {
    fill_traced(vertices, near, settings, tally, &mut NoTrace, emit)
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
    let [a, b, c] = vertices;
    let turned = orient3d_homogeneous(a, b, c, tally);
    if turned.is_zero() {
        t.emit(|| Event::ZeroArea);
        return Counts::default();
    }
    let [columns, rows] = [0, 1].map(|axis| bounds(vertices, axis, settings.size[axis]));
    let area =
        Area { start: columns.start, columns, rows, y_axis: settings.y_axis, skip_row: settings.skip_row };
    t.emit(|| Event::Box {
        columns: [area.columns.start as u16, area.columns.end as u16],
        rows: [area.rows.start as u16, area.rows.end as u16],
    });
    let ties = [0, 1, 2].map(|edge| draws_ties(gradient(vertices, edge, turned), settings));
    let form = Form { vertices, near, turned, ties };
    let counts = match settings.arithmetic {
        _ if area.is_empty() => Counts::default(),
        Arithmetic::F32 => Aabb::walk(&area, &mut Taught::<f32>::new(form), t, emit),
        Arithmetic::F64 => Aabb::walk(&area, &mut Taught::<f64>::new(form), t, emit),
        _ => Aabb::walk(&area, &mut Exact::new(form, settings.size[0], tally), t, emit),
    };
    t.emit(|| Event::Done);
    counts
}

/// The centres that may be covered: around the projected vertices if all lie in front of the eye.
fn bounds(vertices: [Vertex; 3], axis: usize, limit: u32) -> std::ops::Range<u32> {
    if vertices.iter().any(|vertex| vertex[2] <= 0.0) {
        return 0..limit;
    }
    let [a, b, c] = vertices.map(|vertex| f64::from(vertex[axis]) / f64::from(vertex[2]));
    // One rounding of a quotient, which is monotone: a neighbour covers it.
    let (least, greatest) = (a.min(b).min(c).next_down(), a.max(b).max(c).next_up());
    let begin = first_centre(least, false, limit);
    begin..first_centre(greatest, true, limit).max(begin)
}

/// What all forms need.
#[derive(Clone, Copy, Debug)]
struct Form {
    vertices: [Vertex; 3],
    near: Option<f32>,
    turned: Sign,
    ties: [bool; 3],
}

/// The edge opposite to a vertex, as the other two in order.
fn ends(vertices: [Vertex; 3], edge: usize) -> [Vertex; 2] {
    [vertices[(edge + 1) % 3], vertices[(edge + 2) % 3]]
}

/// How an edge function grows with x and with y: signs of two columns of the adjugate. Exact, since
/// a product of two f32 is.
fn gradient(vertices: [Vertex; 3], edge: usize, turned: Sign) -> [Sign; 2] {
    let [[px, py, pw], [qx, qy, qw]] = ends(vertices, edge).map(|vertex| vertex.map(f64::from));
    let order = |a: f64, b: f64| a.partial_cmp(&b).map_or(Sign::Zero, Sign::from);
    [order(py * qw, pw * qy) * turned, order(pw * qx, px * qw) * turned]
}

/// Who owns a centre on an edge: as for edges in the plane.
fn draws_ties([with_x, with_y]: [Sign; 2], settings: &Settings) -> bool {
    let left = with_x.is_positive();
    let horizontal = with_x.is_zero();
    let below = if settings.y_axis == YAxis::Down { with_y } else { -with_y };
    match settings.fill_rule {
        FillRule::TopLeft => left || horizontal && below.is_positive(),
        FillRule::RightOfPoint => left || horizontal,
        FillRule::Inclusive => true,
        FillRule::Strict => false,
    }
}

/// The bit of the near plane among those of the edges.
const NEAR: u8 = 0b1000;

/// a, b and c of each edge function `a x + b y + c`, turned so that inside is positive: the columns of
/// the adjugate.
fn functions<R: Real>(form: Form) -> [[R; 3]; 3] {
    let turn = |value: R| if form.turned.is_negative() { -value } else { value };
    [0, 1, 2].map(|edge| {
        let [p, q] = ends(form.vertices, edge).map(|vertex| vertex.map(R::from_f32));
        [[1, 2], [2, 0], [0, 1]].map(|[i, j]| turn(p[i] * q[j] - p[j] * q[i]))
    })
}

/// Exact signs. The coefficients are differences of exact products, so each is rounded once.
#[derive(Debug)]
struct Exact<'a> {
    form: Form,
    lines: [Line; 3],
    tally: &'a mut Tally,
}

impl<'a> Exact<'a> {
    /// For the columns `0..width`.
    fn new(form: Form, width: u32, tally: &'a mut Tally) -> Self {
        Self { form, lines: functions(form).map(|function| Line::new(function, width)), tally }
    }
}

impl Exact<'_> {
    /// `det >= near (E0 + E1 + E2)`, that is 1/w at most 1/near.
    fn is_behind_near(&mut self, [x, y]: [f32; 2], near: f32) -> bool {
        let Form { vertices, turned, .. } = self.form;
        self.tally.calls += 1;
        let filtered =
            near_value(vertices.map(|v| v.map(Approx::from)), [x, y].map(Approx::from), near.into());
        let sign = filtered.sign().unwrap_or_else(|| {
            self.tally.exact += 1;
            near_value(vertices.map(|v| v.map(Dyadic::from)), [x, y].map(Dyadic::from), near.into()).sign()
        });
        !(sign * turned).is_negative()
    }
}

/// The determinant less `near` times the sum of the edge functions.
fn near_value<N>([a, b, c]: [[N; 3]; 3], [x, y]: [N; 2], near: N) -> N
where
    N: Clone + std::ops::Add<Output = N> + std::ops::Sub<Output = N> + std::ops::Mul<Output = N>,
{
    let minor = |p: &[N; 3], q: &[N; 3], i: usize, j: usize| {
        p[i].clone() * q[j].clone() - p[j].clone() * q[i].clone()
    };
    let cross = |p: &[N; 3], q: &[N; 3]| [minor(p, q, 1, 2), minor(p, q, 2, 0), minor(p, q, 0, 1)];
    let [u, v, w] = [cross(&b, &c), cross(&c, &a), cross(&a, &b)];
    let sum = |i: usize| u[i].clone() + v[i].clone() + w[i].clone();
    let determinant = a[0].clone() * u[0].clone() + a[1].clone() * u[1].clone() + a[2].clone() * u[2].clone();
    determinant - near * (sum(0) * x + sum(1) * y + sum(2))
}

impl Probe for Exact<'_> {
    type Row = [RowLine; 3];

    #[inline]
    fn row(&mut self, y: u32) -> [RowLine; 3] {
        self.lines.map(|line| line.row(y))
    }

    #[inline]
    fn keeps_out(&mut self, row: &[RowLine; 3], x: u32, y: u32) -> u8 {
        let near = match self.form.near {
            Some(near) => u8::from(!self.is_behind_near(centre(x, y), near)) * NEAR,
            None => 0,
        };
        near | by_lines(row, x, self.tally).unwrap_or_else(|| in_doubt(self, row, [x, y]))
    }

    fn gradient(&self, edge: usize) -> [Sign; 2] {
        gradient(self.form.vertices, edge, self.form.turned)
    }

    fn draws(&mut self, edge: usize, x: u32, y: u32) -> bool {
        let Form { vertices, turned, ties, .. } = self.form;
        let [p, q] = ends(vertices, edge);
        let [x, y] = centre(x, y);
        let side = orient3d_homogeneous([x, y, 1.0], p, q, self.tally) * turned;
        side.is_positive() || side.is_zero() && ties[edge]
    }
}

/// As taught: the columns of the adjugate as edge functions, rounded at every step.
#[derive(Debug)]
struct Taught<R> {
    form: Form,
    functions: [[R; 3]; 3],
    /// The same of 1/w, and the determinant.
    inverse_w: [R; 3],
    determinant: R,
}

impl<R: Real> Taught<R> {
    fn new(form: Form) -> Self {
        let functions = functions(form);
        let [u, v, w] = functions;
        let inverse_w = [0, 1, 2].map(|i| u[i] + v[i] + w[i]);
        let [a, _, _] = form.vertices.map(|vertex| vertex.map(R::from_f32));
        let determinant = a[0] * u[0] + a[1] * u[1] + a[2] * u[2];
        Self { form, functions, inverse_w, determinant }
    }

    fn at([a, b, c]: [R; 3], [x, y]: [f32; 2]) -> R {
        a * R::from_f32(x) + b * R::from_f32(y) + c
    }
}

impl<R: Real> Probe for Taught<R> {
    type Row = ();

    fn row(&mut self, _: u32) {}

    #[inline]
    fn keeps_out(&mut self, (): &(), x: u32, y: u32) -> u8 {
        let inverse_w = Self::at(self.inverse_w, centre(x, y));
        let near = match self.form.near {
            Some(near) if R::from_f32(near) * inverse_w > self.determinant => NEAR,
            _ => 0,
        };
        (0..3).fold(near, |bits, edge| bits | u8::from(!self.draws(edge, x, y)) << edge)
    }

    fn gradient(&self, edge: usize) -> [Sign; 2] {
        gradient(self.form.vertices, edge, self.form.turned)
    }

    #[inline]
    fn draws(&mut self, edge: usize, x: u32, y: u32) -> bool {
        let value = Self::at(self.functions[edge], centre(x, y));
        (value > R::ZERO) | ((value == R::ZERO) & self.form.ties[edge])
    }
}
