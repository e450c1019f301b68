//! Edge functions over the bounding box: every centre in the box is tested against three edges.
//!
//! *Source:* Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988. Deviation: the
//! sign of an edge function is exact, so that no vertex needs snapping: along a row it is one line in
//! binary64 with one error bound, and where that leaves a doubt the exact predicate decides.

use super::{
    Counts, Settings, Span,
    edge::{Edge, Edges, centre},
    first_centre,
};
use crate::math::{Arithmetic, Real, Tally, predicates::FOUR_ROUNDINGS};
use std::ops::Range;

/// Covers the pixels whose centres lie inside; see [`cover`](super::cover).
///
/// Cost: one to three edge functions for each centre of the bounding box, about 1 ns each; the skip
/// `row` saves those behind the triangle, about half of the wasted ones.
pub fn fill(
    vertices: [[f32; 2]; 3],
    settings: &Settings,
    tally: &mut Tally,
    emit: &mut impl FnMut(Span),
) -> Counts {
    let vertices = settings.vertices(vertices);
    let Some(edges) = Edges::new(vertices, settings, tally) else { return Counts::default() };
    let [columns, rows] = [0, 1].map(|axis| {
        let [a, b, c] = vertices.map(|vertex| f64::from(vertex[axis]));
        let limit = settings.size[axis];
        first_centre(a.min(b).min(c), false, limit)..first_centre(a.max(b).max(c), true, limit)
    });
    let mut walk = Walk { columns, rows, skip_row: settings.skip_row };
    match settings.arithmetic {
        Arithmetic::Exact | Arithmetic::Fixed8 => {
            let lines = edges.0.map(|edge| Line::new(edge, walk.columns.end));
            walk.run(&mut |y| lines.map(|line| line.row(y)), &mut |row, x, y| covers(row, x, y, tally), emit)
        }
        Arithmetic::F32 => walk.run(&mut |_| (), &mut Taught::<f32>::covers(edges), emit),
        Arithmetic::F64 => walk.run(&mut |_| (), &mut Taught::<f64>::covers(edges), emit),
    }
}

/// The centres of the bounding box.
struct Walk {
    columns: Range<u32>,
    rows: Range<u32>,
    skip_row: bool,
}

impl Walk {
    /// Row by row; since a triangle is convex, its pixels in a row are one span.
    /// `start` is asked once for each row, `covers` with its answer for each centre.
    fn run<R>(
        &mut self,
        start: &mut impl FnMut(u32) -> R,
        covers: &mut impl FnMut(&R, u32, u32) -> bool,
        emit: &mut impl FnMut(Span),
    ) -> Counts {
        let mut counts = Counts::default();
        for y in self.rows.clone() {
            let row = start(y);
            let mut span = Span { y, begin: 0, end: 0 };
            for x in self.columns.clone() {
                counts.tested += 1;
                if covers(&row, x, y) {
                    if span.is_empty() {
                        span.begin = x;
                    }
                    span.end = x + 1;
                } else if self.skip_row && !span.is_empty() {
                    counts.skipped += u64::from(self.columns.end - x - 1);
                    break;
                }
            }
            if !span.is_empty() {
                counts.covered += u64::from(span.len());
                emit(span);
            }
        }
        counts
    }
}

/// The edge function of an edge, `E(x, y) = dx y - dy x + c`, in binary64.
#[derive(Clone, Copy)]
struct Line {
    edge: Edge,
    dx: f64,
    dy: f64,
    /// `ax by - ay bx`: each product of two f32 is exact.
    c: f64,
    /// The largest magnitude that `dy x` has in the image's columns.
    across: f64,
}

/// A [`Line`] in one row: `start - dy x`, right within `bound` at every centre of the row.
#[derive(Clone, Copy)]
struct RowLine {
    line: Line,
    start: f64,
    bound: f64,
}

impl Line {
    fn new(edge: Edge, width: u32) -> Self {
        let [[ax, ay], [bx, by]] = edge.ends.map(|end| end.map(f64::from));
        let dy = by - ay;
        Self { edge, dx: bx - ax, dy, c: ax * by - ay * bx, across: dy.abs() * f64::from(width) }
    }

    /// The term `dx y` goes through four roundings on its way into `E` (the difference, the product, two
    /// sums), `c` and `dy x` through three: the condition of [`FOUR_ROUNDINGS`]. Differences of f32 are
    /// multiples of 2^-149 and centres of 1/2, so nothing underflows.
    #[inline]
    fn row(self, y: u32) -> RowLine {
        let along = self.dx * f64::from(centre(0, y)[1]);
        let bound = FOUR_ROUNDINGS * (along.abs() + self.c.abs() + self.across);
        RowLine { line: self, start: along + self.c, bound }
    }
}

/// Whether a centre is covered; only where the bound leaves a doubt is the exact sign asked for.
#[inline]
fn covers(row: &[RowLine; 3], x: u32, y: u32, tally: &mut Tally) -> bool {
    let point = centre(x, y);
    let across = f64::from(point[0]);
    row.iter().all(|RowLine { line, start, bound }| {
        let value = start - line.dy * across;
        if value.abs() > *bound {
            tally.calls += 1;
            value > 0.0
        } else {
            line.edge.draws(line.edge.side(point, tally))
        }
    })
}

/// An edge function as taught: n · (p − v) with the inward normal n, rounded at every step.
struct Taught<R> {
    normal: [R; 2],
    from: [R; 2],
    draws_ties: bool,
}

impl<R: Real> Taught<R> {
    fn new(edge: Edge) -> Self {
        let [[ax, ay], [bx, by]] = edge.ends.map(|end| end.map(R::from_f32));
        Self { normal: [ay - by, bx - ax], from: [ax, ay], draws_ties: edge.draws_ties }
    }

    fn covers(edges: Edges) -> impl FnMut(&(), u32, u32) -> bool {
        let edges = edges.0.map(Self::new);
        move |(), x, y| {
            let [x, y] = centre(x, y).map(R::from_f32);
            edges.iter().all(|Self { normal, from, draws_ties }| {
                let value = normal[0] * (x - from[0]) + normal[1] * (y - from[1]);
                value > R::ZERO || value == R::ZERO && *draws_ties
            })
        }
    }
}
