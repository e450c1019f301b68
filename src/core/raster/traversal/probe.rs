//! The three edge functions at a centre, in any arithmetic.
//!
//! Exact: along a row an edge function is one line in binary64 with one error bound; where that leaves a
//! doubt, the exact predicate decides.

use crate::{
    math::{Arithmetic, Real, Sign, Tally, edge_value, predicates::FOUR_ROUNDINGS},
    raster::{
        Settings,
        edge::{Edge, Edges, centre},
    },
};

/// Asks the edges about centres.
pub trait Probe {
    /// What the centres of a row have in common.
    type Row;

    /// Prepares a row.
    fn row(&mut self, y: u32) -> Self::Row;

    /// One bit for each edge that keeps a centre out, the first lowest.
    fn keeps_out(&mut self, row: &Self::Row, x: u32, y: u32) -> u8;

    /// How an edge function grows with x and with y.
    fn gradient(&self, edge: usize) -> [Sign; 2];

    /// Whether one edge draws a centre.
    fn draws(&mut self, edge: usize, x: u32, y: u32) -> bool;

    /// The edges that have the inside to their right: whom they keep out lies left of the triangle.
    fn left_edges(&self) -> u8 {
        bits([0, 1, 2].map(|edge| self.gradient(edge)[0].is_positive()))
    }

    /// The edges that have the inside to their left: whom they keep out lies right of the triangle.
    fn right_edges(&self) -> u8 {
        bits([0, 1, 2].map(|edge| self.gradient(edge)[0].is_negative()))
    }
}

/// The gradient of an edge in the plane is its inward normal.
fn gradient(edge: &Edge) -> [Sign; 2] {
    let [[ax, ay], [bx, by]] = edge.ends;
    let order = |a: f32, b: f32| a.partial_cmp(&b).map_or(Sign::Zero, Sign::from);
    [order(ay, by), order(bx, ax)]
}

#[inline]
fn bits([a, b, c]: [bool; 3]) -> u8 {
    u8::from(a) | u8::from(b) << 1 | u8::from(c) << 2
}

/// Exact signs.
#[derive(Debug)]
pub(super) struct Exact<'a> {
    edges: [Edge; 3],
    lines: [Line; 3],
    tally: &'a mut Tally,
}

impl<'a> Exact<'a> {
    /// For the columns `0..width`.
    pub(super) fn new(edges: Edges, width: u32, tally: &'a mut Tally) -> Self {
        Self { edges: edges.0, lines: edges.0.map(|edge| Line::new(edge, width)), tally }
    }
}

/// The edge function of an edge, `E(x, y) = dx y - dy x + c`, in binary64.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    dx: f64,
    dy: f64,
    /// `ax by - ay bx`: each product of two f32 is exact.
    c: f64,
    /// The largest magnitude that `dy x` has in the image's columns.
    across: f64,
}

/// A [`Line`] in one row: `start - dy x`, right within `bound` at every centre of the row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RowLine {
    dy: f64,
    start: f64,
    bound: f64,
}

impl Line {
    fn new(edge: Edge, width: u32) -> Self {
        let [[ax, ay], [bx, by]] = edge.ends.map(|end| end.map(f64::from));
        let dy = by - ay;
        Self { dx: bx - ax, dy, c: ax * by - ay * bx, across: dy.abs() * f64::from(width) }
    }

    /// `a x + b y + c` with coefficients that were rounded at most once.
    pub(crate) fn of([a, b]: [f64; 2], c: f64, width: u32) -> Self {
        Self { dx: b, dy: -a, c, across: a.abs() * f64::from(width) }
    }

    /// The term `dx y` goes through four roundings on its way into `E` (the difference, the product, two
    /// sums), `c` and `dy x` through three: the condition of [`FOUR_ROUNDINGS`]. Differences of f32 are
    /// multiples of 2^-149 and centres of 1/2, so nothing underflows.
    #[inline]
    pub(crate) fn row(self, y: u32) -> RowLine {
        let along = self.dx * f64::from(centre(0, y)[1]);
        let bound = FOUR_ROUNDINGS * (along.abs() + self.c.abs() + self.across);
        RowLine { dy: self.dy, start: along + self.c, bound }
    }
}

impl RowLine {
    /// Whether a centre is inside, if the bound leaves no doubt.
    #[inline]
    pub(crate) fn sign(&self, x: u32) -> Option<bool> {
        let value = self.start - self.dy * f64::from(centre(x, 0)[0]);
        (value.abs() > self.bound).then_some(value > 0.0)
    }
}

