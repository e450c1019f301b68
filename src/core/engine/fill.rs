//! Triangles into a tile: band by band of rows, block by block of columns, and the pixels of a row at once.
//!
//! *Source:* Greene, Kass, Miller, Hierarchical Z-Buffer Visibility, SIGGRAPH 1993; Giesen, Optimizing Software
//! Occlusion Culling, 2013. Deviation: a depth is tested as an interval around the exact one.

use super::{
    State, Stats,
    bins::Entry,
    canvas::TILE,
    ink::Ink,
    lanes::{LANES, Wide, greatest, least},
    pixels::Pixels,
    rows::{Band, Exact, Left, Rows},
    setup::Setup,
    small::SmallRows,
    state::Rules,
    test::{Any, Codes, Masked, Nearer, Test},
    tile::{BLOCK, Tile},
};
use std::ops::Range;

/// Triangles of fewer rows than this are drawn without asking what is known of the blocks they lie in.
const SMALL: u32 = 6;

/// What all triangles of a tile share.
#[derive(Clone, Copy)]
pub(super) struct Job<'a> {
    /// The first pixel of the tile.
    pub(super) origin: [u32; 2],
    pub(super) state: &'a State,
    pub(super) rules: &'a Rules,
}

/// A triangle in a tile, as its pixels need it.
struct Pen<'a> {
    job: Job<'a>,
    entry: &'a Entry,
    /// What depth adds at each column: of the tile, or of a narrow triangle from its first one on.
    across: [f64; TILE],
    /// The depth at the first column of the tile in each row of a band, a little too near and too far.
    down: [Wide; 2],
}

/// Some rows of a band, [`BLOCK`] columns of them.
struct Piece {
    /// First column.
    x: usize,
    /// Where it stands in [`Pen::across`].
    across: usize,
    /// First row of the band.
    top: usize,
    /// Which of the band's rows.
    rows: Range<usize>,
}

impl Tile {
    /// Draws triangles in order.
    pub(super) fn draw(&mut self, ink: &mut impl Ink, job: Job<'_>, entries: &[Entry], stats: &mut Stats) {
        let state = job.state;
        let any = Any::new(state.depth);
        match (Codes::new(state.depth, state.store), state.stencil) {
            _ if state.lowers_depths() => self.draw_in_lanes(Nearer, ink, job, entries, stats),
            (None, None) => self.draw_in_lanes(any, ink, job, entries, stats),
            (None, Some(_)) => self.draw_in_lanes(Masked(any), ink, job, entries, stats),
            (Some(codes), None) => self.draw_in_lanes(codes, ink, job, entries, stats),
            (Some(codes), Some(_)) => self.draw_in_lanes(Masked(codes), ink, job, entries, stats),
        }
    }

    fn draw_in_lanes<T: Test, I: Ink>(
        &mut self,
        test: T,
        ink: &mut I,
        job: Job<'_>,
        entries: &[Entry],
        stats: &mut Stats,
    ) {
        job.state.lanes.run(
            #[inline(always)]
            || {
                for entries in entries.chunks(LANES) {
                    let farthest = self.farthest_of_all();
                    let setup = Setup::new(entries, (job.origin, farthest), job.rules, stats);
                    let rows = SmallRows::new(&setup, entries, &job, I::COUNTS, stats);
                    for (lane, entry) in entries.iter().enumerate() {
                        let lane = lane % LANES;
                        if setup.rows[0][lane] >= setup.rows[1][lane] {
                            continue;
                        }
                        if rows.small[lane] {
                            let drawn = (&setup, &rows, lane);
                            self.small_triangle((test, &mut *ink), drawn, (job, entry), stats);
                        } else {
                            self.triangle((test, &mut *ink), &setup, lane, (job, entry), stats);
                        }
                    }
                }
            },
        );
    }

