//! Edge functions over the bounding box: every centre in the box is tested against three edges.
//!
//! *Source:* Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988. Deviation: the
//! sign of an edge function is exact, so that no vertex needs snapping.

use super::{
    Counts, Settings, Span,
    edge::{Edge, Edges, centre},
    first_centre,
};
use crate::math::{Arithmetic, Real, Tally};
use std::ops::Range;

/// Covers the pixels whose centres lie inside; see [`cover`](super::cover).
///
/// Cost: one to three edge functions for each centre of the bounding box; the skip `row` saves
/// those behind the triangle, about half of the wasted ones.
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
        Arithmetic::Exact | Arithmetic::Fixed8 => walk.run(|x, y| edges.cover(centre(x, y), tally), emit),
        Arithmetic::F32 => walk.run(Taught::<f32>::covers(edges), emit),
        Arithmetic::F64 => walk.run(Taught::<f64>::covers(edges), emit),
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
    fn run(&mut self, mut covers: impl FnMut(u32, u32) -> bool, emit: &mut impl FnMut(Span)) -> Counts {
        let mut counts = Counts::default();
        for y in self.rows.clone() {
            let mut span = Span { y, begin: 0, end: 0 };
            for x in self.columns.clone() {
                counts.tested += 1;
                if covers(x, y) {
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

    fn covers(edges: Edges) -> impl FnMut(u32, u32) -> bool {
        let edges = edges.0.map(Self::new);
        move |x, y| {
            let [x, y] = centre(x, y).map(R::from_f32);
            edges.iter().all(|Self { normal, from, draws_ties }| {
                let value = normal[0] * (x - from[0]) + normal[1] * (y - from[1]);
                value > R::ZERO || value == R::ZERO && *draws_ties
            })
        }
    }
}
