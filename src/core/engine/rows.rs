//! The rows of a triangle in a tile: where each begins and ends, by intervals, and exactly where these leave two
//! answers.

use super::{
    Stats,
    canvas::TILE,
    fill::Job,
    group::Group,
    lanes::{LANES, Wide, greatest, integer, least, mask},
    sides::Sides,
    stamp::{Each, SIDE, STAMP},
    tile::BLOCK,
};
use crate::math::Tally;
use crate::raster::{Edge, Edges};

const WIDTH: f64 = TILE as f64;

/// What is covered of [`LANES`] rows: the columns from `begin` to before `end`; empty rows have 0 and 0.
#[derive(Clone, Copy)]
pub(super) struct Rows {
    begin: [u32; LANES],
    end: [u32; LANES],
    /// The same with a bit for each column.
    pub(super) bits: [u64; LANES],
    /// How many columns each has.
    width: [u32; LANES],
    /// What is covered in any of them, and what in all; of rows that are not asked for nothing is.
    pub(super) any: u64,
    pub(super) all: u64,
    /// How many of them go on to the left, in the tile beside.
    continued: u32,
}

/// Whether rows are asked if they go on in the tile to the left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Left {
    /// They are not asked, or there is no tile.
    Unasked,
    /// They are, so that spans can be counted.
    Asked,
}

/// Of rows `top..top + LANES`, those from `first` to before `last` are asked for.
#[derive(Clone, Copy)]
pub(super) struct Band {
    pub(super) top: u32,
    pub(super) first: u32,
    pub(super) last: u32,
}

impl Rows {
    /// The rows of the triangle in one lane. `exact` makes its edges if they are needed.
    #[inline(always)]
    pub(super) fn new(
        sides: &Sides,
        lane: usize,
        (band, beside): (Band, Left),
        exact: impl Fn() -> Exact,
        stats: &mut Stats,
    ) -> Self {
        let mut left = [[f64::NEG_INFINITY; LANES]; 2];
        let mut right = [[f64::INFINITY; LANES]; 2];
        let top = f64::from(band.top);
        for crossings in &sides.edges {
            let (y, slope) = (crossings.y[lane], crossings.slope[lane]);
            let (l, r) = (crossings.left[lane], crossings.right[lane]);
            for i in 0..LANES {
                let along = (top + i as f64 - y) * slope;
                left[0][i] = greatest(left[0][i], along + l);
                right[0][i] = least(right[0][i], along + r);
            }
        }
        let doubt = sides.doubt[lane];
        for i in 0..LANES {
            left[1][i] = left[0][i] + doubt;
            right[1][i] = right[0][i] + doubt;
        }
        let mut rows = Self {
            begin: [0; LANES],
            end: [0; LANES],
            bits: [0; LANES],
            width: [0; LANES],
            any: 0,
            all: u64::MAX,
            continued: 0,
        };
        let [left_low, left_high] = [column(&left[0]), column(&left[1])];
        let [right_low, right_high] = [column(&right[0]), column(&right[1])];
        let mut doubt = 0;
        for i in 0..LANES {
            let row = band.top + i as u32;
            let asked = mask(row.wrapping_sub(band.first) < band.last - band.first);
            let differ = (left_low[i] ^ left_high[i]) | (right_low[i] ^ right_high[i]);
            let some = asked & mask(left_high[i] < right_high[i]);
            doubt |= differ & asked;
            rows.begin[i] = left_high[i] & some;
            rows.end[i] = right_high[i] & some;
        }
        if doubt != 0 {
            rows = exact().rows(band, rows, [[left_low, left_high], [right_low, right_high]], stats);
        }
        rows.make_bits();
        if beside == Left::Asked {
            for i in 0..LANES {
                if rows.begin[i] == 0 && rows.end[i] > 0 && left[0][i] <= -1.0 {
                    let first = [0, band.top as usize + i];
                    let goes_on = left[1][i] <= -1.0 || exact().covers_before(first, stats);
                    rows.continued += u32::from(goes_on);
                }
            }
        }
        rows
    }

    /// Which stamps of a block have a covered pixel, given its first column: every fourth bit, the first lowest.
    #[inline(always)]
    pub(super) fn stamps(&self, left: usize) -> u32 {
        const { assert!(SIDE == 4 && BLOCK == 16 && LANES == 2 * SIDE) }
        let [a, b, c, d, e, f, g, h] = self.bits;
        let upper = (a | b | c | d) >> left & 0xffff;
        let lower = (e | f | g | h) >> left & 0xffff;
        let any = upper as u32 | (lower as u32) << BLOCK;
        // Those of each four come together in the first.
        let any = any | any >> 1;
        (any | any >> 2) & 0x1111_1111
    }

    /// What is covered of a stamp, given its first column, and its first row in the band.
    #[inline(always)]
    pub(super) fn covered(&self, [left, top]: [usize; 2]) -> Each<u32> {
        let half = top / SIDE % (LANES / SIDE);
        let (begin, width) =
            (&self.begin.as_chunks::<SIDE>().0[half], &self.width.as_chunks::<SIDE>().0[half]);
        let mut covered = [0; STAMP];
        for i in 0..STAMP {
            let x = (left + i % SIDE) as u32;
            covered[i] = mask(x.wrapping_sub(begin[i / SIDE]) < width[i / SIDE]);
        }
        covered
    }

