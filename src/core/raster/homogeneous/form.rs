//! The edge functions of a homogeneous triangle at a centre, exact and as taught.

use super::{Adjugate, Vertex};
use crate::{
    math::{Approx, Dyadic, Real, Sign, Tally, orient3d_homogeneous},
    raster::{
        FillRule, Settings, YAxis,
        edge::centre,
        traversal::probe::{Line, Probe, RowLine, Says, by_lines, in_doubt},
    },
};

/// The near plane's place among the edges.
pub(super) const NEAR: usize = 3;

/// What both forms need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Form<R> {
    pub(super) vertices: [Vertex; 3],
    pub(super) near: Option<f32>,
    pub(super) turned: Sign,
    pub(super) ties: [bool; 3],
    pub(super) adjugate: Adjugate<R>,
    /// How far from zero a value still counts as zero, by mistake; else 0.
    epsilon: f64,
}

impl<R: Real> Form<R> {
    /// `adjugate` is turned already, so that the inside is positive.
    pub(super) fn new(
        (vertices, near): ([Vertex; 3], Option<f32>),
        turned: Sign,
        adjugate: Adjugate<R>,
        settings: &Settings,
    ) -> Self {
        let ties = [0, 1, 2].map(|edge| draws_ties(gradient(vertices, edge, turned), settings));
        Self { vertices, near, turned, ties, adjugate, epsilon: settings.epsilon().unwrap_or_default() }
    }

    /// The near plane as a fourth edge function: it is not negative where 1/w is at most 1/near.
    pub(super) fn near_edge(&self) -> Option<[R; 3]> {
        self.near.map(|near| self.adjugate.near_edge(R::from_f32(near)))
    }

    fn is_tie(&self, value: R) -> bool {
        value == R::ZERO || value.to_f64().abs() < self.epsilon
    }
}

/// The edge opposite to a vertex, as the other two in order.
pub(super) fn ends(vertices: [Vertex; 3], edge: usize) -> [Vertex; 2] {
    [vertices[(edge + 1) % 3], vertices[(edge + 2) % 3]]
}

/// How an edge function grows with x and with y: signs of two columns of the adjugate. Exact, since
/// a product of two f32 is.
pub(super) fn gradient(vertices: [Vertex; 3], edge: usize, turned: Sign) -> [Sign; 2] {
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

/// Exact signs: the edge functions in binary64 along a row with one bound of their errors, and the exact
/// determinant where that leaves a doubt.
#[derive(Debug)]
pub(super) struct Exact<'a> {
    form: Form<f64>,
    lines: [Line; 3],
    tally: &'a mut Tally,
}

impl<'a> Exact<'a> {
    /// For the columns `0..width`.
    pub(super) fn new(form: Form<f64>, width: u32, tally: &'a mut Tally) -> Self {
        // Each coefficient is the difference of two exact products, rounded once.
        let lines = form.adjugate.edges.map(|coefficients| Line::new(coefficients, width));
        Self { form, lines, tally }
    }

    /// The sign of an edge function, inside positive.
    pub(super) fn side(&mut self, edge: usize, x: u32, y: u32) -> Sign {
        let [p, q] = ends(self.form.vertices, edge);
        let [x, y] = centre(x, y);
        orient3d_homogeneous([x, y, 1.0], p, q, self.tally) * self.form.turned
    }

    /// The sign of the near plane's edge function, `det - near (E0 + E1 + E2)`.
    pub(super) fn near_side(&mut self, near: f32, x: u32, y: u32) -> Sign {
        let Form { vertices, turned, .. } = self.form;
        let at = centre(x, y);
        self.tally.calls += 1;
        let filtered = near_value(vertices.map(|v| v.map(Approx::from)), at.map(Approx::from), near.into());
        let sign = filtered.sign().unwrap_or_else(|| {
            self.tally.exact += 1;
            near_value(vertices.map(|v| v.map(Dyadic::from)), at.map(Dyadic::from), near.into()).sign()
        });
        sign * turned
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
        let near = self.form.near.is_some_and(|near| self.near_side(near, x, y).is_negative());
        u8::from(near) << NEAR | by_lines(row, x, self.tally).unwrap_or_else(|| in_doubt(self, row, [x, y]))
    }

    fn gradient(&self, edge: usize) -> [Sign; 2] {
        gradient(self.form.vertices, edge, self.form.turned)
    }

    fn draws(&mut self, edge: usize, x: u32, y: u32) -> bool {
        let side = self.side(edge, x, y);
        side.is_positive() || side.is_zero() && self.form.ties[edge]
    }
}

/// As taught: the columns of the adjugate as edge functions, rounded at every step.
#[derive(Debug)]
pub(super) struct Taught<R>(pub(super) Form<R>);

impl<R: Real> Probe for Taught<R> {
    type Row = ();

    fn row(&mut self, _: u32) {}

    fn keeps_out(&mut self, (): &(), x: u32, y: u32) -> u8 {
        let near = self.0.near_edge().is_some_and(|edge| at(edge, x, y) < R::ZERO);
        (0..3).fold(u8::from(near) << NEAR, |bits, edge| bits | u8::from(!self.draws(edge, x, y)) << edge)
    }

    fn gradient(&self, edge: usize) -> [Sign; 2] {
        gradient(self.0.vertices, edge, self.0.turned)
    }

    fn draws(&mut self, edge: usize, x: u32, y: u32) -> bool {
        let value = at(self.0.adjugate.edges[edge], x, y);
        if self.0.is_tie(value) { self.0.ties[edge] } else { value > R::ZERO }
    }
}

/// `a x + b y + c` at a centre.
pub(super) fn at<R: Real>([a, b, c]: [R; 3], x: u32, y: u32) -> R {
    let [x, y] = centre(x, y).map(R::from_f32);
    a * x + b * y + c
}

/// What each edge says of a centre, the near plane last if there is one.
pub(super) fn says<R: Real>(form: &Form<R>, exact: bool, [x, y]: [u32; 2]) -> Vec<Says> {
    let mut tally = Tally::default();
    let wide = form.adjugate.edges.map(|edge| edge.map(R::to_f64));
    let Form { vertices, near, turned, ties, adjugate: Adjugate { determinant, .. }, epsilon } = *form;
    let adjugate = Adjugate { edges: wide, determinant: determinant.to_f64() };
    let mut signs = Exact::new(Form { vertices, near, turned, ties, adjugate, epsilon }, 1, &mut tally);
    let edge = |i: usize| {
        let value = at(form.adjugate.edges[i], x, y);
        if exact {
            let side = signs.side(i, x, y);
            let draws = side.is_positive() || side.is_zero() && ties[i];
            Says { value: if side.is_zero() { 0.0 } else { value.to_f64() }, tie: side.is_zero(), draws }
        } else {
            let tie = form.is_tie(value);
            Says { value: value.to_f64(), tie, draws: if tie { ties[i] } else { value > R::ZERO } }
        }
    };
    let mut all: Vec<Says> = (0..3).map(edge).collect();
    if let (Some(near), Some(edge)) = (near, form.near_edge()) {
        let value = at(edge, x, y);
        let side = if exact { signs.near_side(near, x, y) } else { Sign::of(value.to_f64()) };
        let value = if side.is_zero() { 0.0 } else { value.to_f64() };
        all.push(Says { value, tie: side.is_zero(), draws: !side.is_negative() });
    }
    all
}
