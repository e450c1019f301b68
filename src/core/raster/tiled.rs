//! Tiles: squares of 64, 16 and 4 pixels are drawn or left out whole; only where an edge passes through
//! a square of 4 each centre is tested.
//!
//! *Source:* Greene, Hierarchical Polygon Tiling with Coverage Masks, SIGGRAPH 1996; McCormack and
//! McNamara, Tiled Polygon Traversal Using Half-Plane Edge Functions, 2000. Deviation: a tile is decided
//! at the two centres of it that lie nearest to and farthest from an edge, by exact signs.

use super::{
    Counts, Span,
    traversal::{Area, Event, Run, Traversal, Verdict, probe::Probe, test},
};
use crate::trace::Tracer;

/// Pixels a side of a tile, from coarse to fine.
pub const SIZES: [u32; 3] = [64, 16, 4];

/// Rows that one band of the coarsest tiles has.
const BAND: usize = SIZES[0] as usize;

/// The way over nested tiles.
///
/// Cost: at most six signs a tile, however large it is; three edge functions for each centre of the
/// finest tiles that an edge passes through.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tiled;

impl Traversal for Tiled {
    const NAME: &'static str = "tiled";

    const LISTING: &'static [&'static str] = &[
        "if the area is 0: draw nothing; stop",
        "box ← columns and rows of the centres around V0, V1, V2",
        "for each row of tiles of 64 × 64 in the box",
        "  for each tile: if all of it is outside E0, E1 or E2: leave it out",
        "    else if all of it is inside E0, E1 and E2: draw it whole",
        "    else split it into tiles of a quarter of its side",
        "    a tile of 4 × 4 that is split: draw each centre that E0, E1, E2 let in",
        "no tile is left: stop",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::ZeroArea => 0,
            Event::Box { .. } => 1,
            Event::Row { .. } | Event::Turn { .. } | Event::Skip { .. } => 2,
            Event::Tile { verdict: Verdict::Outside { .. }, .. } => 3,
            Event::Tile { verdict: Verdict::Inside, .. } => 4,
            Event::Tile { verdict: Verdict::Split, .. } => 5,
            Event::Test { .. } => 6,
            Event::Done => 7,
        }
    }

    fn walk<P: Probe, T: Tracer<Event>>(
        area: &Area,
        probe: &mut P,
        t: &mut T,
        emit: &mut impl FnMut(Span),
    ) -> Counts {
        let mut counts = Counts::default();
        let first = area.rows.start / SIZES[0];
        let last = (area.rows.end - 1) / SIZES[0];
        for band in first..=last {
            let top = band * SIZES[0];
            t.emit(|| Event::Row { y: top.max(area.rows.start) as u16 });
            let mut band = Band { top, runs: [Run::default(); BAND] };
            for column in area.columns.start / SIZES[0]..=(area.columns.end - 1) / SIZES[0] {
                band.tile([column * SIZES[0], top], 0, area, probe, &mut counts, t);
            }
            for (y, run) in (top..).zip(band.runs) {
                run.emit(y, &mut counts, emit);
            }
        }
        counts
    }
}

/// One row of the coarsest tiles, and what was found in each row of pixels.
struct Band {
    top: u32,
    runs: [Run; BAND],
}

impl Band {
    /// One tile of `SIZES[level]`, as far as it lies in the area.
    fn tile<P: Probe, T: Tracer<Event>>(
        &mut self,
        [left, top]: [u32; 2],
        level: usize,
        area: &Area,
        probe: &mut P,
        counts: &mut Counts,
        t: &mut T,
    ) {
        let size = SIZES[level];
        let columns = left.max(area.columns.start)..(left + size).min(area.columns.end);
        let rows = top.max(area.rows.start)..(top + size).min(area.rows.end);
        if columns.is_empty() || rows.is_empty() {
            return;
        }
        let verdict = judge([columns.start, columns.end - 1], [rows.start, rows.end - 1], probe);
        t.emit(|| Event::Tile { x: left as u16, y: top as u16, size: size as u8, verdict });
        match verdict {
            Verdict::Outside { .. } => {}
            Verdict::Inside => {
                for y in rows {
                    self.runs[(y - self.top) as usize].add(columns.start, columns.end);
                }
            }
            Verdict::Split => match SIZES.get(level + 1) {
                Some(&part) => {
                    for y in (top..top + size).step_by(part as usize) {
                        for x in (left..left + size).step_by(part as usize) {
                            self.tile([x, y], level + 1, area, probe, counts, t);
                        }
                    }
                }
                None => {
                    for y in rows {
                        let row = probe.row(y);
                        for x in columns.clone() {
                            if test((probe, &row), [x, y], counts, t) == 0 {
                                self.runs[(y - self.top) as usize].add(x, x + 1);
                            }
                        }
                    }
                }
            },
        }
    }
}

/// What is known of the centres from the first to the last column and row.
///
/// An edge function is largest at one corner of the tile and smallest at the opposite one: an edge that
/// keeps out the first keeps out all, an edge that lets in the second lets in all.
#[inline]
fn judge<P: Probe>(columns: [u32; 2], rows: [u32; 2], probe: &mut P) -> Verdict {
    let mut inside = true;
    for edge in 0..3 {
        let [x, y] = probe.gradient(edge).map(|growth| usize::from(growth.is_positive()));
        if !probe.draws(edge, columns[x], rows[y]) {
            return Verdict::Outside { edge: edge as u8 };
        }
        inside = inside && probe.draws(edge, columns[1 - x], rows[1 - y]);
    }
    if inside { Verdict::Inside } else { Verdict::Split }
}
