//! Small triangles: what a row of each covers is found for a few triangles at once, and a row of pixels is tested at
//! once for each.
//!
//! *Source:* Giesen, Optimizing Software Occlusion Culling, 2013 (small triangles pay for their set-up).

use super::{
    Stats,
    bins::Group,
    canvas::TILE,
    depths::{Across, Starts},
    fill::{Job, Subject},
    ink::Ink,
    lanes::{LANES, Wide, greatest, least, mask},
    pixels::{Pixels, Place},
    rows::{Exact, column},
    setup::Setup,
    test::Test,
    tile::{BLOCK, Tile},
};

/// Most rows and columns of a small triangle.
pub(super) const SIDE: usize = BLOCK;

/// Of so many rows and more it is asked whether they are hidden.
const TALL: usize = 6;

/// What is covered of the rows of a few small triangles.
pub(super) struct SmallRows {
    /// A bit for each column, from the first one that is looked at.
    covered: [[u32; LANES]; SIDE],
    /// What their depths begin with.
    starts: [Starts; SIDE],
    /// The first of the columns that are looked at, and how many of them: 8 or 16.
    first: [u32; LANES],
    count: [u32; LANES],
    /// Which triangles are small.
    pub(super) small: [bool; LANES],
}

impl SmallRows {
    /// Of the triangles of a set-up. `counts`: whether pixels and spans are counted.
    #[inline(always)]
    pub(super) fn new(setup: &Setup, group: &Group, job: &Job<'_>, counts: bool, stats: &mut Stats) -> Self {
        let mut rows = Self {
            covered: [[0; LANES]; SIDE],
            starts: [Starts::NOTHING; SIDE],
            first: [0; LANES],
            count: [0; LANES],
            small: [false; LANES],
        };
        let mut x = [0.0; LANES];
        let (mut heights, mut highest) = ([0_u32; LANES], 0);
        for i in 0..LANES {
            let height = setup.rows[1][i].saturating_sub(setup.rows[0][i]);
            let width = setup.columns[1][i].wrapping_sub(setup.columns[0][i]);
            rows.small[i] = height <= SIDE as u32 && width <= SIDE as u32;
            heights[i] = if rows.small[i] { height } else { 0 };
            highest = highest.max(heights[i]);
            rows.count[i] = if width <= 8 { 8 } else { 16 };
            rows.first[i] = setup.columns[0][i].min(TILE as u32 - rows.count[i]);
            x[i] = f64::from(rows.first[i]);
        }
        let asks_left = counts && job.origin[0] > 0;
        let mut edges: [Option<Exact>; LANES] = [const { None }; LANES];
        let mut exact = |i: usize| *edges[i].get_or_insert_with(|| Exact::new((group, i), job));
        for row in 0..SIDE.min(highest as usize) {
            let mut left = [[f64::NEG_INFINITY; LANES]; 2];
            let mut right = [[f64::INFINITY; LANES]; 2];
            let mut y: Wide = [0.0; LANES];
            for i in 0..LANES {
                y[i] = f64::from(setup.rows[0][i] + row as u32);
            }
            rows.starts[row] = setup.starts_of_all(&x, &y);
            for crossings in &setup.edges {
                for i in 0..LANES {
                    let along = (y[i] - crossings.y[i]) * crossings.slope[i];
                    left[0][i] = greatest(left[0][i], along + crossings.left[i]);
                    right[0][i] = least(right[0][i], along + crossings.right[i]);
                }
            }
            for i in 0..LANES {
                left[1][i] = left[0][i] + setup.doubt[i];
                right[1][i] = right[0][i] + setup.doubt[i];
            }
            let [left_low, left_high] = [column(&left[0]), column(&left[1])];
            let [right_low, right_high] = [column(&right[0]), column(&right[1])];
            let (mut begin, mut end) = ([0; LANES], [0; LANES]);
            let mut doubt = 0;
            for i in 0..LANES {
                let asked = mask((row as u32) < heights[i]);
                let differ = (left_low[i] ^ left_high[i]) | (right_low[i] ^ right_high[i]);
                let some = asked & mask(left_high[i] < right_high[i]);
                doubt |= differ & asked;
                begin[i] = left_high[i] & some;
                end[i] = right_high[i] & some;
            }
            if doubt != 0 {
                for i in 0..LANES {
                    let sides = [[left_low[i], left_high[i]], [right_low[i], right_high[i]]];
                    if (row as u32) < heights[i] && sides.iter().any(|[low, high]| low != high) {
                        [begin[i], end[i]] = exact(i).row(setup.rows[0][i] + row as u32, sides, stats);
                    }
                }
            }
            for i in 0..LANES {
                let first = rows.first[i];
                let from = |column: u32| 1_u32.wrapping_shl(column.wrapping_sub(first));
                rows.covered[row][i] = from(end[i]).wrapping_sub(from(begin[i]));
            }
            let mut continued = 0;
            if asks_left {
                for i in 0..LANES {
                    if begin[i] == 0 && end[i] > 0 && left[0][i] <= -1.0 {
                        let y = setup.rows[0][i] + row as u32;
                        let goes_on = left[1][i] <= -1.0 || exact(i).covers_left(y, stats);
                        continued += u64::from(goes_on);
                    }
                }
            }
            if counts {
                let (mut pixels, mut spans) = (0, 0);
                for i in 0..LANES {
                    pixels += end[i] - begin[i];
                    spans += mask(end[i] > 0) & 1;
                }
                stats.fragments += u64::from(pixels);
                stats.spans += u64::from(spans) - continued;
            }
        }
        rows
    }
}

impl Tile {
    /// Draws one of the small triangles.
    #[inline(always)]
    pub(super) fn small_triangle<T: Test, I: Ink>(
        &mut self,
        (test, ink): (T, &mut I),
        rows: &SmallRows,
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) {
        let Subject { job, setup, lane, .. } = *subject;
        if I::COUNTS && setup.behind[lane] {
            return;
        }
        let [left, right] = [0, 1].map(|end| setup.columns[end][lane] as usize);
        let [first, last] = [0, 1].map(|end| setup.rows[end][lane] as usize);
        if job.rules.hierarchical_z && last - first >= TALL {
            let mut tops = (first & !(LANES - 1)..last).step_by(LANES);
            let near = setup.nearest[lane];
            if tops.all(|y| self.hides(left, y, near) && self.hides(right - 1, y, near)) {
                stats.hidden += 1;
                return;
            }
        }
        if rows.count[lane] == 8 {
            self.small_rows::<T, I, 8>((test, ink), rows, subject, stats);
        } else {
            self.small_rows::<T, I, 16>((test, ink), rows, subject, stats);
        }
    }

    /// Its rows, `N` pixels of each.
    #[inline(always)]
    fn small_rows<T: Test, I: Ink, const N: usize>(
        &mut self,
        (test, ink): (T, &mut I),
        rows: &SmallRows,
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) {
        let Subject { setup, lane, .. } = *subject;
        let start = rows.first[lane] as usize;
        let [first, last] = [0, 1].map(|end| setup.rows[end][lane] as usize);
        let across: Across<N> = setup.across(lane);
        stats.blocks += 1;
        for top in (first & !(LANES - 1)..last).step_by(LANES) {
            self.age(start, top, N);
        }
        for (row, y) in (first..last).enumerate() {
            let place = Place { at: [start, y], covered: rows.covered[row % SIDE][lane] };
            if place.covered == 0 {
                continue;
            }
            let pixels = Pixels { place, start: rows.starts[row % SIDE].at(lane), across: &across };
            self.row_of_pixels((test, &mut *ink), &pixels, subject, stats);
        }
    }
}
