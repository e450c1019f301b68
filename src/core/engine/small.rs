//! Small triangles: what a row of each covers is found for a few triangles at once, and a row of pixels is tested at
//! once for each.
//!
//! *Source:* Giesen, Optimizing Software Occlusion Culling, 2013 (small triangles pay for their set-up).

use super::{
    Stats,
    bins::Entry,
    canvas::TILE,
    fill::Job,
    ink::Ink,
    lanes::{LANES, Wide, greatest, least, mask},
    pixels::Pixels,
    rows::{Exact, column},
    setup::Setup,
    test::Test,
    tile::{BLOCK, Tile},
};

/// Most rows and columns of a small triangle.
pub(super) const SIDE: usize = BLOCK;

/// Of so many rows and more it is asked whether they are hidden.
const TALL: usize = 6;

/// What is covered of the rows of a few small triangles: the columns from `begin` to before `end`; of empty rows both
/// are 0.
pub(super) struct SmallRows {
    begin: [[u32; LANES]; SIDE],
    end: [[u32; LANES]; SIDE],
    /// Which triangles are small.
    pub(super) small: [bool; LANES],
}

impl SmallRows {
    /// Of the triangles of a set-up. `counts`: whether pixels and spans are counted.
    #[inline(always)]
    pub(super) fn new(
        setup: &Setup,
        entries: &[Entry],
        job: &Job<'_>,
        counts: bool,
        stats: &mut Stats,
    ) -> Self {
        let mut rows = Self { begin: [[0; LANES]; SIDE], end: [[0; LANES]; SIDE], small: [false; LANES] };
        let (mut heights, mut highest) = ([0_u32; LANES], 0);
        for i in 0..LANES {
            let height = setup.rows[1][i].saturating_sub(setup.rows[0][i]);
            let width = setup.columns[1][i].wrapping_sub(setup.columns[0][i]);
            rows.small[i] = height <= SIDE as u32 && width <= SIDE as u32;
            heights[i] = if rows.small[i] { height } else { 0 };
            highest = highest.max(heights[i]);
        }
        let asks_left = counts && job.origin[0] > 0;
        let mut edges: [Option<Exact>; LANES] = [const { None }; LANES];
        let mut exact = |i: usize| *edges[i].get_or_insert_with(|| Exact::new(&entries[i], job));
        for row in 0..SIDE.min(highest as usize) {
            let mut left = [[f64::NEG_INFINITY; LANES]; 2];
            let mut right = [[f64::INFINITY; LANES]; 2];
            let mut y: Wide = [0.0; LANES];
            for i in 0..LANES {
                y[i] = f64::from(setup.rows[0][i] + row as u32);
            }
            for crossings in &setup.edges {
                for i in 0..LANES {
                    let along = (y[i] - crossings.y[i]) * crossings.slope[i];
                    left[0][i] = greatest(left[0][i], along + crossings.left[0][i]);
                    left[1][i] = greatest(left[1][i], along + crossings.left[1][i]);
                    right[0][i] = least(right[0][i], along + crossings.right[0][i]);
                    right[1][i] = least(right[1][i], along + crossings.right[1][i]);
                }
            }
            let [left_low, left_high] = [column(&left[0]), column(&left[1])];
            let [right_low, right_high] = [column(&right[0]), column(&right[1])];
            let mut doubt = 0;
            for i in 0..LANES {
                let asked = mask((row as u32) < heights[i]);
                let differ = (left_low[i] ^ left_high[i]) | (right_low[i] ^ right_high[i]);
                let some = asked & mask(left_high[i] < right_high[i]);
                doubt |= differ & asked;
                rows.begin[row][i] = left_high[i] & some;
                rows.end[row][i] = right_high[i] & some;
            }
            if doubt != 0 {
                for i in 0..entries.len().min(LANES) {
                    let sides = [[left_low[i], left_high[i]], [right_low[i], right_high[i]]];
                    if (row as u32) < heights[i] && sides.iter().any(|[low, high]| low != high) {
                        [rows.begin[row][i], rows.end[row][i]] =
                            exact(i).row(setup.rows[0][i] + row as u32, sides, stats);
                    }
                }
            }
            let mut continued = 0;
            if asks_left {
                for i in 0..entries.len().min(LANES) {
                    if rows.begin[row][i] == 0 && rows.end[row][i] > 0 && left[0][i] <= -1.0 {
                        let y = setup.rows[0][i] + row as u32;
                        let goes_on = left[1][i] <= -1.0 || exact(i).covers_left(y, stats);
                        continued += u64::from(goes_on);
                    }
                }
            }
            if counts {
                let (mut pixels, mut spans) = (0, 0);
                for i in 0..LANES {
                    pixels += rows.end[row][i] - rows.begin[row][i];
                    spans += mask(rows.end[row][i] > 0) & 1;
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
        (setup, rows, lane): (&Setup, &SmallRows, usize),
        (job, entry): (Job<'_>, &Entry),
        stats: &mut Stats,
    ) {
        if I::COUNTS && setup.behind[lane] {
            return;
        }
        let [left, right] = [0, 1].map(|end| setup.columns[end][lane] as usize);
        let [first, last] = [0, 1].map(|end| setup.rows[end][lane] as usize);
        if job.rules.hierarchical_z && last - first >= TALL {
            let mut tops = (first & !(LANES - 1)..last).step_by(LANES);
            let mut hides = |x, y| setup.nearest[lane] >= f64::from(self.farthest(x, y));
            if tops.all(|y| hides(left, y) && hides(right - 1, y)) {
                stats.hidden += 1;
                return;
            }
        }
        if right - left <= 8 {
            self.small_rows::<T, I, 8>((test, ink), (setup, rows, lane), (job, entry), stats);
        } else {
            self.small_rows::<T, I, 16>((test, ink), (setup, rows, lane), (job, entry), stats);
        }
    }

    /// Its rows, `N` pixels of each.
    #[inline(always)]
    fn small_rows<T: Test, I: Ink, const N: usize>(
        &mut self,
        (test, ink): (T, &mut I),
        (setup, rows, lane): (&Setup, &SmallRows, usize),
        (job, entry): (Job<'_>, &Entry),
        stats: &mut Stats,
    ) {
        let start = (setup.columns[0][lane] as usize).min(TILE - N);
        let [first, last] = [0, 1].map(|end| setup.rows[end][lane] as usize);
        let slope = setup.dz_dx[lane];
        let mut across = [0.0; N];
        for i in 0..N {
            across[i] = slope * (start + i) as f64;
        }
        stats.blocks += 1;
        for top in (first & !(LANES - 1)..last).step_by(LANES) {
            self.age(start, top, N);
        }
        for (row, y) in (first..last).enumerate() {
            let (begin, end) = (rows.begin[row % SIDE][lane], rows.end[row % SIDE][lane]);
            if begin == end {
                continue;
            }
            let down = setup.dz_dy[lane] * y as f64;
            let ends = [setup.depth[0][lane] + down, setup.depth[1][lane] + down];
            let columns = begin as i32 - start as i32..end as i32 - start as i32;
            let pixels = Pixels { at: [start, y], columns, ends, across: &across };
            self.row_of_pixels((test, &mut *ink), &pixels, (job, entry), stats);
        }
    }
}
