//! How much of a kind of work was done, and how much a skip left out of it.

use super::{DrawRuns, Skip, Stats};
use crate::stage::Stage;

/// Work of one kind in one image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Work {
    /// What was done all the same; `None` where nobody counts what is done.
    pub done: Option<u64>,
    /// What the skip left out.
    pub left_out: u64,
    /// Message id of what is counted.
    pub unit: &'static str,
}

impl Stats {
    /// The work that a skip leaves out, of an image of some pixels and draws.
    ///
    /// Without the skip nothing is left out, and all of it is done.
    pub fn work(&self, skip: Skip, pixels: u64, draws: u64) -> Work {
        let left_out = self.skipped(skip);
        let fragments = self.stage(Stage::Fragments).went;
        let (all, unit) = match skip {
            Skip::ObjectFrustum | Skip::Frustum | Skip::BackFace | Skip::Degenerate => {
                (Some(self.stage(Stage::Scene).went), "pipeline-work-triangles")
            }
            Skip::Row => (Some(fragments + left_out), "pipeline-work-pixels"),
            Skip::EarlyZ => (Some(fragments), "pipeline-work-colors"),
            Skip::Clear => (Some(pixels), "pipeline-work-cleared"),
            Skip::Memo => (Some(DrawRuns::STAGES as u64 * draws + 1), "pipeline-work-stages"),
            Skip::Deferred => (Some(self.stage(Stage::Image).came), "pipeline-work-colors"),
            Skip::Tile | Skip::HierarchicalZ => (None, "pipeline-work-tiles"),
        };
        Work { done: all.map(|all| all.saturating_sub(left_out)), left_out, unit }
    }
}
