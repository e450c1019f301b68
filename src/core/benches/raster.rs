//! What exactness costs in scan conversion: each algorithm in three arithmetics, its wrong pixels, and how
//! often binary64 did not decide. Run with `cargo bench -p rasterscope-core --bench raster`.
//!
//! The exact pixels of all algorithms are held against each other; those of the rounded arithmetics are
//! counted where they differ, per million ends of exact spans: the pixels that an edge decides about.

mod support;

use rasterscope_core::{
    math::{Arithmetic, Tally},
    raster::{Algorithm, Settings, Span, cover, rows},
};
use std::hint::black_box;
use support::{ARITHMETICS, Random, Row, race};

type Triangle = [[f32; 2]; 3];

const SIZE: [u32; 2] = [1024, 1024];

/// Triangles with edges of about so many pixels, all over the image.
fn soup(edge: f32, count: usize) -> Vec<Triangle> {
    let mut random = Random(edge.to_bits().into());
    (0..count)
        .map(|_| {
            let middle = [0; 2].map(|_| random.uniform(edge, 1024.0 - edge));
            [0; 3].map(|_| middle.map(|at| at + random.uniform(-edge, edge)))
        })
        .collect()
}

/// Corners on or one ULP beside pixel centres: ties and almost ties.
fn almost_ties(count: usize) -> Vec<Triangle> {
    let mut random = Random(7);
    let mut coordinate = move |low: f32| {
        let centre = low + random.uniform(0.0, 30.0).floor() + 0.5;
        match random.uniform(0.0, 4.0) as u32 {
            0 => centre.next_up(),
            1 => centre.next_down(),
            _ => centre,
        }
    };
    let place = |i: usize| [(i * 37 % 980) as f32, (i * 101 % 980) as f32];
    (0..count).map(|i| [0; 3].map(|_| place(i).map(&mut coordinate))).collect()
}

/// The exact rows of each triangle: the same from every algorithm.
fn exact(triangles: &[Triangle]) -> Vec<Vec<Span>> {
    let settings = Settings::new(SIZE);
    let of = |&triangle: &Triangle| {
        let answers = Algorithm::ALL.map(|each| rows(each, triangle, &settings, &mut Tally::default()));
        assert!(answers.iter().all(|answer| *answer == answers[0]), "the algorithms differ: {triangle:?}");
        answers[0].clone()
    };
    triangles.iter().map(of).collect()
}

/// How many pixels two lists of rows do not share.
fn differing(a: &[Span], b: &[Span]) -> u64 {
    let pixels = |spans: &[Span]| -> u64 { spans.iter().map(|span| u64::from(span.len())).sum() };
    let shared: u64 = a
        .iter()
        .filter_map(|s| {
            let other = &b[b.binary_search_by_key(&s.y, |other| other.y).ok()?];
            Some(u64::from(s.end.min(other.end).saturating_sub(s.begin.max(other.begin))))
        })
        .sum();
    pixels(a) + pixels(b) - 2 * shared
}

fn main() {
    let soups = [
        ("edge 3".to_owned(), soup(3.0, 8_000)),
        ("edge 30".to_owned(), soup(30.0, 1_000)),
        ("edge 300".to_owned(), soup(300.0, 20)),
        ("almost ties".to_owned(), almost_ties(1_000)),
    ];
    let mut table = Vec::new();
    for (name, triangles) in &soups {
        let exact = exact(triangles);
        let ends: usize = exact.iter().map(|rows| 2 * rows.len()).sum();
        for algorithm in Algorithm::ALL {
            for arithmetic in ARITHMETICS {
                let settings = Settings { arithmetic, ..Settings::new(SIZE) };
                let answer = |triangle| rows(algorithm, triangle, &settings, &mut Tally::default());
                let wrong: u64 =
                    triangles.iter().zip(&exact).map(|(t, exact)| differing(&answer(*t), exact)).sum();
                assert!(arithmetic != Arithmetic::Exact || wrong == 0, "{algorithm:?} differs");
                let run = move |tally: &mut Tally| {
                    for &triangle in triangles {
                        black_box(cover(algorithm, triangle, &settings, tally, &mut |span| {
                            black_box(span);
                        }));
                    }
                };
                table.push(Row {
                    name: format!("{name}, {}", algorithm.name()),
                    arithmetic,
                    run: Box::new(run),
                    items: triangles.len(),
                    wrong: Some((wrong as f64 * 1e6 / ends as f64).round()),
                });
            }
        }
    }
    race("a triangle", "wrong ppm", &table);
}
