//! The pixels of one stamp of a triangle: stencil and depth test of all of them at once, and one by one where an interval
//! holds two depths or a stencil is in use.

use super::{
    Stats,
    depths::{Across, Start},
    fill::Subject,
    ink::{Ink, Stroke},
    lanes::{LANES, mask},
    stamp::{Each, Place, STAMP},
    test::Test,
    tile::Tile,
};
use crate::{
    depth::{DepthFormat, DepthPlane},
    math::{Arithmetic, Tally},
    stencil::StencilOutcome,
};

/// What a triangle covers of a stamp.
#[derive(Clone, Copy)]
pub(super) struct Covered {
    /// All bits or none of each pixel.
    pub(super) pixels: Each<u32>,
    /// The half-planes of the edges there.
    pub(super) planes: [Each<f32>; 3],
}

/// The pixels of a stamp with their depths: what it begins with, and what each of them adds.
pub(super) struct Pixels<'a> {
    pub(super) place: Place,
    pub(super) start: Start,
    pub(super) across: &'a Across,
}

impl Subject<'_> {
    /// What is stored for its depth at a pixel: rounded once.
    #[cold]
    #[inline(never)]
    fn depth(&self, [x, y]: [usize; 2], stats: &mut Stats) -> f32 {
        let Subject { job, group, lane, .. } = *self;
        stats.exact_depths += 1;
        let tally = &mut Tally::default();
        let plane = DepthPlane::new(group.triangle(lane), Arithmetic::Exact, tally);
        let pixel = [job.origin[0] + x as u32, job.origin[1] + y as u32];
        match job.state.store.format() {
            DepthFormat::F32 => plane.depth(pixel, tally) + 0.0,
            format => plane.code(pixel, format, tally) as f32,
        }
    }
}

impl Tile {
    /// Draws the pixels of a stamp.
    #[inline(always)]
    pub(super) fn stamped<T: Test, I: Ink>(
        &mut self,
        (test, ink): (T, &mut I),
        (pixels, covered): (&Pixels<'_>, Covered),
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) {
        // A copy: what is named nowhere else need not be in memory.
        let place = pixels.place;
        let [low, high] = test.stamp(pixels, subject);
        if T::STENCIL {
            self.by_stencil((test, ink), (place, covered, [low, high]), subject, stats);
            return;
        }
        let (depths, colors) = self.stamp(place);
        let (stored, painted) = (*depths, *colors);
        let color = subject.group.colors[subject.lane % LANES];
        let mut drawn = [0; STAMP];
        for i in 0..STAMP {
            drawn[i] = covered.pixels[i] & test.passes([low[i], stored[i]], [color, painted[i]]);
        }
        let mut doubt = 0;
        for i in 0..STAMP {
            doubt |= (low[i].to_bits() ^ high[i].to_bits()) & test.matters(covered.pixels[i], drawn[i]);
        }
        if doubt != 0 {
            self.in_doubt((test, ink), (place, covered, [low, high]), subject, stats);
            return;
        }
        let mut new = [0.0; STAMP];
        let written = test.written();
        for i in 0..STAMP {
            let write = drawn[i] & written;
            new[i] = f32::from_bits(high[i].to_bits() & write | stored[i].to_bits() & !write);
        }
        *depths = new;
        self.color(ink, place, (&covered, &drawn), subject, stats);
    }

    /// Colours what passes of a stamp.
    #[inline(always)]
    fn color<I: Ink>(
        &mut self,
        ink: &mut I,
        place: Place,
        (covered, drawn): (&Covered, &Each<u32>),
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) {
        if I::COUNTS {
            stats.passed += u64::from(drawn.iter().map(|drawn| drawn & 1).sum::<u32>());
        }
        let (_, colors) = self.stamp(place);
        let stroke = Stroke::new(subject, place, &covered.planes);
        ink.stamp(stroke, [&covered.pixels, drawn], colors, stats);
        if I::TOUCHES {
            self.touch(place, drawn);
        }
    }

    /// Where an interval holds two depths: pixel by pixel.
    #[cold]
    #[inline(never)]
    fn in_doubt<T: Test, I: Ink>(
        &mut self,
        (test, ink): (T, &mut I),
        (place, covered, ends): (Place, Covered, [Each<f32>; 2]),
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) {
        let mut drawn = [0; STAMP];
        for i in (0..STAMP).filter(|&i| covered.pixels[i] != 0) {
            drawn[i] = mask(self.test(test, (place, i), ends, subject, stats));
        }
        self.color(ink, place, (&covered, &drawn), subject, stats);
    }

    /// Under a stencil test, pixel by pixel.
    #[inline(never)]
    fn by_stencil<T: Test, I: Ink>(
        &mut self,
        (test, ink): (T, &mut I),
        (place, covered, ends): (Place, Covered, [Each<f32>; 2]),
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) {
        let state = subject.job.state.stencil.unwrap_or_default();
        let mut drawn = [0; STAMP];
        for i in (0..STAMP).filter(|&i| covered.pixels[i] != 0) {
            let stencil = self.stencils(place)[i];
            let outcome = if !state.passes(stencil) {
                stats.stencil_failed += 1;
                StencilOutcome::Fail
            } else if self.test(test, (place, i), ends, subject, stats) {
                StencilOutcome::Pass
            } else {
                StencilOutcome::DepthFail
            };
            drawn[i] = mask(outcome == StencilOutcome::Pass);
            self.stencils(place)[i] = state.after(outcome, stencil);
        }
        self.color(ink, place, (&covered, &drawn), subject, stats);
    }

    /// The depth test of one pixel, and the depth that follows from it.
    #[inline]
    fn test<T: Test>(
        &mut self,
        test: T,
        (place, i): (Place, usize),
        [low, high]: [Each<f32>; 2],
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) -> bool {
        let state = subject.job.state.depth;
        if !state.test {
            return true;
        }
        let is_known = low[i].to_bits() == high[i].to_bits();
        let depth = if is_known { low[i] } else { subject.depth(place.pixel(i), stats) };
        let (depths, colors) = self.stamp(place);
        let color = subject.group.colors[subject.lane % LANES];
        let passes = test.passes([depth, depths[i]], [color, colors[i]]) != 0;
        if passes && state.write {
            depths[i] = depth;
        }
        passes
    }
}
