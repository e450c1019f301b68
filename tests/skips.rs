//! What each skip saves: counts that add up, a clock that is injected, and the proof that nothing changed.

use crate::presets::scene;
use rasterscope_cli::bench::skips::{SkipsOptions, skips};
use rasterscope_core::{
    pipeline::{Pipeline, Skip, Skips, render},
    raster::Algorithm,
    stage::Stage,
};
use rasterscope_measure::{
    Stopwatch,
    skips::{Savings, Setting},
};
use serde_json::Value;
use std::cell::Cell;

/// Measures with a clock that ticks once a look; stops after some runs.
fn measured(name: &str, make: &dyn Fn() -> Pipeline, most: usize) -> Option<Savings> {
    let (ticks, runs) = (Cell::new(0.0), Cell::new(0));
    let now = || {
        ticks.set(ticks.get() + 1.0);
        ticks.get()
    };
    let wanted = || {
        runs.set(runs.get() + 1);
        runs.get() <= most
    };
    Savings::measure(&scene(name), make, &Stopwatch { rounds: 1, now: &now, wanted: &wanted })
}

#[test]
fn no_skip_changes_a_byte_by_either_rasterizer() {
    for name in ["two-through-each-other", "cube", "stencil-mask", "order-of-blending", "near-plane"] {
        for make in [Pipeline::default, || Pipeline::new(Algorithm::Scanline)] {
            let savings = measured(name, &make, usize::MAX).expect("nobody stops it");
            assert!(savings.is_proved(), "{name}");
            assert_eq!(savings.costs.len(), Skip::ALL.len() + 2);
            assert!(savings.costs.iter().all(|cost| cost.ns == [1e9; 2]), "a tick for each part");
            assert_eq!(savings.ratio(), 1.0);
        }
    }
}

#[test]
fn what_is_done_and_left_out_is_what_the_pipeline_counts() {
    let savings = measured("cube", &Pipeline::default, usize::MAX).expect("nobody stops it");
    let stats = render(&scene("cube"), &Skips::ALL).stats;
    for saving in savings.savings().filter(|saving| !matches!(saving.skip, Skip::Clear | Skip::Memo)) {
        assert_eq!(saving.work.left_out, stats.skipped(saving.skip), "{:?}", saving.skip);
    }
    let back = savings.savings().find(|saving| saving.skip == Skip::BackFace).expect("it is a skip");
    assert_eq!(back.work.done.map(|done| done + back.work.left_out), Some(stats.stage(Stage::Scene).went));
    assert!(back.work.left_out > 0, "half of a cube faces away");
    // The frame before was seen from beside: only the way to world space is kept.
    let memo = savings.savings().find(|saving| saving.skip == Skip::Memo).expect("it is a skip");
    assert!(memo.work.left_out > 0 && memo.work.done > Some(0));
}

#[test]
fn without_skips_no_stage_has_less_to_do() {
    for name in ["cube", "two-through-each-other", "spheres"] {
        let savings = measured(name, &Pipeline::default, usize::MAX).expect("nobody stops it");
        let loads = savings.loads();
        assert!(loads.iter().all(|load| load.with <= load.without), "{name}: {loads:?}");
        assert!(loads.iter().any(|load| load.with < load.without), "{name}: {loads:?}");
    }
}

#[test]
fn a_measurement_can_be_stopped_and_its_progress_is_known() {
    assert!(measured("cube", &Pipeline::default, 5).is_none());
    let all = Savings::runs(1);
    assert_eq!(all, 2 * Setting::all().len());
    assert!(measured("cube", &Pipeline::default, all + 1).is_some());
}

#[test]
fn the_command_line_prints_the_same_numbers() {
    let printed = |json| {
        let mut out = Vec::new();
        let options = SkipsOptions { file: Some("cube".into()), json, rounds: 1 };
        skips(&options, &mut out, None).expect("it is measured");
        String::from_utf8(out).expect("text")
    };
    let lines: Vec<Value> =
        printed(true).lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let of = |field: &str| lines.iter().filter(move |line| line.get(field).is_some()).count();
    assert_eq!((of("skip"), of("setting"), of("machine")), (Skip::ALL.len(), Skip::ALL.len() + 2, 1));
    assert_eq!(lines.last().and_then(|line| line["proof"].as_bool()), Some(true));
    let text = printed(false);
    for part in ["back-face", "same bytes", "With all skips a frame takes", "byte for byte"] {
        assert!(text.contains(part), "{part} in {text}");
    }
}
