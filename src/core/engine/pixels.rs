//! The pixels of one row of a triangle: stencil and depth test of all of them at once, and one by one where an interval
//! holds two depths or a stencil is in use.

use super::{
    Stats,
    bins::Entry,
    fill::Job,
    ink::Ink,
    lanes::mask,
    test::Test,
    tile::{BLOCK, Tile},
};
use crate::{
    depth::{DepthFormat, DepthPlane},
    math::{Arithmetic, Tally},
    stencil::StencilOutcome,
};
use std::ops::Range;

/// Some neighbouring pixels of a row of a tile.
pub(super) struct Pixels<'a, const N: usize> {
    /// Column and row of the first.
    pub(super) at: [usize; 2],
    /// Which of them the triangle covers, counted from the first; others may be named.
    pub(super) columns: Range<i32>,
    /// The depth at the first column of the tile, a little too near and too far.
    pub(super) ends: [f64; 2],
    /// What the depth adds at each of them.
    pub(super) across: &'a [f64; N],
}

impl<const N: usize> Pixels<'_, N> {
    /// Those of them that are covered.
    fn covered(&self) -> Range<usize> {
        self.columns.start.clamp(0, N as i32) as usize..self.columns.end.clamp(0, N as i32) as usize
    }

    /// What is stored for the depth of one of them: rounded once.
    fn depth<T: Test>(&self, test: T, i: usize, (job, entry): (Job<'_>, &Entry), stats: &mut Stats) -> f32 {
        let [near, far] = self.ends.map(|end| end + self.across[i]);
        let [low, high] = test.ends(near, far).map(|depth| depth + 0.0);
        if low == high {
            return low;
        }
        stats.exact_depths += 1;
        let tally = &mut Tally::default();
        let plane = DepthPlane::new(entry.corners, Arithmetic::Exact, tally);
        let pixel = [job.origin[0] + (self.at[0] + i) as u32, job.origin[1] + self.at[1] as u32];
        match job.state.store.format() {
            DepthFormat::F32 => plane.depth(pixel, tally) + 0.0,
            format => plane.code(pixel, format, tally) as f32,
        }
    }
}

/// Most pixels that are looked at together.
const MOST: usize = BLOCK;

/// For each count, which of the pixels lie before it: looked up, since comparing takes longer.
const BEFORE: [[u32; MOST]; MOST + 1] = {
    let mut rows = [[0; MOST]; MOST + 1];
    let mut count = 0;
    while count <= MOST {
        let mut i = 0;
        while i < count {
            rows[count][i] = u32::MAX;
            i += 1;
        }
        count += 1;
    }
    rows
};

/// Which of some pixels lie before a column.
#[inline(always)]
fn before<const N: usize>(column: i32) -> [u32; N] {
    let row = &BEFORE[column.clamp(0, MOST as i32) as usize];
    let mut pixels = [0; N];
    pixels.copy_from_slice(&row[..N]);
    pixels
}

