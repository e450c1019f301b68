//! Claims about clipping lines.

use rasterscope_core::{
    clip::line::{
        Mistakes, Segment, Window, cohen_sutherland,
        liang_barsky::{self, Event},
    },
    math::{Arithmetic, Tally},
    stress::Random,
    trace::NoTrace,
};
use std::hint::black_box;

use super::{Finding, Series, Verdict};
use crate::Stopwatch;

const COUNT: usize = 4_096;
const SIDES: [f32; 4] = [-3.1, -2.2, 4.7, 3.3];

fn window() -> Window {
    let [xmin, ymin, xmax, ymax] = SIDES;
    Window { xmin, ymin, xmax, ymax }
}

/// Segments with ends anywhere around the window of which this share is beyond one border.
fn segments(outside: f64, window: &Window, random: &mut Random) -> Vec<Segment> {
    let [xmin, ymin, xmax, ymax] = SIDES.map(f64::from);
    let point = |random: &mut Random| {
        [
            random.uniform(2.0 * xmin - xmax, 2.0 * xmax - xmin),
            random.uniform(2.0 * ymin - ymax, 2.0 * ymax - ymin),
        ]
    };
    let mut wanted = [(COUNT as f64 * outside) as usize; 2];
    wanted[0] = COUNT - wanted[1];
    let mut segments = Vec::with_capacity(COUNT);
    while segments.len() < COUNT {
        let segment = [point(random), point(random)];
        let is_outside = usize::from(cohen_sutherland::clip(segment, window).is_none());
        if wanted[is_outside] > 0 {
            wanted[is_outside] -= 1;
            segments.push(segment);
        }
    }
    segments
}

/// Cohen-Sutherland is efficient when most lines are outside: against Liang-Barsky, both as taught.
pub(super) fn outcodes_when_outside(stopwatch: &Stopwatch<'_>) -> Finding {
    let shares = [0.0, 25.0, 50.0, 75.0, 100.0];
    let window = window();
    let mut random = Random::new(1);
    let measured: Vec<[f64; 2]> = shares
        .iter()
        .map(|share| {
            let segments = segments(share / 100.0, &window, &mut random);
            stopwatch.times([
                &mut || {
                    for s in &segments {
                        black_box(cohen_sutherland::clip_taught::<f64, _>(
                            *s,
                            &window,
                            Mistakes::NONE,
                            &mut NoTrace,
                        ));
                    }
                },
                &mut || {
                    for s in &segments {
                        black_box(liang_barsky::clip_taught::<f64, _>(*s, &window, &mut NoTrace));
                    }
                },
            ])
        })
        .collect();
    let series = |name, which: usize| {
        let each = measured.iter().map(|times| times[which] / COUNT as f64);
        Series::timed(name, shares.into_iter().zip(each))
    };
    let verdict = Verdict::of(measured[3..].iter().map(|[outcodes, parameters]| outcodes < parameters));
    Finding { series: vec![series("cohen-sutherland", 0), series("liang-barsky", 1)], verdict }
}

/// Liang-Barsky decides without divisions.
pub(super) fn no_division_to_decide(_: &Stopwatch<'_>) -> Finding {
    let window = window();
    let mut random = Random::new(2);
    let mut lines = [0_u32; 3];
    let mut divisions = [0_u32; 3];
    for segment in segments(0.5, &window, &mut random) {
        let mut events = Vec::new();
        let visible = liang_barsky::clip_traced(
            segment,
            &window,
            Arithmetic::Exact,
            &mut Tally::default(),
            &mut events,
        );
        let count = |wanted: fn(&Event) -> bool| events.iter().filter(|event| wanted(event)).count();
        let cuts = count(|event| matches!(event, Event::Cut { .. }));
        let kind = if visible.is_some() { cuts } else { 0 };
        lines[kind] += 1;
        divisions[kind] += count(|event| matches!(event, Event::Divide { .. })) as u32;
    }
    let per_line = [(0, "0"), (1, "1"), (2, "2")]
        .map(|(cuts, name)| (name, f64::from(divisions[cuts]) / f64::from(lines[cuts].max(1))));
    let verdict = if divisions[0] == 0 { Verdict::Holds } else { Verdict::DoesNotHold };
    Finding { series: vec![Series::counted("divisions-by-cuts", per_line)], verdict }
}
