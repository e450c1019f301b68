//! Claims about pixels and their depths.

use rasterscope_core::{
    depth::{
        DepthFormat, DepthPlane, DepthRows,
        z_buffer::{self, Triangle},
    },
    math::{Arithmetic, Tally},
    raster::{Algorithm, Counts, Settings, Span, cover, rows},
    stress::Random,
};
use std::hint::black_box;

use super::{Finding, Series, Verdict};
use crate::Stopwatch;

const SIDE: u32 = 256;

/// Right-angled triangles with legs of this length, anywhere in the image, with any depth.
fn triangles(count: usize, leg: f64, random: &mut Random) -> Vec<Triangle> {
    let side = f64::from(SIDE);
    let room = (side - leg).max(0.0);
    (0..count)
        .map(|_| {
            let [x, y] = [random.uniform(0.0, room), random.uniform(0.0, room)];
            let [a, b, c] = std::array::from_fn(|_| random.uniform(0.0, 1.0));
            [[x, y, a], [x + leg as f32, y, b], [x, y + leg as f32, c]]
        })
        .collect()
}

fn flat(triangle: &Triangle) -> [[f32; 2]; 3] {
    triangle.map(|[x, y, _]| [x, y])
}

/// The cost of a z-buffer is nearly constant as primitives grow in number and shrink in size.
pub(super) fn z_buffer_constant(stopwatch: &Stopwatch<'_>) -> Finding {
    let counts = [16, 64, 256, 1_024, 4_096];
    let settings = z_buffer::Settings::new([SIDE; 2]);
    // Together they always cover the image four times.
    let area = 4.0 * f64::from(SIDE * SIDE);
    let mut random = Random::new(3);
    let measured = counts.map(|count| {
        let triangles = triangles(count, (2.0 * area / count as f64).sqrt(), &mut random);
        let [time] = stopwatch.times([&mut || drop(black_box(z_buffer::draw(&triangles, &settings)))]);
        time * 1e-6
    });
    let verdict = Verdict::of(measured.map(|time| time < 2.0 * measured[0]));
    Finding {
        series: vec![Series::timed(
            "frame-ms-by-triangles",
            counts.map(|count| count as f64).into_iter().zip(measured),
        )],
        verdict,
    }
}

const LEGS: [f64; 4] = [4.0, 16.0, 64.0, 240.0];

/// Testing regions first saves tests of pixels.
pub(super) fn regions_save_tests(_: &Stopwatch<'_>) -> Finding {
    let mut random = Random::new(4);
    let per_pixel = LEGS.map(|leg| {
        let triangles = triangles(64, leg, &mut random);
        [Algorithm::Aabb, Algorithm::Tiled].map(|algorithm| {
            let mut counts = Counts::default();
            for triangle in &triangles {
                let settings = Settings::new([SIDE; 2]);
                counts += cover(algorithm, flat(triangle), &settings, &mut Tally::default(), &mut |_| {});
            }
            counts.tested as f64 / counts.covered.max(1) as f64
        })
    });
    let series =
        |name, which: usize| Series::counted(name, LEGS.into_iter().zip(per_pixel.map(|both| both[which])));
    let verdict = Verdict::of(per_pixel.map(|[boxes, tiles]| tiles < boxes));
    Finding { series: vec![series("tests-by-box", 0), series("tests-by-tiles", 1)], verdict }
}

