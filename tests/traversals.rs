//! The ways over the centres: laws, golden logs, and what each leaves out. That they all cover the same
//! pixels, `coverage` tests.

use crate::support::{Coverage, Random, check_golden, check_laws, covered, log_text, triangle};
use rasterscope_core::{
    explain::Explain,
    math::{Arithmetic, Tally},
    raster::{
        Algorithm, Counts, FillRule, Mistake, Settings, Span, YAxis,
        aabb::Aabb,
        backtracking::Backtracking,
        cover, homogeneous,
        tiled::Tiled,
        traversal::{self, Event, Snapshot, Traversal},
        zigzag::Zigzag,
    },
    replay::Budget,
};

type Triangle = [[f32; 2]; 3];

fn run<A: Traversal>(vertices: Triangle, settings: &Settings) -> (Vec<Span>, Vec<Event>) {
    let (mut events, mut spans) = (Vec::new(), Vec::new());
    let mut emit = |span| spans.push(span);
    traversal::fill_traced::<A, _>(vertices, settings, &mut Tally::default(), &mut events, &mut emit);
    spans.sort_unstable_by_key(|span| span.y);
    (spans, events)
}

fn keeps_the_laws<A: Traversal>() {
    let mut random = Random::new(23);
    let mut coverage = Coverage::default();
    for case in 0..400 {
        let mut vertices = triangle(&mut random);
        let huge = vertices.iter().flatten().any(|value| value.abs() > 1e18);
        let large = case % 4 == 0 && !huge;
        if large {
            vertices = vertices.map(|vertex| vertex.map(|value| value * 8.0));
        }
        let settings = Settings {
            fill_rule: random.pick(&FillRule::ALL),
            y_axis: random.pick(&[YAxis::Down, YAxis::Up]),
            // Overflow gives NaN, which is not equal to itself.
            arithmetic: if huge { Arithmetic::Exact } else { random.pick(&Arithmetic::ALL) },
            mistake: Some(random.pick(&Mistake::ALL)).filter(|_| !huge && case % 3 == 0),
            ..Settings::new(if large { [80, 70] } else { [9, 7] })
        };
        let mut fast = Vec::new();
        traversal::fill::<A>(vertices, &settings, &mut Tally::default(), &mut |span| fast.push(span));
        fast.sort_unstable_by_key(|span| span.y);
        let (traced, events) = run::<A>(vertices, &settings);
        check_laws(
            (&fast, &traced),
            &events,
            |budget| traversal::play::<A>(vertices, settings, budget),
            Snapshot::result,
            &mut coverage,
        );
    }
    coverage.check_every_line::<Snapshot<A>>();
}

#[test]
fn the_bounding_box_keeps_the_laws() {
    keeps_the_laws::<Aabb>();
}

#[test]
fn backtracking_keeps_the_laws() {
    keeps_the_laws::<Backtracking>();
}

#[test]
fn zigzag_keeps_the_laws() {
    keeps_the_laws::<Zigzag>();
}

#[test]
fn tiles_keep_the_laws() {
    keeps_the_laws::<Tiled>();
}

fn check<A: Traversal>(name: &str, vertices: Triangle, size: [u32; 2]) {
    let (_, events) = run::<A>(vertices, &Settings::new(size));
    check_golden(&format!("{}/{name}", A::NAME), &log_text(&events));
}

/// A left edge through the centre of pixel (3, 4).
const ONE_TIE: Triangle = [[4.4375, 0.75], [10.6875, 5.75], [2.5625, 8.25]];

#[test]
fn each_way_has_a_log_of_its_own() {
    check::<Aabb>("one_tie", ONE_TIE, [12, 9]);
    check::<Backtracking>("one_tie", ONE_TIE, [12, 9]);
    check::<Zigzag>("one_tie", ONE_TIE, [12, 9]);
    check::<Tiled>("one_tie", ONE_TIE, [12, 9]);
    check::<Tiled>("inner_tiles", [[1.0, 1.0], [30.0, 2.0], [3.0, 30.0]], [32, 32]);
}

fn counts(algorithm: Algorithm, vertices: Triangle, size: [u32; 2]) -> Counts {
    cover(algorithm, vertices, &Settings::new(size), &mut Tally::default(), &mut |_| {})
}

#[test]
fn what_each_way_leaves_out() {
    let vertices = [[10.0, 4.0], [250.0, 100.0], [60.0, 240.0]];
    let [aabb, backtracking, zigzag, tiled] =
        [Algorithm::Aabb, Algorithm::Backtracking, Algorithm::Zigzag, Algorithm::Tiled]
            .map(|algorithm| counts(algorithm, vertices, [256, 256]));
    assert!([backtracking, zigzag, tiled].iter().all(|other| other.covered == aabb.covered));
    assert!(tiled.tested < zigzag.tested && zigzag.tested < aabb.tested, "{tiled:?} {zigzag:?} {aabb:?}");
    assert!(zigzag.tested < backtracking.tested, "{zigzag:?} {backtracking:?}");
}

