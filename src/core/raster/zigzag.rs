//! Zigzag: from where the row above ended fill to the left, come back, and fill to the right.
//!
//! *Source:* Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988, section 4. Deviation
//! from how it is often told: the way to the right ends where the triangle lies to the left, not at the
//! first centre outside, since the row may begin left of the triangle.

use super::{
    Counts, Span,
    traversal::{Area, Direction, Event, Run, Traversal, probe::Probe, test},
};
use crate::trace::Tracer;

/// The way down the triangle that fills to both sides of where it enters a row.
///
/// Cost: three edge functions a centre; no centre of a row is looked at twice.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Zigzag;

impl Traversal for Zigzag {
    const NAME: &'static str = "zigzag";

    const LISTING: &'static [&'static str] = &[
        "if the area is 0: draw nothing; stop",
        "x ← column of the highest vertex",
        "for each row y from the highest: start ← x",
        "  turn left",
        "  turn right, behind start",
        "    go on and draw what E0, E1, E2 let in, until the triangle lies behind",
        "no row is left: stop",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::ZeroArea => 0,
            Event::Box { .. } => 1,
            Event::Row { .. } | Event::Skip { .. } => 2,
            Event::Turn { to: Direction::Left, .. } => 3,
            Event::Turn { to: Direction::Right, .. } => 4,
            Event::Test { .. } | Event::Tile { .. } => 5,
            Event::Done => 6,
        }
    }

    fn walk<P: Probe, T: Tracer<Event>>(
        area: &Area,
        probe: &mut P,
        t: &mut T,
        emit: &mut impl FnMut(Span),
    ) -> Counts {
        let mut counts = Counts::default();
        let (left_edges, right_edges) = (probe.left_edges(), probe.right_edges());
        let mut start = area.start;
        for y in area.from_top() {
            t.emit(|| Event::Row { y: y as u16 });
            let row = probe.row(y);
            let mut run = Run::default();
            t.emit(|| Event::Turn { x: start as u16, to: Direction::Left });
            // Whether the triangle already ends at the start.
            let mut behind = false;
            for x in (area.columns.start..=start).rev() {
                let keeps_out = test((probe, &row), [x, y], &mut counts, t);
                if keeps_out == 0 {
                    run.add(x, x + 1);
                }
                behind |= x == start && keeps_out & right_edges != 0;
                if keeps_out & left_edges != 0 {
                    break;
                }
            }
            let from = start + 1;
            if !behind && from < area.columns.end {
                t.emit(|| Event::Turn { x: from as u16, to: Direction::Right });
                for x in from..area.columns.end {
                    let keeps_out = test((probe, &row), [x, y], &mut counts, t);
                    if keeps_out == 0 {
                        run.add(x, x + 1);
                    }
                    start = x;
                    if keeps_out & right_edges != 0 {
                        break;
                    }
                }
            }
            if !run.is_empty() {
                start = run.middle();
            }
            run.emit(y, &mut counts, emit);
        }
        counts
    }
}