/// Fixed point of 16 bits, 8 of them below the point, is enough: pixels in a million that change.
pub(super) fn fixed_point_is_enough(_: &Stopwatch<'_>) -> Finding {
    let mut random = Random::new(5);
    let changed = LEGS.map(|leg| {
        let (mut covered, mut changed) = (0, 0);
        for triangle in triangles(256, leg, &mut random) {
            let [exact, fixed] = [Arithmetic::Exact, Arithmetic::Fixed8].map(|arithmetic| {
                let settings = Settings { arithmetic, ..Settings::new([SIDE; 2]) };
                let mut image = vec![false; (SIDE * SIDE) as usize];
                for Span { y, begin, end } in
                    rows(Algorithm::Scanline, flat(&triangle), &settings, &mut Tally::default())
                {
                    image[(y * SIDE + begin) as usize..(y * SIDE + end) as usize].fill(true);
                }
                image
            });
            covered += exact.iter().filter(|pixel| **pixel).count();
            changed += exact.iter().zip(&fixed).filter(|(a, b)| a != b).count();
        }
        1e6 * changed as f64 / covered.max(1) as f64
    });
    let verdict = Verdict::of(changed.map(|share| share < 1e3));
    Finding { series: vec![Series::counted("changed-per-million", LEGS.into_iter().zip(changed))], verdict }
}

/// Incremental additions make a pixel cheap: slopes added from row to row against edge functions.
pub(super) fn additions_are_cheap(stopwatch: &Stopwatch<'_>) -> Finding {
    let mut random = Random::new(6);
    let measured = LEGS.map(|leg| {
        let triangles = triangles(64, leg, &mut random);
        let settings = Settings { arithmetic: Arithmetic::F32, ..Settings::new([SIDE; 2]) };
        let run = |algorithm| {
            let mut covered = 0;
            for triangle in &triangles {
                let mut count = |span: Span| covered += u64::from(black_box(span).len());
                cover(algorithm, flat(triangle), &settings, &mut Tally::default(), &mut count);
            }
            covered
        };
        let pixels = run(Algorithm::Scanline).max(1) as f64;
        let times = stopwatch.times([
            &mut || {
                black_box(run(Algorithm::Scanline));
            },
            &mut || {
                black_box(run(Algorithm::Aabb));
            },
        ]);
        times.map(|time| time / pixels)
    });
    let series =
        |name, which: usize| Series::timed(name, LEGS.into_iter().zip(measured.map(|both| both[which])));
    let verdict = Verdict::of(measured.map(|[slopes, edges]| slopes < edges));
    Finding { series: vec![series("pixel-ns-by-slopes", 0), series("pixel-ns-by-edges", 1)], verdict }
}

/// Coherence along a row saves depth work: what all its pixels share is computed once.
pub(super) fn row_coherence(stopwatch: &Stopwatch<'_>) -> Finding {
    let mut random = Random::new(7);
    let measured = LEGS.map(|leg| {
        let triangles: Vec<_> = triangles(32, leg, &mut random)
            .into_iter()
            .map(|triangle| {
                let settings = Settings::new([SIDE; 2]);
                (triangle, rows(Algorithm::Scanline, flat(&triangle), &settings, &mut Tally::default()))
            })
            .collect();
        let pixels =
            triangles.iter().flat_map(|(_, spans)| spans).map(|span| f64::from(span.len())).sum::<f64>();
        let times = stopwatch.times([
            &mut || {
                for (triangle, spans) in &triangles {
                    let rows = DepthRows::new(*triangle, DepthFormat::F32, &mut Tally::default());
                    for span in spans {
                        let row = rows.row(span.y);
                        (span.begin..span.end).for_each(|x| {
                            black_box(row.code(x, &mut Tally::default()));
                        });
                    }
                }
            },
            &mut || {
                for (triangle, spans) in &triangles {
                    let plane = DepthPlane::new(*triangle, Arithmetic::Exact, &mut Tally::default());
                    for span in spans {
                        (span.begin..span.end).for_each(|x| {
                            black_box(plane.depth([x, span.y], &mut Tally::default()));
                        });
                    }
                }
            },
        ]);
        times.map(|time| time / pixels.max(1.0))
    });
    let series =
        |name, which: usize| Series::timed(name, LEGS.into_iter().zip(measured.map(|both| both[which])));
    let verdict = Verdict::of(measured.map(|[rows, pixels]| rows < pixels));
    Finding { series: vec![series("depth-ns-by-rows", 0), series("depth-ns-by-pixels", 1)], verdict }
}
