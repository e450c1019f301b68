//! Points: laws, golden logs, and every centre against the square in exact numbers.

use crate::support::{Coverage, Random, check_golden, check_laws, log_text};
use rasterscope_core::{
    math::{Arithmetic, Dyadic, Tally},
    raster::{
        Span,
        point::{self, Event, Settings, Snapshot},
    },
};

const SIZE: [u32; 2] = [9, 7];

fn run(at: [f32; 2], width: f32, settings: &Settings) -> (Vec<Span>, Vec<Event>) {
    let (mut events, mut spans) = (Vec::new(), Vec::new());
    let mut emit = |span| spans.push(span);
    point::draw_traced((at, width), settings, &mut Tally::default(), &mut events, &mut emit);
    (spans, events)
}

fn spans(at: [f32; 2], width: f32) -> Vec<Span> {
    let mut spans = Vec::new();
    point::draw(at, width, &Settings::new(SIZE), &mut Tally::default(), &mut |span| spans.push(span));
    spans
}

/// The judge: which centres are in the square, left and upper side included.
fn in_square(at: [f32; 2], width: f32) -> Vec<Span> {
    let holds = |axis: usize, n: u32| {
        let twice = |x: f32| Dyadic::from(x).mul_pow2(1);
        let off = twice(n as f32 + 0.5) - twice(at[axis]);
        let width = Dyadic::from(width);
        -&width <= off && off < width
    };
    let row = |y: u32| {
        let columns: Vec<u32> = (0..SIZE[0]).filter(|&x| holds(0, x) && holds(1, y)).collect();
        Some(Span { y, begin: *columns.first()?, end: columns.last()? + 1 })
    };
    (0..SIZE[1]).filter_map(row).collect()
}

#[test]
fn points_of_some_sizes() {
    let cases = [
        ("one", [4.25, 3.75], 1.0),
        ("on_a_corner", [4.0, 3.0], 1.0),
        ("two_on_a_centre", [4.5, 3.5], 2.0),
        ("between_centres", [4.0, 3.0], 0.5),
        ("over_the_border", [-0.5, 3.25], 4.0),
        ("corrected", [1e-45, 3.5], 1.0),
    ];
    for (name, at, width) in cases {
        let (_, events) = run(at, width, &Settings::new(SIZE));
        check_golden(&format!("points/{name}"), &log_text(&events));
    }
}

fn case(random: &mut Random) -> ([f32; 2], f32) {
    let mut coordinate = || match random.below(6) {
        0 | 1 => random.below(24) as f32 / 2.0 - 1.0,
        2 => {
            let centre = random.below(9) as f32 + 0.5;
            random.near(centre)
        }
        3 => random.any(),
        _ => random.uniform(-3.0, 12.0),
    };
    let at = [coordinate(), coordinate()];
    let whole = random.below(5) as f32;
    let (any, free) = (random.any().abs(), random.uniform(0.0, 4.0));
    (at, random.pick(&[1.0, whole, free, any]))
}

#[test]
fn keep_the_laws() {
    let mut random = Random::new(61);
    let mut coverage = Coverage::default();
    for _ in 0..400 {
        let (at, width) = case(&mut random);
        let arithmetic = random.pick(&[Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64]);
        let settings = Settings { arithmetic, ..Settings::new(SIZE) };
        let (traced, events) = run(at, width, &settings);
        let mut fast = Vec::new();
        point::draw(at, width, &settings, &mut Tally::default(), &mut |span| fast.push(span));
        let play = |budget| point::play(at, width, settings, budget);
        check_laws((&fast, &traced), &events, play, Snapshot::result, &mut coverage);
    }
    coverage.check_every_line::<Snapshot>();
}

#[test]
fn every_centre_in_the_square_is_drawn() {
    let mut random = Random::new(62);
    let mut drawn = 0;
    for _ in 0..20_000 {
        let (at, width) = case(&mut random);
        let found = spans(at, width);
        assert_eq!(found, in_square(at, width), "{at:?} {width}");
        drawn += found.len();
    }
    assert!(drawn > 10_000, "{drawn}");
}

#[test]
fn size_one_draws_one_pixel_wherever_it_lies() {
    let mut random = Random::new(63);
    for _ in 0..2_000 {
        let at = [random.uniform(0.5, 8.5), random.uniform(0.5, 6.5)];
        assert_eq!(spans(at, 1.0).iter().map(Span::len).sum::<u32>(), 1, "{at:?}");
    }
}
