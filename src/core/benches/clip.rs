//! What exactness costs in clipping: each algorithm in three arithmetics, its wrong answers, and how often
//! binary64 did not decide. Run with `cargo bench -p rasterscope-core --bench clip`.
//!
//! Each exact answer is held
//! against that of another algorithm and that of the reversed input, bit for bit; the rounded ones are
//! counted where they differ from it. `tests/peers` compares with other crates.
mod support;

use rasterscope_core::{
    clip::{
        line::{self, Segment, Window, cohen_sutherland, liang_barsky},
        polygon::sutherland_hodgman,
    },
    math::{Arithmetic, Tally},
    trace::NoTrace,
};
use std::hint::black_box;
use support::{ARITHMETICS, Random, Row, race};

const SEGMENTS: usize = 8_192;
const WINDOW: [f32; 4] = [-3.1, -2.2, 4.7, 3.3];

impl Random {
    fn point(&mut self, margin: f32) -> [f32; 2] {
        let [xmin, ymin, xmax, ymax] = WINDOW;
        [(xmin, xmax), (ymin, ymax)].map(|(min, max)| {
            let room = margin * (max - min);
            self.uniform(min - room, max + room)
        })
    }

    /// Past the upper left corner, but for rounding through it.
    fn past_a_corner(&mut self) -> Segment {
        let [xmin, _, _, ymax] = WINDOW;
        let (d, slope) = (self.uniform(0.5, 4.0), self.uniform(0.2, 5.0));
        let back = self.uniform(0.3, 3.0);
        [[xmin + d, ymax + d * slope], [xmin - back * d, ymax - back * (d * slope)]]
    }
}

/// The mixes, each with its name.
fn mixes(window: &Window) -> [(&'static str, Vec<Segment>); 4] {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let mut choose = |mut make: Box<dyn FnMut(&mut Random) -> Segment>, wanted: fn(Option<bool>) -> bool| {
        let mut chosen = Vec::new();
        while chosen.len() < SEGMENTS {
            let segment = make(&mut random);
            if wanted(cohen_sutherland::clip(segment, window).map(|part| part != segment)) {
                chosen.push(segment);
            }
        }
        chosen
    };
    let around = |random: &mut Random| [random.point(1.0), random.point(1.0)];
    [
        ("inside", choose(Box::new(|random| [random.point(0.0), random.point(0.0)]), |cut| cut.is_some())),
        ("outside", choose(Box::new(around), |cut| cut.is_none())),
        ("crossing", choose(Box::new(around), |cut| cut == Some(true))),
        ("grazing", choose(Box::new(Random::past_a_corner), |_| true)),
    ]
}

/// A clipper in any arithmetic.
type Clip = fn(Segment, &Window, Arithmetic, &mut Tally) -> Option<Segment>;

const CLIPPERS: [(&str, Clip); 3] = [
    ("at once", |segment, window, _, _| line::clip(segment, window)),
    ("Cohen-Sutherland", |segment, window, arithmetic, tally| {
        cohen_sutherland::clip_traced(segment, window, arithmetic, tally, &mut NoTrace)
    }),
    ("Liang-Barsky", |segment, window, arithmetic, tally| {
        liang_barsky::clip_traced(segment, window, arithmetic, tally, &mut NoTrace).map(|part| part.segment)
    }),
];

fn lines<'a>(window: &'a Window, mixes: &'a [(&'static str, Vec<Segment>); 4]) -> Vec<Row<'a>> {
    let mut rows = Vec::new();
    for (mix, segments) in mixes {
        for (name, clip) in CLIPPERS {
            // What decides at once has no taught form.
            let arithmetics = if name == "at once" { &ARITHMETICS[..1] } else { &ARITHMETICS };
            for &arithmetic in arithmetics {
                let wrong = segments.iter().filter(|&&[p, q]| {
                    let exact = line::clip([p, q], window);
                    let reversed = line::clip([q, p], window).map(|[q, p]| [p, q]);
                    assert_eq!(exact, reversed, "the order of the ends matters");
                    clip([p, q], window, arithmetic, &mut Tally::default()) != exact
                });
                let wrong = wrong.count();
                assert!(arithmetic != Arithmetic::Exact || wrong == 0, "{name} differs");
                let run = move |tally: &mut Tally| {
                    for segment in segments {
                        black_box(clip(*segment, window, arithmetic, tally));
                    }
                };
                let (name, run) = (format!("{mix}, {name}"), Box::new(run));
                rows.push(Row { name, arithmetic, run, items: SEGMENTS, wrong: Some(wrong as f64) });
            }
        }
    }
    rows
}

/// Polygons of so many corners around the window's edge.
fn polygons(corners: usize) -> Vec<Vec<[f32; 2]>> {
    let mut random = Random(corners as u64);
    (0..SEGMENTS / 4 / corners)
        .map(|_| {
            let [x, y] = random.point(0.0);
            let radius = random.uniform(0.5, 4.0);
            (0..corners)
                .map(|i| {
                    let (sin, cos) = libm::sincosf(std::f32::consts::TAU * i as f32 / corners as f32);
                    [x + radius * cos, y + radius * sin]
                })
                .collect()
        })
        .collect()
}

fn main() {
    let window = Window::new(WINDOW).expect("it is right");
    let mixes = mixes(&window);
    let sizes = [3, 16, 256].map(|corners| (corners, polygons(corners)));
    let mut rows = lines(&window, &mixes);
    for (corners, polygons) in &sizes {
        for arithmetic in ARITHMETICS {
            let settings = sutherland_hodgman::Settings { arithmetic, ..Default::default() };
            let window = &window;
            let run = move |tally: &mut Tally| {
                black_box(sutherland_hodgman::clip_traced(polygons, window, settings, tally, &mut NoTrace));
            };
            let items = polygons.len() * corners;
            let name = format!("{corners} corners, Sutherland-Hodgman");
            rows.push(Row { name, arithmetic, run: Box::new(run), items, wrong: None });
        }
    }

    race("a segment or corner", "wrong", &rows);
}
