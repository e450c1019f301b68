//! The presets of scan conversion are the special cases that their sentences claim.

use crate::{presets::scene, support::areas};
use rasterscope_core::{
    compare::Pair,
    labs::{FillTriangle, LabInput},
    math::Tally,
    raster::{Algorithm, Counts, FillRule, Settings, Span, cover, rows},
    replay::Budget,
};

fn vertices(name: &str) -> ([[f32; 2]; 3], Settings) {
    let scene = scene(name);
    let Some(LabInput::FillTriangle(FillTriangle { vertices: Some(vertices), .. })) =
        scene.lab.map(|lab| lab.input)
    else {
        panic!("{name} opens a lab with a triangle of its own");
    };
    (vertices, Settings::new(scene.size))
}

fn counts(name: &str, algorithm: Algorithm) -> Counts {
    let (vertices, settings) = vertices(name);
    cover(algorithm, vertices, &settings, &mut Tally::default(), &mut |_| {})
}

fn drawn(name: &str, fill_rule: FillRule) -> u32 {
    let (vertices, settings) = vertices(name);
    let spans = rows(Algorithm::Aabb, vertices, &Settings { fill_rule, ..settings }, &mut Tally::default());
    spans.iter().map(Span::len).sum()
}

#[test]
fn each_way_tests_as_many_centres_as_its_presets_say() {
    use Algorithm::{Aabb, Backtracking, Tiled, Zigzag};
    // Pixels drawn, and centres tested by each way.
    for (name, covered, tested) in [
        ("box-half-wasted", 54, &[(Aabb, 71)][..]),
        ("box-sliver", 10, &[(Aabb, 115)]),
        ("box-huge", 108, &[(Aabb, 108)]),
        ("back-leaning-left", 8, &[(Backtracking, 65), (Zigzag, 36), (Aabb, 113)]),
        ("back-leaning-right", 10, &[(Backtracking, 43), (Zigzag, 32)]),
        ("back-needle", 0, &[(Backtracking, 7)]),
        ("zigzag-leaning-left", 8, &[(Zigzag, 36), (Backtracking, 65)]),
        ("zigzag-shallow", 6, &[(Zigzag, 19), (Backtracking, 20)]),
        ("tiles-outside", 56, &[(Tiled, 171), (Aabb, 650)]),
        ("tiles-tie", 66, &[(Tiled, 48)]),
        ("tiles-small", 3, &[(Tiled, 4), (Aabb, 4)]),
        ("tiles-huge", 768, &[(Tiled, 0), (Aabb, 768)]),
    ] {
        for &(algorithm, tested) in tested {
            let counts = counts(name, algorithm);
            assert_eq!((counts.covered, counts.tested), (covered, tested), "{name}: {algorithm:?}");
        }
    }
}

#[test]
fn ties_lie_where_the_sentences_say() {
    // As given, every tie drawn, no tie drawn.
    for (name, expected) in [
        ("box-ties", [21, 28, 10]),
        ("box-mirrored", [21, 28, 10]),
        ("zigzag-tie", [28, 28, 27]),
        ("back-flat-top", [36, 37, 27]),
        ("zigzag-point-up-and-down", [42, 43, 40]),
    ] {
        let rules = [FillRule::TopLeft, FillRule::Inclusive, FillRule::Strict];
        assert_eq!(rules.map(|rule| drawn(name, rule)), expected, "{name}");
    }
    let (line, settings) = vertices("box-zero-area");
    let on_it = (0..settings.size[0] * settings.size[1])
        .map(|i| [i % settings.size[0], i / settings.size[0]].map(|n| n as f32 + 0.5))
        .filter(|&at| areas(line, at).iter().all(|area| area.sign().is_zero()))
        .count();
    assert!(on_it > 3 && drawn("box-zero-area", FillRule::Inclusive) == 0, "{on_it} centres on the line");
}

#[test]
fn the_other_turning_sense_covers_the_same_pixels() {
    let [(one, settings), (other, _)] = ["box-ties", "box-mirrored"].map(vertices);
    assert_eq!([one[0], one[2], one[1]], other);
    let spans = [one, other].map(|t| rows(Algorithm::Aabb, t, &settings, &mut Tally::default()));
    assert_eq!(spans[0], spans[1]);
}

#[test]
fn switches_change_as_many_pixels_as_their_presets_say() {
    // Pixels of side A alone, and of side B alone.
    for (name, expected) in [
        ("vertices-fixed-4", [2, 0]),
        ("vertices-whole", [6, 6]),
        ("edge-epsilon", [3, 1]),
        ("edge-epsilon-tiny", [1, 0]),
        ("zigzag-against-backtracking", [0, 0]),
        ("tiles-against-box", [0, 0]),
    ] {
        let pair = Pair::play(&scene(name), Budget::default()).expect("it compares");
        let pair = pair.unwrap_or_else(|problem| panic!("{name}: {}", problem.id));
        let difference = pair.difference();
        assert_eq!([difference.only_a.len(), difference.only_b.len()], expected, "{name}");
        assert!(difference.changed.is_empty() && difference.same + expected[0] > 0, "{name}");
    }
}

#[test]
fn slopes_added_up_lose_rows_far_down() {
    let pair = Pair::play(&scene("slopes-added-up"), Budget::default()).expect("it compares");
    let pair = pair.unwrap_or_else(|problem| panic!("{}", problem.id));
    let rows = |facts: &[rasterscope_core::compare::Fact]| facts.len();
    let moved = rows(&pair.difference().only_a) + rows(&pair.difference().only_b);
    assert_eq!(moved, 28);
}
