//! What happens to fragments, counted during one image.

use super::{
    Skip, Stats,
    fragments::{FragmentState, ImageState},
    stats::Reason,
};
use crate::{
    math::Tally,
    raster::{Samples, cover, cover_samples},
    stage::Stage,
};

/// What is counted from scan conversion on.
#[derive(Debug, Default)]
pub(super) struct Counts {
    pub(super) pieces: u64,
    pub(super) spans: u64,
    pub(super) fragments: u64,
    pub(super) carried: u64,
    pub(super) scissored: u64,
    pub(super) discarded: u64,
    /// Either test.
    pub(super) failed: u64,
    pub(super) stencil_failed: u64,
    pub(super) redrawn: u64,
    pub(super) never_colored: u64,
    pub(super) row_skipped: u64,
    pub(super) tally: Tally,
}

impl Counts {
    /// A triangle whose fragments are dropped.
    pub(super) fn carry(&mut self, vertices: [[f32; 2]; 3], state: &ImageState) {
        let Self { spans, fragments, carried, row_skipped, tally, .. } = self;
        if state.samples != Samples::One {
            let mut pixels = 0;
            cover_samples(vertices, state.samples, &state.settings(), tally, &mut |_, _| pixels += 1);
            *fragments += pixels;
            *carried += pixels;
            return;
        }
        let counts =
            cover(state.rasterizer.algorithm(), vertices, &state.settings(), tally, &mut |_| *spans += 1);
        *row_skipped += counts.skipped;
        *fragments += counts.covered;
        *carried += counts.covered;
    }

    /// Adds them up, from scan conversion on.
    pub(super) fn add_to<'s>(
        &self,
        stats: &mut Stats,
        states: impl Iterator<Item = &'s FragmentState> + Clone,
    ) {
        let any = |uses: fn(&FragmentState) -> bool| states.clone().any(uses);
        let drawn = self.fragments - self.carried - self.scissored - self.discarded;
        let after_stencil = drawn - self.stencil_failed;
        let written = drawn - self.failed;
        let mut set = |stage: Stage, came: u64, went: u64, on: bool| {
            let count = stats.stage_mut(stage);
            (count.came, count.went, count.on) = (came, went, on);
        };
        set(Stage::ScanConversion, self.pieces, self.spans, true);
        set(Stage::Fragments, self.spans, drawn, true);
        set(Stage::Stencil, drawn, after_stencil, any(|state| state.stencil.is_some()));
        set(Stage::Depth, after_stencil, written, any(|state| state.depth.test));
        set(Stage::Blend, written, written, any(|state| state.blend.is_some()));
        set(Stage::Image, written, written - self.redrawn, true);
        stats.stage_mut(Stage::Fragments).drop(Reason::Carried, self.carried);
        stats.stage_mut(Stage::Fragments).drop(Reason::Scissor, self.scissored);
        stats.stage_mut(Stage::Fragments).drop(Reason::Discarded, self.discarded);
        stats.stage_mut(Stage::Stencil).drop(Reason::Stencil, self.stencil_failed);
        stats.stage_mut(Stage::Depth).drop(Reason::Depth, self.failed - self.stencil_failed);
        stats.stage_mut(Stage::Image).drop(Reason::Redrawn, self.redrawn);
        stats.skip(Skip::Row, self.row_skipped);
        stats.skip(Skip::EarlyZ, self.never_colored);
        stats.tally += self.tally;
    }
}
