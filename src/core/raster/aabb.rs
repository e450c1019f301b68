//! Edge functions over the bounding box: every centre in the box is tested against three edges.
//!
//! *Source:* Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988. Deviation: with the
//! skip `row` a row is left after its last pixel.

use super::{
    Counts, Settings, Span,
    traversal::{self, Area, Event, Run, Traversal, probe::Probe, test},
};
use crate::{
    math::Tally,
    replay::{Budget, Player},
    trace::Tracer,
};

/// The way over the whole bounding box, row by row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Aabb;

/// Covers the pixels whose centres lie inside; see [`cover`](super::cover).
///
/// Cost: three edge functions for each centre of the bounding box, about 1 ns each; the skip
/// `row` saves those behind the triangle, about half of the wasted ones.
pub fn fill(
    vertices: [[f32; 2]; 3],
    settings: &Settings,
    tally: &mut Tally,
    emit: &mut impl FnMut(Span),
) -> Counts {
    traversal::fill::<Aabb>(vertices, settings, tally, emit)
}

/// [`fill`] as a run that can be scrubbed.
pub fn play(
    vertices: [[f32; 2]; 3],
    settings: Settings,
    budget: Budget,
) -> Player<traversal::Snapshot<Aabb>> {
    traversal::play(vertices, settings, budget)
}

impl Traversal for Aabb {
    const NAME: &'static str = "aabb";

    const LISTING: &'static [&'static str] = &[
        "if the area is 0: draw nothing; stop",
        "box ← columns and rows of the centres around V0, V1, V2",
        "for each row y of the box",
        "  for each column x: draw it if E0, E1, E2 let it in",
        "  behind the last pixel: skip the rest of the row",
        "no row is left: stop",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::ZeroArea => 0,
            Event::Box { .. } => 1,
            Event::Row { .. } | Event::Turn { .. } => 2,
            Event::Test { .. } | Event::Tile { .. } => 3,
            Event::Skip { .. } => 4,
            Event::Done => 5,
        }
    }

    fn walk<P: Probe, T: Tracer<Event>>(
        area: &Area,
        probe: &mut P,
        t: &mut T,
        emit: &mut impl FnMut(Span),
    ) -> Counts {
        let mut counts = Counts::default();
        for y in area.from_top() {
            t.emit(|| Event::Row { y: y as u16 });
            let row = probe.row(y);
            let mut run = Run::default();
            for x in area.columns.clone() {
                if test((probe, &row), [x, y], &mut counts, t) == 0 {
                    run.add(x, x + 1);
                } else if area.skip_row && !run.is_empty() {
                    let centres = area.columns.end - x - 1;
                    counts.skipped += u64::from(centres);
                    if centres > 0 {
                        t.emit(|| Event::Skip { centres: centres as u16 });
                    }
                    break;
                }
            }
            run.emit(y, &mut counts, emit);
        }
        counts
    }
}
