//! Claims about interpolating attributes.

use rasterscope_core::{
    explain::{Explain, Operations},
    interpolate::{
        Mode, Subject,
        plane_equation::{Event, Snapshot, fill_row_traced},
    },
    math::{Arithmetic, Tally},
    raster::Settings,
    trace::NoTrace,
};
use std::hint::black_box;

use super::{Finding, Series, Verdict};
use crate::Stopwatch;

/// A row of this many pixels, and its triangle.
const WIDTH: u32 = 1_024;

fn subject() -> Subject {
    let width = WIDTH as f32;
    let vertices = [[0.0, 0.0, 1.0], [2.0 * width, 1.0, 2.0], [0.0, 2.0, 5.0]];
    Subject { vertices, attribute: [0.0, 1.0, 0.25], at: [0.5, 0.5] }
}

/// Perspective correction costs one division for each pixel: planes of a/w and 1/w, against a plane of a.
pub(super) fn one_division(stopwatch: &Stopwatch<'_>) -> Finding {
    let subject = &subject();
    let settings = &Settings::new([WIDTH, 2]);
    let modes = [Mode::Affine, Mode::Perspective];
    let divisions = modes.map(|mode| {
        let mut events: Vec<Event> = Vec::new();
        let tally = &mut Tally::default();
        let pixels = fill_row_traced(mode, subject, Arithmetic::F64, settings, tally, &mut events);
        // What the row's set-up divides is no pixel's.
        let of_pixels = |event: &&Event| matches!(event, Event::Step { .. } | Event::Value { .. });
        let cost = |event: &Event| Snapshot::operations(event);
        let all = events.iter().filter(of_pixels).map(cost).fold(Operations::NONE, |all, one| all + one);
        all.divisions as f64 / pixels.len().max(1) as f64
    });
    let run = |mode| {
        let tally = &mut Tally::default();
        black_box(fill_row_traced(mode, subject, Arithmetic::F64, settings, tally, &mut NoTrace));
    };
    let times = stopwatch.times([&mut || run(modes[0]), &mut || run(modes[1])]);
    let names = modes.map(Mode::name);
    let times = times.map(|time| time / f64::from(WIDTH));
    let verdict = if divisions == [0.0, 1.0] { Verdict::Holds } else { Verdict::DoesNotHold };
    Finding {
        series: vec![
            Series::counted("divisions-a-pixel", names.into_iter().zip(divisions)),
            Series::timed("pixel-ns-by-mode", names.into_iter().zip(times)),
        ],
        verdict,
    }
}