impl Tile {
    /// Draws pixels of a row.
    #[inline(always)]
    pub(super) fn row_of_pixels<T: Test, I: Ink, const N: usize>(
        &mut self,
        (test, ink): (T, &mut I),
        pixels: &Pixels<'_, N>,
        (job, entry): (Job<'_>, &Entry),
        stats: &mut Stats,
    ) {
        if T::STENCIL {
            self.by_stencil((test, ink), pixels, (job, entry), stats);
            return;
        }
        let [begun, ended]: [[u32; N]; 2] = [pixels.columns.start, pixels.columns.end].map(before);
        let [near, far] = pixels.ends;
        let (depths, colors) = self.row(pixels.at[0], pixels.at[1]);
        let (stored, painted) = (*depths, *colors);
        let (mut low, mut high) = ([0.0_f32; N], [0.0_f32; N]);
        for i in 0..N {
            [low[i], high[i]] = test.ends(near + pixels.across[i], far + pixels.across[i]);
        }
        let (mut covered, mut drawn) = ([0; N], [0; N]);
        for i in 0..N {
            covered[i] = ended[i] & !begun[i];
            drawn[i] = covered[i] & test.passes(low[i], stored[i]);
        }
        let mut doubt = 0;
        for i in 0..N {
            doubt |= (low[i].to_bits() ^ high[i].to_bits()) & test.matters(covered[i], drawn[i]);
        }
        if doubt != 0 {
            self.in_doubt((test, ink), pixels, (job, entry), stats);
            return;
        }
        let mut new = [0.0; N];
        let written = test.written();
        for i in 0..N {
            // Adding zero leaves no -0.
            let write = drawn[i] & written;
            new[i] = f32::from_bits((high[i] + 0.0).to_bits() & write | stored[i].to_bits() & !write);
        }
        *depths = new;
        if I::COUNTS {
            stats.passed += u64::from(drawn.iter().map(|drawn| drawn & 1).sum::<u32>());
        }
        let pixel = [0, 1].map(|axis| job.origin[axis] + pixels.at[axis] as u32);
        *colors = ink.row(entry.color, pixel, [&covered, &drawn], painted, stats);
        if I::TOUCHES {
            self.touch(pixels.at, (0..N).map(|i| u64::from(drawn[i] & 1) << i).sum());
        }
    }

    /// Where an interval holds two depths: pixel by pixel.
    #[cold]
    #[inline(never)]
    fn in_doubt<T: Test, I: Ink, const N: usize>(
        &mut self,
        (test, ink): (T, &mut I),
        pixels: &Pixels<'_, N>,
        (job, entry): (Job<'_>, &Entry),
        stats: &mut Stats,
    ) {
        for i in pixels.covered() {
            let passes = self.test(test, pixels, i, (job, entry), stats);
            self.color(ink, [pixels.at[0] + i, pixels.at[1]], passes, (job, entry), stats);
        }
    }

    /// Under a stencil test, pixel by pixel.
    #[inline(never)]
    fn by_stencil<T: Test, I: Ink, const N: usize>(
        &mut self,
        (test, ink): (T, &mut I),
        pixels: &Pixels<'_, N>,
        (job, entry): (Job<'_>, &Entry),
        stats: &mut Stats,
    ) {
        let state = job.state.stencil.unwrap_or_default();
        for i in pixels.covered() {
            let [x, y] = [pixels.at[0] + i, pixels.at[1]];
            let stencil = *self.pixel(x, y).stencil;
            let outcome = if !state.passes(stencil) {
                stats.stencil_failed += 1;
                StencilOutcome::Fail
            } else if self.test(test, pixels, i, (job, entry), stats) {
                StencilOutcome::Pass
            } else {
                StencilOutcome::DepthFail
            };
            self.color(ink, [x, y], outcome == StencilOutcome::Pass, (job, entry), stats);
            *self.pixel(x, y).stencil = state.after(outcome, stencil);
        }
    }

    /// The depth test of one pixel, and the depth that follows from it.
    fn test<T: Test, const N: usize>(
        &mut self,
        test: T,
        pixels: &Pixels<'_, N>,
        i: usize,
        (job, entry): (Job<'_>, &Entry),
        stats: &mut Stats,
    ) -> bool {
        let state = job.state.depth;
        if !state.test {
            return true;
        }
        let depth = pixels.depth(test, i, (job, entry), stats);
        let stored = self.pixel(pixels.at[0] + i, pixels.at[1]).depth;
        let passes = state.compare.passes(depth, *stored);
        if passes && state.write {
            *stored = depth;
        }
        passes
    }

    /// The colour of one fragment that passes, or not.
    fn color<I: Ink>(
        &mut self,
        ink: &mut I,
        [x, y]: [usize; 2],
        passes: bool,
        (job, entry): (Job<'_>, &Entry),
        stats: &mut Stats,
    ) {
        let pixel = [job.origin[0] + x as u32, job.origin[1] + y as u32];
        let color = self.pixel(x, y).color;
        [*color] = ink.row(entry.color, pixel, [&[u32::MAX], &[mask(passes)]], [*color], stats);
        if I::COUNTS {
            stats.passed += u64::from(passes);
        }
        if I::TOUCHES && passes {
            self.touch([x, y], 1);
        }
    }
}