    /// Counts the pixels of all rows, and the spans that begin here.
    #[inline(always)]
    pub(super) fn count(&self, stats: &mut Stats) {
        let (mut pixels, mut rows) = (0, 0);
        for i in 0..LANES {
            pixels += self.end[i] - self.begin[i];
            rows += u32::from(self.end[i] > 0);
        }
        stats.fragments += u64::from(pixels);
        stats.spans += u64::from(rows - self.continued);
    }

    #[inline(always)]
    fn make_bits(&mut self) {
        let from = |column: u32| if column < TILE as u32 { u64::MAX << column } else { 0 };
        for i in 0..LANES {
            self.bits[i] = from(self.begin[i]) ^ from(self.end[i]);
        }
        for i in 0..LANES {
            self.any |= self.bits[i];
            self.all &= self.bits[i];
        }
        for i in 0..LANES {
            self.width[i] = self.end[i] - self.begin[i];
        }
    }
}

/// The first column at or behind a coordinate, within the tile or one past it.
#[inline(always)]
fn column(at: &Wide) -> [u32; LANES] {
    let mut columns = [0; LANES];
    for i in 0..LANES {
        columns[i] = integer(least(greatest(at[i], 0.0), WIDTH).ceil());
    }
    columns
}

/// The edges of a triangle, for exact signs at the centres of a tile.
#[derive(Clone, Copy)]
pub(super) struct Exact {
    pub(super) edges: Option<Edges>,
    pub(super) origin: [u32; 2],
}

impl Exact {
    /// Of a triangle in the tile of a job.
    #[cold]
    #[inline(never)]
    pub(super) fn new((group, lane): (&Group, usize), job: &Job<'_>) -> Self {
        let points = group.triangle(lane).map(|[x, y, _]| [x, y]);
        let edges = Edges::new(points, &job.rules.raster, &mut Tally::default());
        Self { edges, origin: job.origin }
    }

    /// The rows of a band, given the columns between which each of them begins and ends: where these differ, exact
    /// signs decide.
    #[cold]
    #[inline(never)]
    fn rows(&self, band: Band, mut rows: Rows, sides: [[[u32; LANES]; 2]; 2], stats: &mut Stats) -> Rows {
        for row in band.first.max(band.top)..band.last.min(band.top + LANES as u32) {
            let i = (row - band.top) as usize;
            let sides = sides.map(|[low, high]| [low[i], high[i]]);
            if sides.iter().any(|[low, high]| low != high) {
                [rows.begin[i], rows.end[i]] = self.row(row, sides, stats);
            }
        }
        rows
    }

    /// The columns of one row, from the first to before the last, given those between which each of them lies; 0 and
    /// 0 of an empty row.
    fn row(&self, row: u32, [left, right]: [[u32; 2]; 2], stats: &mut Stats) -> [u32; 2] {
        let Some(Edges(edges)) = &self.edges else { return [0; 2] };
        let (mut begin, mut end) = (left[0], right[1]);
        for edge in edges.iter().filter(|edge| edge.ends[0][1] != edge.ends[1][1]) {
            if edge.is_left() {
                begin = self.end(edge, row, [begin, left[1]], stats);
            } else {
                end = self.end(edge, row, [right[0], end], stats);
            }
        }
        if begin < end { [begin, end] } else { [0; 2] }
    }

    /// Whether a pixel of the tile is covered.
    pub(super) fn covers(&self, [column, row]: [usize; 2], stats: &mut Stats) -> bool {
        self.covers_centre([(self.origin[0] as usize + column) as f32 + 0.5, self.y(row as u32)], stats)
    }

    /// Whether the pixel to the left of one is covered, which may lie beside the tile.
    pub(super) fn covers_before(&self, [column, row]: [usize; 2], stats: &mut Stats) -> bool {
        self.covers_centre([(self.origin[0] as usize + column) as f32 - 0.5, self.y(row as u32)], stats)
    }

    fn covers_centre(&self, centre: [f32; 2], stats: &mut Stats) -> bool {
        let Some(edges) = &self.edges else { return false };
        stats.exact_signs += 1;
        edges.cover(centre, &mut Tally::default())
    }

    fn y(&self, row: u32) -> f32 {
        (self.origin[1] + row) as f32 + 0.5
    }

    /// The first column of a tile's row from which on an edge draws (a left one) or no longer draws, as far as
    /// it lies within a range.
    fn end(&self, edge: &Edge, row: u32, [mut low, mut high]: [u32; 2], stats: &mut Stats) -> u32 {
        let y = self.y(row);
        while low < high {
            let middle = low + (high - low) / 2;
            let x = (self.origin[0] + middle) as f32 + 0.5;
            stats.exact_signs += 1;
            let side = edge.side([x, y], &mut Tally::default());
            if edge.draws(side) == edge.is_left() {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        low
    }
}
