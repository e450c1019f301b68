//! The pixels of one row of a triangle: stencil and depth test of all of them at once, and one by one where an interval
//! holds two depths or a stencil is in use.

use super::{
    Stats,
    depths::{Across, Start},
    fill::Subject,
    ink::{Ink, Stroke},
    lanes::{LANES, mask},
    rows::Exact,
    test::Test,
    tile::Tile,
};
use crate::{
    depth::{DepthFormat, DepthPlane},
    math::{Arithmetic, Tally},
    stencil::StencilOutcome,
};

/// Neighbouring pixels of a row of a tile.
#[derive(Clone, Copy)]
pub(super) struct Place {
    /// Column and row of the first.
    pub(super) at: [usize; 2],
}

/// Which of a row's pixels a triangle covers: all bits or none.
#[derive(Clone, Copy)]
pub(super) struct Covered<const N: usize> {
    /// Surely.
    pub(super) sure: [u32; N],
    /// Surely, or it is open.
    pub(super) maybe: [u32; N],
    /// The half-planes of the edges there.
    pub(super) planes: [[f32; N]; 3],
}

impl<const N: usize> Covered<N> {
    /// Those of set bits, the first lowest.
    #[inline(always)]
    pub(super) fn bits(bits: u32, planes: [[f32; N]; 3]) -> Self {
        let mut sure = [0; N];
        for i in 0..N {
            sure[i] = mask(bits & (1 << i) != 0);
        }
        Self { sure, maybe: sure, planes }
    }

    /// Whether something is open.
    #[inline(always)]
    pub(super) fn is_open(&self) -> bool {
        let mut open = 0;
        for i in 0..N {
            open |= self.sure[i] ^ self.maybe[i];
        }
        open != 0
    }

    /// What is open is decided exactly.
    #[cold]
    #[inline(never)]
    pub(super) fn decided(&self, place: Place, subject: &Subject<'_>, stats: &mut Stats) -> Self {
        let mut sure = self.sure;
        let exact = Exact::new((subject.group, subject.lane), &subject.job);
        for i in 0..N {
            if self.maybe[i] != sure[i] {
                sure[i] = mask(exact.covers([place.at[0] + i, place.at[1]], stats));
            }
        }
        Self { sure, maybe: sure, planes: self.planes }
    }
}

/// The same with their depths: what the row begins with, and what each of them adds.
pub(super) struct Pixels<'a, const N: usize> {
    pub(super) place: Place,
    pub(super) start: Start,
    pub(super) across: &'a Across<N>,
}

impl Place {
    /// The depth of one of them, a little too near and too far.
    #[inline(always)]
    pub(super) fn interval(&self, i: usize, subject: &Subject<'_>) -> [f64; 2] {
        subject.setup.interval(subject.lane, self.at[0] + i, self.at[1])
    }

    /// What is stored for the depth of one of them: rounded once.
    fn depth<T: Test>(&self, test: T, i: usize, subject: &Subject<'_>, stats: &mut Stats) -> f32 {
        let Subject { job, group, lane, .. } = *subject;
        let [near, far] = self.interval(i, subject);
        let [low, high] = test.ends(near, far).map(|depth| depth + 0.0);
        if low == high {
            return low;
        }
        stats.exact_depths += 1;
        let tally = &mut Tally::default();
        let plane = DepthPlane::new(group.triangle(lane), Arithmetic::Exact, tally);
        let pixel = [job.origin[0] + (self.at[0] + i) as u32, job.origin[1] + self.at[1] as u32];
        match job.state.store.format() {
            DepthFormat::F32 => plane.depth(pixel, tally) + 0.0,
            format => plane.code(pixel, format, tally) as f32,
        }
    }
}

