//! What exactness costs in clipping: each algorithm in three arithmetics, its wrong answers, and how often
//! binary64 did not decide. Run with `cargo bench -p rasterscope-core --bench clip`.
//!
//! The rows take turns, so that a busy moment of the machine hits them all. Each exact answer is held
//! against that of another algorithm and that of the reversed input, bit for bit; the rounded ones are
//! counted where they differ from it. `tests/peers` compares with other crates.
#![expect(clippy::print_stdout, reason = "it prints a table")]

use rasterscope_core::{
    clip::{
        line::{Segment, Window, cohen_sutherland, liang_barsky},
        polygon::sutherland_hodgman,
    },
    math::{Arithmetic, Tally},
    trace::NoTrace,
};
use std::{hint::black_box, time::Instant};

const ROUNDS: usize = 21;
const SEGMENTS: usize = 8_192;
const WINDOW: [f32; 4] = [-3.1, -2.2, 4.7, 3.3];

/// One line of the table.
struct Row<'a> {
    name: String,
    arithmetic: Arithmetic,
    run: Box<dyn Fn(&mut Tally) + 'a>,
    items: usize,
    wrong: Option<usize>,
    times: Vec<f64>,
}

/// Marsaglia's xorshift: the same numbers on every machine.
struct Random(u64);

impl Random {
    /// Uniform in `low..high`.
    fn uniform(&mut self, low: f32, high: f32) -> f32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * (self.0 >> 40) as f32 / (1 << 24) as f32
    }

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

const ARITHMETICS: [Arithmetic; 3] = [Arithmetic::Exact, Arithmetic::F64, Arithmetic::F32];

/// A clipper in any arithmetic.
type Clip = fn(Segment, &Window, Arithmetic, &mut Tally) -> Option<Segment>;

const CLIPPERS: [(&str, Clip); 2] = [
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
            for arithmetic in ARITHMETICS {
                let wrong = segments.iter().filter(|&&[p, q]| {
                    let exact = cohen_sutherland::clip([p, q], window);
                    let reversed = cohen_sutherland::clip([q, p], window).map(|[q, p]| [p, q]);
                    assert_eq!(exact, reversed, "the order of the ends matters");
                    clip([p, q], window, arithmetic, &mut Tally::default()) != exact
                });
                let wrong = Some(wrong.count());
                assert!(arithmetic != Arithmetic::Exact || wrong == Some(0), "{name} differs");
                let run = move |tally: &mut Tally| {
                    for segment in segments {
                        black_box(clip(*segment, window, arithmetic, tally));
                    }
                };
                let (name, run) = (format!("{mix}, {name}"), Box::new(run));
                rows.push(Row { name, arithmetic, run, items: SEGMENTS, wrong, times: Vec::new() });
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
            rows.push(Row { name, arithmetic, run: Box::new(run), items, wrong: None, times: Vec::new() });
        }
    }

    for _ in 0..ROUNDS {
        for row in &mut rows {
            let start = Instant::now();
            (row.run)(&mut Tally::default());
            row.times.push(start.elapsed().as_secs_f64() * 1e9 / row.items as f64);
        }
    }
    println!(
        "{:<36} {:<6} {:>9} {:>8} {:>12}",
        "ns a segment or corner", "", "median", "wrong", "not decided"
    );
    for Row { name, arithmetic, run, wrong, times, .. } in &mut rows {
        times.sort_unstable_by(f64::total_cmp);
        let mut tally = Tally::default();
        run(&mut tally);
        let wrong = wrong.map_or(String::new(), |wrong| wrong.to_string());
        let (name, median, share) = (&name, times[times.len() / 2], tally.share() * 100.0);
        println!("{name:<36} {:<6} {median:>9.1} {wrong:>8} {share:>10.4} %", arithmetic.name());
    }
}