impl Probe for Exact<'_> {
    type Row = [RowLine; 3];

    #[inline]
    fn row(&mut self, y: u32) -> [RowLine; 3] {
        self.lines.map(|line| line.row(y))
    }

    #[inline]
    fn keeps_out(&mut self, row: &[RowLine; 3], x: u32, y: u32) -> u8 {
        bits([0, 1, 2].map(|i| match row[i].sign(x) {
            Some(inside) => {
                self.tally.calls += 1;
                !inside
            }
            None => !self.draws(i, x, y),
        }))
    }

    fn gradient(&self, edge: usize) -> [Sign; 2] {
        gradient(&self.edges[edge])
    }

    #[inline]
    fn draws(&mut self, edge: usize, x: u32, y: u32) -> bool {
        let edge = &self.edges[edge];
        edge.draws(edge.side(centre(x, y), self.tally))
    }
}

/// An edge function as taught: n . (p - v) with the inward normal n, rounded at every step.
#[derive(Debug)]
pub(super) struct Taught<R> {
    edges: [Edge; 3],
    functions: [Function<R>; 3],
    /// How far from zero a value still counts as zero, by mistake; else 0.
    epsilon: f64,
}

#[derive(Clone, Copy, Debug)]
struct Function<R> {
    normal: [R; 2],
    from: [R; 2],
}

impl<R: Real> Taught<R> {
    pub(super) fn new(edges: Edges, epsilon: Option<f64>) -> Self {
        let function = |edge: Edge| {
            let [[ax, ay], [bx, by]] = edge.ends.map(|end| end.map(R::from_f32));
            Function { normal: [ay - by, bx - ax], from: [ax, ay] }
        };
        Self { edges: edges.0, functions: edges.0.map(function), epsilon: epsilon.unwrap_or_default() }
    }

    /// An edge function at a centre.
    #[inline]
    fn value(&self, edge: usize, x: u32, y: u32) -> R {
        let Function { normal, from } = self.functions[edge];
        let [x, y] = centre(x, y).map(R::from_f32);
        normal[0] * (x - from[0]) + normal[1] * (y - from[1])
    }

    /// Whether a value means that the centre lies on the edge.
    #[inline]
    fn is_tie(&self, value: R) -> bool {
        value == R::ZERO || value.to_f64().abs() < self.epsilon
    }
}

impl<R: Real> Probe for Taught<R> {
    type Row = ();

    fn row(&mut self, _: u32) {}

    fn keeps_out(&mut self, (): &(), x: u32, y: u32) -> u8 {
        bits([0, 1, 2].map(|i| !self.draws(i, x, y)))
    }

    fn gradient(&self, edge: usize) -> [Sign; 2] {
        gradient(&self.edges[edge])
    }

    fn draws(&mut self, edge: usize, x: u32, y: u32) -> bool {
        let value = self.value(edge, x, y);
        if self.is_tie(value) { self.edges[edge].draws_ties } else { value > R::ZERO }
    }
}

/// What one edge says of a centre, as computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Says {
    /// The edge function, rounded to binary64 if it was computed exactly.
    pub(crate) value: f64,
    /// Whether it counts as zero: the tie rule decides.
    pub(crate) tie: bool,
    /// Whether the edge lets the centre in.
    pub(crate) draws: bool,
}

/// What each edge says of a centre in the arithmetic of the settings.
pub(crate) fn says(edges: &Edges, settings: &Settings, [x, y]: [u32; 2]) -> [Says; 3] {
    fn taught<R: Real>(edges: &Edges, settings: &Settings, [x, y]: [u32; 2]) -> [Says; 3] {
        let mut probe = Taught::<R>::new(*edges, settings.epsilon());
        [0, 1, 2].map(|edge| {
            let value = probe.value(edge, x, y);
            Says { value: value.to_f64(), tie: probe.is_tie(value), draws: probe.draws(edge, x, y) }
        })
    }
    match settings.arithmetic {
        Arithmetic::F32 => taught::<f32>(edges, settings, [x, y]),
        arithmetic if arithmetic == Arithmetic::F64 || settings.epsilon().is_some() => {
            taught::<f64>(edges, settings, [x, y])
        }
        _ => exactly(edges, [x, y]),
    }
}

/// What each edge says of a centre, without a rounding but the value's.
pub(crate) fn exactly(edges: &Edges, [x, y]: [u32; 2]) -> [Says; 3] {
    let at = centre(x, y);
    edges.0.map(|edge| {
        let sign = edge.side(at, &mut Tally::default());
        let value = edge_value(edge.ends[0], edge.ends[1], at).value;
        Says { value: if sign.is_zero() { 0.0 } else { value }, tie: sign.is_zero(), draws: edge.draws(sign) }
    })
}
