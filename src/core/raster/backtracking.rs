//! Backtracking: from where the row above ended go left until the triangle lies to the right, then fill
//! to the right.
//!
//! *Source:* Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988, section 4. A centre
//! lies left of the triangle if an edge that has the inside to its right keeps it out.

use super::{
    Counts, Span,
    traversal::{Area, Direction, Event, Run, Traversal, probe::Probe, test},
};
use crate::trace::Tracer;

/// The way down the triangle, back to its left side in every row.
///
/// Cost: three edge functions a centre; each row is walked about twice, from its end to its begin
/// and back, but never farther than two centres beside the triangle and the rows next to it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Backtracking;

impl Traversal for Backtracking {
    const NAME: &'static str = "backtracking";

    const LISTING: &'static [&'static str] = &[
        "if the area is 0: draw nothing; stop",
        "x ← column of the highest vertex",
        "for each row y from the highest",
        "  turn left, until the triangle lies to the right",
        "  turn right, until it lies to the left",
        "    at each centre: draw it if E0, E1, E2 let it in",
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
        let last = area.columns.end - 1;
        let mut x = area.start;
        for y in area.from_top() {
            t.emit(|| Event::Row { y: y as u16 });
            let row = probe.row(y);
            t.emit(|| Event::Turn { x: x as u16, to: Direction::Left });
            while x > area.columns.start {
                if test((probe, &row), [x, y], &mut counts, t) & left_edges != 0 {
                    break;
                }
                x -= 1;
            }
            t.emit(|| Event::Turn { x: x as u16, to: Direction::Right });
            let mut run = Run::default();
            loop {
                let keeps_out = test((probe, &row), [x, y], &mut counts, t);
                if keeps_out == 0 {
                    run.add(x, x + 1);
                }
                if keeps_out & right_edges != 0 || x == last {
                    break;
                }
                x += 1;
            }
            run.emit(y, &mut counts, emit);
        }
        counts
    }
}