#[test]
fn the_table_of_all_ways_counts_what_each_run_reports() {
    let mut random = Random::new(31);
    let mut seen = 0;
    for _ in 0..200 {
        let vertices = triangle(&mut random).map(|vertex| vertex.map(|value| value * 4.0));
        let settings = Settings::new([40, 30]);
        let ways = traversal::of_each_way(vertices, &settings);
        assert_eq!(ways.len(), 4);
        for (algorithm, visits) in ways {
            let counts = cover(algorithm, vertices, &settings, &mut Tally::default(), &mut |_| {});
            assert_eq!((u64::from(visits.tested), u64::from(visits.drawn)), (counts.tested, counts.covered));
            assert!(visits.visited <= visits.tested && visits.wasted <= visits.tested, "{visits:?}");
            match algorithm {
                Algorithm::Aabb | Algorithm::Zigzag => assert_eq!(visits.visited, visits.tested),
                Algorithm::Backtracking => {
                    assert!(visits.tested <= 2 * visits.visited + 2 * settings.size[1]);
                }
                _ => assert!(visits.drawn == 0 || visits.tiles > 0),
            }
            seen += visits.drawn;
        }
    }
    assert!(seen > 20_000, "{seen}");
    assert!(
        traversal::of_each_way([[0.0, 0.0], [1e9, 0.0], [0.0, 1e9]], &Settings::new([400, 400])).is_empty()
    );
}

/// What a click on a pixel tells is what the run does.
#[test]
fn the_report_of_a_pixel_is_what_the_run_draws() {
    let mut random = Random::new(37);
    let (mut ties, mut warned) = (0, 0);
    for _ in 0..300 {
        let vertices = triangle(&mut random);
        let settings = Settings {
            fill_rule: random.pick(&FillRule::ALL),
            arithmetic: random.pick(&Arithmetic::ALL),
            mistake: random.pick(&[None, None, Some(Mistake::EpsilonLarge), Some(Mistake::WholeVertices)]),
            ..Settings::new([9, 7])
        };
        if vertices.iter().flatten().any(|value| value.abs() > 1e18) {
            continue;
        }
        let player =
            traversal::play::<Aabb>(vertices, Settings { skip_row: false, ..settings }, Budget::default());
        let drawn = covered_by::<Aabb>(vertices, &Settings { skip_row: false, ..settings });
        let truth = covered(vertices, &settings);
        let holds = |spans: &[Span], [x, y]: [u32; 2]| {
            spans.iter().any(|span| span.y == y && (span.begin..span.end).contains(&x))
        };
        for at in (0..63).map(|i| [i % 9, i / 9]) {
            let report = player.state().pixel(at).expect("it is in the image");
            let says = matches!(report.sentence.id, "pixel-in" | "pixel-tie-drawn");
            assert_eq!(says, holds(&drawn, at), "{vertices:?} {at:?}");
            if report.sentence.id != "pixel-zero-area" {
                assert_eq!(report.warning.is_some(), says != holds(&truth, at), "{vertices:?} {at:?}");
            }
            ties += u32::from(report.sentence.id.starts_with("pixel-tie"));
            warned += u32::from(report.warning.is_some());
        }
        assert_eq!(player.state().pixel([9, 0]), None);
    }
    assert!(ties > 100 && warned > 100, "{ties} ties, {warned} warnings");
}

fn covered_by<A: Traversal>(vertices: Triangle, settings: &Settings) -> Vec<Span> {
    run::<A>(vertices, settings).0
}

/// With every w = 1 it is the plane; with any w > 0 it is the projected triangle if nothing is rounded.
#[test]
fn homogeneous_edges_are_those_of_the_projected_triangle() {
    let mut random = Random::new(29);
    let mut pixels = 0;
    for _ in 0..4_000 {
        let flat = [0; 3].map(|_| [random.below(22) as f32 / 2.0 - 1.0, random.below(18) as f32 / 2.0 - 1.0]);
        // A power of two scales x, y and w without a rounding.
        let vertices = flat.map(|[x, y]| {
            let w = random.pick(&[0.25, 0.5, 1.0, 2.0, 8.0]);
            [x * w, y * w, w]
        });
        let settings = Settings { fill_rule: random.pick(&FillRule::ALL), ..Settings::new([9, 7]) };
        let mut spans = Vec::new();
        homogeneous::fill(vertices, None, &settings, &mut Tally::default(), &mut |span| spans.push(span));
        spans.sort_unstable_by_key(|span| span.y);
        assert_eq!(spans, covered(flat, &settings), "{vertices:?}");
        pixels += spans.iter().map(Span::len).sum::<u32>();
    }
    assert!(pixels > 10_000, "{pixels}");
}

/// A vertex behind the eye needs no clipping: what is drawn is the part in front, beyond the near plane.
#[test]
fn homogeneous_edges_are_right_behind_the_eye() {
    // On the screen the edges from V0 and V1 run away downwards and do not meet.
    let behind = [[2.13, 1.07, 1.0], [6.21, 1.03, 1.0], [-4.0, 9.0, -1.0]];
    let mut rows = Vec::new();
    let settings = Settings::new([9, 7]);
    homogeneous::fill(behind, None, &settings, &mut Tally::default(), &mut |span| rows.push(span));
    let drawn = |x: f32, y: f32| {
        // A point of the triangle's plane in front of the eye whose three weights are positive.
        let cross = |a: [f32; 3], b: [f32; 3]| {
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        let dot = |a: [f32; 3], b: [f32; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let [a, b, c] = behind;
        let area = dot(a, cross(b, c));
        [cross(b, c), cross(c, a), cross(a, b)].iter().all(|edge| dot([x, y, 1.0], *edge) / area > 0.0)
    };
    for y in 0..7 {
        for x in 0..9 {
            let covered = rows.iter().any(|span| span.y == y && (span.begin..span.end).contains(&x));
            assert_eq!(covered, drawn(x as f32 + 0.5, y as f32 + 0.5), "({x}, {y})");
        }
    }
    assert!(!rows.is_empty());
    let mut near = Vec::new();
    homogeneous::fill(behind, Some(0.6), &settings, &mut Tally::default(), &mut |span| near.push(span));
    let count = |spans: &[Span]| spans.iter().map(Span::len).sum::<u32>();
    assert!(count(&near) < count(&rows), "the near plane cuts some of it off");
}
