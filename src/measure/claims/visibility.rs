//! Claims about finding out what is seen.

use rasterscope_core::{
    depth::z_buffer,
    stress::Random,
    visibility::{object_pairs, rays},
};
use std::hint::black_box;

use super::{Finding, Series, Verdict};
use crate::Stopwatch;

const SIDE: u32 = 64;
/// Small enough that most pairs are apart, however many there are.
const LEG: f32 = 6.0;
/// Each is four times as many as the one before.
const COUNTS: [usize; 4] = [8, 32, 128, 512];

fn soup(count: usize) -> Vec<object_pairs::Triangle> {
    let mut random = Random::new(8);
    let room = f64::from(SIDE) - f64::from(LEG);
    let triangle = |_| {
        let [x, y, z] = [random.uniform(0.0, room), random.uniform(0.0, room), random.uniform(0.1, 0.9)];
        [[x, y, z], [x + LEG, y, z], [x, y + LEG, z]]
    };
    (0..count).map(triangle).collect()
}

/// Object space costs the square of the number of triangles, image space is proportional to it.
pub(super) fn object_space_quadratic(stopwatch: &Stopwatch<'_>) -> Finding {
    let settings = z_buffer::Settings::new([SIDE; 2]);
    let mut counted = [[0.0; COUNTS.len()]; 2];
    let measured: Vec<[f64; 3]> = COUNTS
        .iter()
        .enumerate()
        .map(|(i, count)| {
            let triangles = soup(*count);
            counted[0][i] = object_pairs::visible_parts(&triangles).1.pairs() as f64;
            counted[1][i] = rays::nearest(&triangles, [SIDE; 2]).intersections as f64;
            let times = stopwatch.times([
                &mut || drop(black_box(object_pairs::visible_parts(&triangles))),
                &mut || drop(black_box(rays::nearest(&triangles, [SIDE; 2]))),
                &mut || drop(black_box(z_buffer::draw(&triangles, &settings))),
            ]);
            times.map(|time| time * 1e-6)
        })
        .collect();
    let at = || COUNTS.map(|count| count as f64).into_iter();
    let times = |which: usize| measured.iter().map(move |times| times[which]);
    // Four times as many triangles: sixteen times the cost, or four times.
    let [before, last] = [measured[COUNTS.len() - 2], measured[COUNTS.len() - 1]];
    let grows = |which: usize| last[which] / before[which];
    let verdict = Verdict::of([grows(0) > 8.0, grows(1) < 8.0, grows(2) < 8.0]);
    let series = vec![
        Series::timed("frame-ms-by-pairs", at().zip(times(0))),
        Series::timed("frame-ms-by-rays", at().zip(times(1))),
        Series::timed("frame-ms-by-z-buffer", at().zip(times(2))),
        Series::counted("pairs", at().zip(counted[0])),
        Series::counted("intersections", at().zip(counted[1])),
    ];
    Finding { series, verdict }
}
