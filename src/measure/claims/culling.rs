//! Claims about culling.

use rasterscope_core::{
    pipeline::{self, Reason, Skip, Skips},
    scene::{MODEL_SIZE, MODELS, Mesh, Scene, scene_from_obj},
    stage::Stage,
};
use std::hint::black_box;

use super::{Finding, Series, Verdict};
use crate::Stopwatch;

/// The models that are built in, all closed, in the view in which they open.
fn scenes() -> Vec<(&'static str, Scene)> {
    let scene = |(name, bytes): &(&'static str, &'static [u8])| {
        let mesh = Mesh::from_obj(bytes).ok()?;
        Some((*name, scene_from_obj(name, mesh, MODEL_SIZE)))
    };
    MODELS.iter().filter_map(scene).collect()
}

/// Back-face culling removes about half.
pub(super) fn removes_half(_: &Stopwatch<'_>) -> Finding {
    let share = |(name, scene): &(&'static str, Scene)| {
        let stats = pipeline::render(scene, &Skips::ALL).stats;
        let cull = stats.stage(Stage::Cull);
        (*name, cull.dropped(Reason::BackFace) as f64 / cull.came.max(1) as f64)
    };
    let shares: Vec<_> = scenes().iter().map(share).collect();
    let verdict = Verdict::of(shares.iter().map(|(_, share)| (0.4..=0.6).contains(share)));
    Finding { series: vec![Series::counted("back-facing-share", shares)], verdict }
}

/// It pays to cull before clipping: the same image, and the facing looked at before or after.
pub(super) fn before_clipping(stopwatch: &Stopwatch<'_>) -> Finding {
    let mut ratios = Vec::new();
    for (name, scene) in scenes() {
        let [before, after] =
            stopwatch.times([&mut || drop(black_box(pipeline::render(&scene, &Skips::ALL))), &mut || {
                drop(black_box(pipeline::render(&scene, &Skips::ALL.with(Skip::BackFace, false))));
            }]);
        ratios.push((name, after / before));
    }
    let verdict = Verdict::of(ratios.iter().map(|(_, ratio)| *ratio > 1.02));
    Finding { series: vec![Series::timed("late-by-early", ratios)], verdict }
}