impl Tile {
    /// Draws pixels of a row.
    #[inline(always)]
    pub(super) fn row_of_pixels<T: Test, I: Ink, const N: usize>(
        &mut self,
        (test, ink): (T, &mut I),
        (pixels, covered): (&Pixels<'_, N>, Covered<N>),
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) {
        // A copy: what is named nowhere else need not be in memory.
        let place = pixels.place;
        if T::STENCIL {
            self.by_stencil::<T, I, N>((test, ink), (place, covered), subject, stats);
            return;
        }
        let (depths, colors) = self.row(place.at[0], place.at[1]);
        let (stored, painted) = (*depths, *colors);
        let [low, high] = test.row(pixels, subject);
        let color = subject.group.colors[subject.lane % LANES];
        let Covered { sure, maybe, planes } = covered;
        let mut drawn = [0; N];
        for i in 0..N {
            drawn[i] = maybe[i] & test.passes([low[i], stored[i]], [color, painted[i]]);
        }
        let mut doubt = 0;
        for i in 0..N {
            let depth = (low[i].to_bits() ^ high[i].to_bits()) & test.matters(maybe[i], drawn[i]);
            doubt |= depth | (sure[i] ^ maybe[i]) & drawn[i];
        }
        if doubt != 0 {
            self.in_doubt::<T, I, N>((test, ink), (place, covered), subject, stats);
            return;
        }
        let mut new = [0.0; N];
        let written = test.written();
        for i in 0..N {
            let write = drawn[i] & written;
            new[i] = f32::from_bits(high[i].to_bits() & write | stored[i].to_bits() & !write);
        }
        *depths = new;
        if I::COUNTS {
            stats.passed += u64::from(drawn.iter().map(|drawn| drawn & 1).sum::<u32>());
        }
        let pixel = [0, 1].map(|axis| subject.job.origin[axis] + place.at[axis] as u32);
        let stroke = Stroke { color, lane: subject.lane % LANES, pixel, planes: &planes };
        *colors = ink.row(stroke, [&maybe, &drawn], painted, stats);
        if I::TOUCHES {
            self.touch(place.at, (0..N).map(|i| u64::from(drawn[i] & 1) << i).sum());
        }
    }

    /// Where it is open whether a pixel is covered, or an interval holds two depths: pixel by pixel.
    #[cold]
    #[inline(never)]
    fn in_doubt<T: Test, I: Ink, const N: usize>(
        &mut self,
        (test, ink): (T, &mut I),
        (place, covered): (Place, Covered<N>),
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) {
        let covered = if covered.is_open() { covered.decided(place, subject, stats) } else { covered };
        for i in (0..N).filter(|&i| covered.sure[i] != 0) {
            let passes = self.test(test, place, i, subject, stats);
            self.color(ink, [place.at[0] + i, place.at[1]], passes, subject, stats);
        }
    }

    /// Under a stencil test, pixel by pixel.
    #[inline(never)]
    fn by_stencil<T: Test, I: Ink, const N: usize>(
        &mut self,
        (test, ink): (T, &mut I),
        (place, covered): (Place, Covered<N>),
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) {
        let state = subject.job.state.stencil.unwrap_or_default();
        let covered = if covered.is_open() { covered.decided(place, subject, stats) } else { covered };
        for i in (0..N).filter(|&i| covered.sure[i] != 0) {
            let [x, y] = [place.at[0] + i, place.at[1]];
            let stencil = *self.pixel(x, y).stencil;
            let outcome = if !state.passes(stencil) {
                stats.stencil_failed += 1;
                StencilOutcome::Fail
            } else if self.test(test, place, i, subject, stats) {
                StencilOutcome::Pass
            } else {
                StencilOutcome::DepthFail
            };
            self.color(ink, [x, y], outcome == StencilOutcome::Pass, subject, stats);
            *self.pixel(x, y).stencil = state.after(outcome, stencil);
        }
    }

    /// The depth test of one pixel, and the depth that follows from it.
    fn test<T: Test>(
        &mut self,
        test: T,
        place: Place,
        i: usize,
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) -> bool {
        let state = subject.job.state.depth;
        if !state.test {
            return true;
        }
        let depth = place.depth(test, i, subject, stats);
        let pixel = self.pixel(place.at[0] + i, place.at[1]);
        let color = subject.group.colors[subject.lane % LANES];
        let passes = test.passes([depth, *pixel.depth], [color, *pixel.color]) != 0;
        if passes && state.write {
            *pixel.depth = depth;
        }
        passes
    }

    /// The colour of one fragment that passes, or not.
    fn color<I: Ink>(
        &mut self,
        ink: &mut I,
        [x, y]: [usize; 2],
        passes: bool,
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) {
        let Subject { job, group, lane, .. } = *subject;
        let pixel = [job.origin[0] + x as u32, job.origin[1] + y as u32];
        let color = self.pixel(x, y).color;
        let stroke = Stroke { color: group.colors[lane], lane, pixel, planes: &[[f32::NAN]; 3] };
        [*color] = ink.row(stroke, [&[u32::MAX], &[mask(passes)]], [*color], stats);
        if I::COUNTS {
            stats.passed += u64::from(passes);
        }
        if I::TOUCHES && passes {
            self.touch([x, y], 1);
        }
    }
}
