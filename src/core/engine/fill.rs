//! Triangles into a tile: band by band of rows, block by block of columns, and the pixels of a row at once.
//!
//! *Source:* Greene, Kass, Miller, Hierarchical Z-Buffer Visibility, SIGGRAPH 1993; Giesen, Optimizing Software
//! Occlusion Culling, 2013. Deviation: a depth is tested as an interval around the exact one.

use super::{
    Rules, State, Stats,
    bins::Entry,
    canvas::TILE,
    lanes::{LANES, Wide, greatest, least, mask},
    rows::{Band, Exact, Rows},
    setup::Setup,
    test::{Any, Nearer, Test},
    tile::{BLOCK, Tile},
};
use crate::{
    depth::DepthPlane,
    math::{Arithmetic, Tally},
    raster::Edges,
    stencil::{StencilOutcome, StencilState},
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

impl Piece {
    /// The columns that a row of the triangle covers in it.
    fn columns(&self, rows: &Rows, row: usize) -> Range<usize> {
        (rows.begin[row] as usize).max(self.x)..(rows.end[row] as usize).min(self.x + BLOCK)
    }
}

impl Tile {
    /// Draws triangles in order.
    pub(super) fn draw(&mut self, job: Job<'_>, entries: &[Entry], stats: &mut Stats) {
        let state = job.state;
        if state.lowers_depths() {
            state.lanes.run(
                #[inline(always)]
                || self.draw_with(Nearer, job, entries, stats),
            );
        } else {
            let test = Any::new(state.depth);
            state.lanes.run(
                #[inline(always)]
                || self.draw_with(test, job, entries, stats),
            );
        }
    }

    #[inline(always)]
    fn draw_with<T: Test>(&mut self, test: T, job: Job<'_>, entries: &[Entry], stats: &mut Stats) {
        for entries in entries.chunks(LANES) {
            let farthest = self.farthest_of_all();
            let setup = Setup::new(entries, (job.origin, farthest), job.rules, stats);
            for (lane, entry) in entries.iter().enumerate() {
                let lane = lane % LANES;
                if setup.rows[0][lane] < setup.rows[1][lane] {
                    self.triangle(test, &setup, lane, (job, entry), stats);
                }
            }
        }
    }

    #[inline(always)]
    fn triangle<T: Test>(
        &mut self,
        test: T,
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
        for top in (first & !(LANES as u32 - 1)..last).step_by(LANES) {
            for i in 0..LANES {
                let down = setup.dz_dy[lane] * f64::from(top + i as u32);
                pen.down[0][i] = setup.depth[0][lane] + down;
                pen.down[1][i] = setup.depth[1][lane] + down;
            }
            if hides {
                let [near, _] = pen.extent(setup, lane, left - start, right - start);
                let columns = (left & !(BLOCK - 1)..right).step_by(BLOCK);
                let blocks = columns.len() as u64;
                if columns.into_iter().all(|x| near >= f64::from(self.farthest(x, top as usize))) {
                    stats.hidden += blocks;
                    continue;
                }
            }
            let rows = Rows::new(setup, lane, Band { top, first, last }, || pen.edges(), stats);
            if rows.last == 0 {
                continue;
            }
            let in_band = first.max(top) - top..last.min(top + LANES as u32) - top;
            let (top, in_band) = (top as usize, in_band.start as usize..in_band.end as usize);
            if narrow {
                stats.blocks += 1;
                self.age(start, top);
                self.fill(test, Piece { x: start, across: 0, top, rows: in_band }, &rows, &pen, stats);
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
                self.age(x, top);
                self.fill(test, Piece { x, across: x, top, rows: in_band.clone() }, &rows, &pen, stats);
            }
        }
    }

    /// The pixels of a piece.
    #[inline(always)]
    fn fill<T: Test>(&mut self, test: T, piece: Piece, rows: &Rows, pen: &Pen<'_>, stats: &mut Stats) {
        if let Some(state) = pen.job.state.stencil {
            self.fill_by_stencil(state, &piece, rows, pen, stats);
            return;
        }
        let mut across = [0.0; BLOCK];
        across.copy_from_slice(&pen.across[piece.across..piece.across + BLOCK]);
        let color = pen.entry.color;
        for row in piece.rows.clone() {
            let row = row % LANES;
            let (near, far) = (pen.down[0][row], pen.down[1][row]);
            let begin = rows.begin[row] as i32 - piece.x as i32;
            let end = rows.end[row] as i32 - piece.x as i32;
            let (depths, colors) = self.row(piece.x, piece.top + row);
            let (stored, painted) = (*depths, *colors);
            let (mut low, mut high) = ([0.0_f32; BLOCK], [0.0_f32; BLOCK]);
            for i in 0..BLOCK {
                low[i] = (near + across[i]) as f32;
                high[i] = (far + across[i]) as f32;
            }
            let (mut covered, mut drawn) = ([0; BLOCK], [0; BLOCK]);
            for i in 0..BLOCK {
                covered[i] = mask(i as i32 >= begin) & mask((i as i32) < end);
                drawn[i] = covered[i] & test.passes(low[i], stored[i]);
            }
            let mut doubt = 0;
            for i in 0..BLOCK {
                doubt |= (low[i].to_bits() ^ high[i].to_bits()) & test.matters(covered[i], drawn[i]);
            }
            if doubt != 0 {
                self.row_in_doubt(&piece, row, rows, pen, stats);
                continue;
            }
            let (mut new, mut paint) = ([0.0; BLOCK], [0; BLOCK]);
            let written = test.written();
            for i in 0..BLOCK {
                // Adding zero leaves no -0.
                let write = drawn[i] & written;
                new[i] = f32::from_bits((high[i] + 0.0).to_bits() & write | stored[i].to_bits() & !write);
            }
            for i in 0..BLOCK {
                paint[i] = color & drawn[i] | painted[i] & !drawn[i];
            }
            (*depths, *colors) = (new, paint);
        }
    }

    /// A row where an interval holds two depths: pixel by pixel.
    #[cold]
    #[inline(never)]
    fn row_in_doubt(&mut self, piece: &Piece, row: usize, rows: &Rows, pen: &Pen<'_>, stats: &mut Stats) {
        for x in piece.columns(rows, row) {
            self.test(piece, [x, row], pen, stats);
        }
    }

    /// The pixels of a piece under a stencil test, one by one.
    #[inline(never)]
    fn fill_by_stencil(
        &mut self,
        state: StencilState,
        piece: &Piece,
        rows: &Rows,
        pen: &Pen<'_>,
        stats: &mut Stats,
    ) {
        for row in piece.rows.clone() {
            for x in piece.columns(rows, row) {
                let stencil = *self.pixel(x, piece.top + row).stencil;
                let outcome = if !state.passes(stencil) {
                    StencilOutcome::Fail
                } else if self.test(piece, [x, row], pen, stats) {
                    StencilOutcome::Pass
                } else {
                    StencilOutcome::DepthFail
                };
                *self.pixel(x, piece.top + row).stencil = state.after(outcome, stencil);
            }
        }
    }

    /// The depth test of one pixel, and what follows from it.
    fn test(&mut self, piece: &Piece, [x, row]: [usize; 2], pen: &Pen<'_>, stats: &mut Stats) -> bool {
        let state = pen.job.state.depth;
        let y = piece.top + row;
        let pixel = self.pixel(x, y);
        let depth =
            if state.test { pen.depth([x, y], row, piece.across + x - piece.x, stats) } else { *pixel.depth };
        let passes = !state.test || state.compare.passes(depth, *pixel.depth);
        if passes {
            *pixel.color = pen.entry.color;
            if state.test && state.write {
                *pixel.depth = depth;
            }
        }
        passes
    }
}

impl Pen<'_> {
    /// The depth of a pixel of the tile, rounded once.
    fn depth(&self, pixel: [usize; 2], row: usize, across: usize, stats: &mut Stats) -> f32 {
        let [low, high] = [0, 1].map(|end| (self.down[end][row] + self.across[across]) as f32 + 0.0);
        if low == high {
            return low;
        }
        stats.exact_depths += 1;
        let tally = &mut Tally::default();
        let plane = DepthPlane::new(self.entry.corners, Arithmetic::Exact, tally);
        let [x, y] = [0, 1].map(|axis| self.job.origin[axis] + pixel[axis] as u32);
        plane.depth([x, y], tally) + 0.0
    }

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
        let points = self.entry.corners.map(|[x, y, _]| [x, y]);
        let edges = Edges::new(points, &self.job.rules.raster, &mut Tally::default());
        Exact { edges, origin: self.job.origin }
    }
}