    #[inline(always)]
    fn triangle<T: Test, I: Ink>(
        &mut self,
        (test, ink): (T, &mut I),
        setup: &Setup,
        lane: usize,
        (job, entry): (Job<'_>, &Entry),
        stats: &mut Stats,
    ) {
        let mut pen = Pen { job, entry, across: [0.0; TILE], down: [[0.0; LANES]; 2] };
        let [left, right] = [0, 1].map(|end| setup.columns[end][lane] as usize);
        let narrow = right - left <= BLOCK;
        let start = if narrow { left.min(TILE - BLOCK) } else { 0 };
        let slope = setup.dz_dx[lane];
        if narrow {
            for i in 0..BLOCK {
                pen.across[i] = slope * (start + i) as f64;
            }
        } else {
            for i in 0..TILE {
                pen.across[i] = slope * i as f64;
            }
        }
        let [first, last] = [0, 1].map(|end| setup.rows[end][lane]);
        // Of very small triangles nothing is worth asking.
        let hides = pen.job.rules.hierarchical_z && last - first >= SMALL;
        let behind = I::COUNTS && setup.behind[lane];
        let left_tile = if I::COUNTS && job.origin[0] > 0 { Left::Asked } else { Left::Unasked };
        for top in (first & !(LANES as u32 - 1)..last).step_by(LANES) {
            for i in 0..LANES {
                let down = setup.dz_dy[lane] * f64::from(top + i as u32);
                pen.down[0][i] = setup.depth[0][lane] + down;
                pen.down[1][i] = setup.depth[1][lane] + down;
            }
            let mut hidden = behind;
            if hides && !behind {
                let [near, _] = pen.extent(setup, lane, left - start, right - start);
                let columns = (left & !(BLOCK - 1)..right).step_by(BLOCK);
                let blocks = columns.len() as u64;
                hidden = columns.into_iter().all(|x| near >= f64::from(self.farthest(x, top as usize)));
                stats.hidden += if hidden { blocks } else { 0 };
            }
            if hidden && !I::COUNTS {
                continue;
            }
            let band = Band { top, first, last };
            let rows = Rows::new(setup, lane, (band, left_tile), || pen.edges(), stats);
            if rows.last == 0 {
                continue;
            }
            if I::COUNTS {
                rows.count(stats);
            }
            if hidden {
                continue;
            }
            let in_band = first.max(top) - top..last.min(top + LANES as u32) - top;
            let (top, in_band) = (top as usize, in_band.start as usize..in_band.end as usize);
            if narrow {
                stats.blocks += 1;
                self.age(start, top, BLOCK);
                self.fill(
                    (test, &mut *ink),
                    Piece { x: start, across: 0, top, rows: in_band },
                    &rows,
                    &pen,
                    stats,
                );
                continue;
            }
            for x in (rows.first as usize & !(BLOCK - 1)..rows.last as usize).step_by(BLOCK) {
                if hides {
                    let [near, far] = pen.extent(setup, lane, x, x + BLOCK);
                    if near >= f64::from(self.farthest(x, top)) {
                        stats.hidden += 1;
                        continue;
                    }
                    if rows.inner[0] as usize <= x && x + BLOCK <= rows.inner[1] as usize {
                        self.bring(x, top, far as f32);
                    }
                }
                stats.blocks += 1;
                self.age(x, top, BLOCK);
                self.fill(
                    (test, &mut *ink),
                    Piece { x, across: x, top, rows: in_band.clone() },
                    &rows,
                    &pen,
                    stats,
                );
            }
        }
    }

    /// The pixels of a piece.
    #[inline(always)]
    fn fill<T: Test, I: Ink>(
        &mut self,
        (test, ink): (T, &mut I),
        piece: Piece,
        rows: &Rows,
        pen: &Pen<'_>,
        stats: &mut Stats,
    ) {
        let mut across = [0.0; BLOCK];
        across.copy_from_slice(&pen.across[piece.across..piece.across + BLOCK]);
        for row in piece.rows.clone() {
            let row = row % LANES;
            let columns = rows.begin[row] as i32 - piece.x as i32..rows.end[row] as i32 - piece.x as i32;
            let ends = [pen.down[0][row], pen.down[1][row]];
            let pixels = Pixels { at: [piece.x, piece.top + row], columns, ends, across: &across };
            self.row_of_pixels((test, &mut *ink), &pixels, (pen.job, pen.entry), stats);
        }
    }
}

impl Pen<'_> {
    /// Bounds of the depths in the columns from `left` to before `right` of a band, counted as in `across`, within
    /// those of the vertices.
    #[inline(always)]
    fn extent(&self, setup: &Setup, lane: usize, left: usize, right: usize) -> [f64; 2] {
        let [left, right] = [self.across[left], self.across[right - 1]];
        let [near, far] = &self.down;
        let near = least(near[0], near[LANES - 1]) + least(left, right);
        let far = greatest(far[0], far[LANES - 1]) + greatest(left, right);
        [greatest(near, setup.range[0][lane]), least(far, setup.range[1][lane])]
    }

    #[cold]
    #[inline(never)]
    fn edges(&self) -> Exact {
        Exact::new(self.entry, &self.job)
    }
}
