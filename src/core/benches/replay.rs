//! What stepping costs: recording a run, and seeking in it. Run with
//! `cargo bench -p rasterscope-core --bench replay`.
//!
//! The rows take turns, so that a busy moment of the machine hits them all; each seek is checked
//! against the event count that the state must have seen.
#![expect(clippy::print_stdout, reason = "it prints a table")]

use rasterscope_core::{
    depth::z_buffer::{self, Triangle},
    math::Tally,
    raster::{Settings, scanline},
    replay::{Budget, Playback},
    trace::{NoTrace, Tracer},
};
use std::{hint::black_box, time::Instant};

const ROUNDS: usize = 400;

/// A run, and its name.
type Row = (&'static str, Box<dyn Playback>, Box<dyn Fn() -> usize>);

fn budgets() -> [(&'static str, Budget); 2] {
    [
        ("whole trace in memory", Budget::default()),
        ("4096 events", Budget { events: 4096, ..Budget::default() }),
    ]
}

fn main() {
    let scan = [[3.2, 1.1], [700.7, 260.3], [80.5, 700.9]];
    let depth: Vec<Triangle> = vec![
        [[5.3, 2.7, 0.2], [395.1, 150.4, 0.9], [60.2, 295.5, 0.5]],
        [[380.4, 10.2, 0.1], [20.9, 120.7, 0.8], [300.1, 290.3, 0.6]],
    ];
    let settings = Settings::new([720, 720]);
    let z_settings = z_buffer::Settings::new([400, 300]);

    record(
        "scan line",
        || scanline_with(scan, &settings, &mut NoTrace),
        |log| {
            scanline_with(scan, &settings, log);
        },
    );

    println!(
        "\n{:<46} {:>9} {:>10} {:>9} {:>9} {:>9}",
        "seek, ms", "events", "KiB", "median", "99 %", "worst"
    );
    let mut rows: Vec<Row> = Vec::new();
    for (name, budget) in budgets() {
        let player = scanline::play(scan, settings, budget);
        let memory = player.memory();
        rows.push((name, Box::new(player), Box::new(move || memory)));
        let player = z_buffer::play(depth.clone(), Vec::new(), z_settings, budget);
        let memory = player.memory();
        rows.push((name, Box::new(player), Box::new(move || memory)));
    }
    let mut times = vec![Vec::with_capacity(ROUNDS); rows.len()];
    for round in 0..ROUNDS {
        for ((_, player, _), times) in rows.iter_mut().zip(&mut times) {
            let step = round * 7919 * 31 % (player.len() + 1);
            let start = Instant::now();
            player.seek(step);
            times.push(start.elapsed().as_secs_f64() * 1e3);
            assert_eq!(player.cursor(), step);
            assert_eq!(player.line().is_some(), step > 0);
        }
    }
    for ((name, player, memory), mut times) in rows.into_iter().zip(times) {
        times.sort_unstable_by(f64::total_cmp);
        let at = |part: f64| times[((times.len() - 1) as f64 * part) as usize];
        let row = format!("{}, {name}", player.name());
        let (len, kib) = (player.len(), memory() / 1024);
        println!("{row:<46} {len:>9} {kib:>10} {:>9.4} {:>9.4} {:>9.4}", at(0.5), at(0.99), at(1.0));
    }
}

fn scanline_with<T: Tracer<scanline::Event>>(triangle: [[f32; 2]; 3], settings: &Settings, t: &mut T) -> u64 {
    let mut pixels = 0;
    let tally = &mut Tally::default();
    scanline::fill_traced(triangle, settings, tally, t, &mut |span| pixels += u64::from(span.len()));
    pixels
}

/// What a traced run costs beside the untraced one.
fn record(name: &str, fast: impl Fn() -> u64, traced: impl Fn(&mut Vec<scanline::Event>)) {
    let mut best = [f64::INFINITY; 2];
    let (mut pixels, mut log) = (0, Vec::new());
    for _ in 0..ROUNDS {
        let start = Instant::now();
        pixels = black_box(fast());
        best[0] = best[0].min(start.elapsed().as_secs_f64());
        log.clear();
        let start = Instant::now();
        traced(&mut log);
        best[1] = best[1].min(start.elapsed().as_secs_f64());
    }
    let events = log.len();
    assert!(events as u64 > pixels, "each pixel is an event");
    let [fast, each] = [best[0] * 1e6, best[1] * 1e9 / events as f64];
    println!(
        "{name}: {pixels} pixels in {fast:.1} us untraced; recorded, {each:.1} ns for each of {events} events"
    );
}
