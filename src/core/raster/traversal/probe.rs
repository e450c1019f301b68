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
        Self { edges: edges.0, lines: edges.0.map(|edge| Line::of_edge(edge, width)), tally }
    }
}

/// An edge function `E(x, y) = a x + b y + c` in binary64, each coefficient rounded once.
#[derive(Clone, Copy, Debug)]
pub(in crate::raster) struct Line {
    a: f64,
    b: f64,
    c: f64,
    /// The largest magnitude that `a x` has in the image's columns.
    across: f64,
}

/// A [`Line`] in one row: `start + a x`, right within `bound` at every centre of the row.
#[derive(Clone, Copy, Debug)]
pub(in crate::raster) struct RowLine {
    a: f64,
    start: f64,
    bound: f64,
}

impl Line {
    /// Of an edge in the plane.
    fn of_edge(edge: Edge, width: u32) -> Self {
        let [[ax, ay], [bx, by]] = edge.ends.map(|end| end.map(f64::from));
        Self::new([ay - by, bx - ax, ax * by - ay * bx], width)
    }

    /// From the coefficients, which are f32, differences of two, or differences of two products of two.
    pub(in crate::raster) fn new([a, b, c]: [f64; 3], width: u32) -> Self {
        Self { a, b, c, across: a.abs() * f64::from(width) }
    }

    /// The term `b y` goes through four roundings on its way into `E` (the coefficient, the product, two
    /// sums), `c` and `a x` through three: the condition of [`FOUR_ROUNDINGS`]. Products of two f32 are
    /// multiples of 2^-298 and centres of 1/2, so nothing underflows.
    #[inline]
    pub(in crate::raster) fn row(self, y: u32) -> RowLine {
        let along = self.b * f64::from(centre(0, y)[1]);
        let bound = FOUR_ROUNDINGS * (along.abs() + self.c.abs() + self.across);
        RowLine { a: self.a, start: along + self.c, bound }
    }
}

impl RowLine {
    /// The edge function at a centre; its sign is certain if it is beyond the bound.
    #[inline]
    fn at(&self, x: u32) -> f64 {
        self.start + self.a * f64::from(centre(x, 0)[0])
    }

    /// Whether the sign of that value is certain.
    #[inline]
    fn decides(&self, value: f64) -> bool {
        value.abs() > self.bound
    }
}

/// One bit for each edge that keeps a centre out, by their lines; `None` if one leaves a doubt.
#[inline]
pub(in crate::raster) fn by_lines(lines: &[RowLine; 3], x: u32, tally: &mut Tally) -> Option<u8> {
    let [a, b, c] = lines.map(|line| line.at(x));
    let certain = lines[0].decides(a) & lines[1].decides(b) & lines[2].decides(c);
    certain.then(|| {
        tally.calls += 3;
        bits([a < 0.0, b < 0.0, c < 0.0])
    })
}

/// The same where a line leaves a doubt: by the exact signs of those that do, which count themselves.
#[cold]
#[inline(never)]
pub(in crate::raster) fn in_doubt<P: Probe<Row = [RowLine; 3]>>(
    probe: &mut P,
    lines: &[RowLine; 3],
    [x, y]: [u32; 2],
) -> u8 {
    bits([0, 1, 2].map(|edge| {
        let value = lines[edge].at(x);
        if lines[edge].decides(value) { value < 0.0 } else { !probe.draws(edge, x, y) }
    }))
}

impl Probe for Exact<'_> {
    type Row = [RowLine; 3];

    #[inline]
    fn row(&mut self, y: u32) -> [RowLine; 3] {
        self.lines.map(|line| line.row(y))
    }

    #[inline]
    fn keeps_out(&mut self, row: &[RowLine; 3], x: u32, y: u32) -> u8 {
        by_lines(row, x, self.tally).unwrap_or_else(|| in_doubt(self, row, [x, y]))
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
        (value == R::ZERO) | (value.to_f64().abs() < self.epsilon)
    }
}

impl<R: Real> Probe for Taught<R> {
    type Row = ();

    fn row(&mut self, _: u32) {}

    #[inline]
    fn keeps_out(&mut self, (): &(), x: u32, y: u32) -> u8 {
        bits([0, 1, 2].map(|i| !self.draws(i, x, y)))
    }

    fn gradient(&self, edge: usize) -> [Sign; 2] {
        gradient(&self.edges[edge])
    }

    #[inline]
    fn draws(&mut self, edge: usize, x: u32, y: u32) -> bool {
        let value = self.value(edge, x, y);
        let tie = self.is_tie(value);
        (!tie & (value > R::ZERO)) | (tie & self.edges[edge].draws_ties)
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
