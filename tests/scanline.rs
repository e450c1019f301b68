//! The slope scan line: laws, golden logs, and what its steps show.

use crate::support::{Coverage, Random, check_golden, check_laws, log_text, triangle};
use rasterscope_core::{
    explain::Role,
    math::{Arithmetic, Tally},
    raster::{
        FillRule, Mistake, Settings, Span, YAxis,
        scanline::{self, Event, Snapshot},
    },
    replay::{Budget, Playback},
};

/// A left edge through the centre of pixel (3, 4).
const ONE_TIE: [[f32; 2]; 3] = [[4.4375, 0.75], [10.6875, 5.75], [2.5625, 8.25]];

fn run(vertices: [[f32; 2]; 3], settings: &Settings) -> (Vec<Span>, Vec<Event>) {
    let (mut events, mut spans) = (Vec::new(), Vec::new());
    let mut emit = |span| spans.push(span);
    scanline::fill_traced(vertices, settings, &mut Tally::default(), &mut events, &mut emit);
    (spans, events)
}

#[track_caller]
fn check(name: &str, vertices: [[f32; 2]; 3], settings: Settings) {
    let (_, events) = run(vertices, &settings);
    check_golden(&format!("scanline/{name}"), &log_text(&events));
}

#[test]
fn one_tie_on_a_left_edge() {
    check("one_tie", ONE_TIE, Settings::new([12, 9]));
}

#[test]
fn apex_on_a_centre_row_draws_nothing_there() {
    check("apex_on_a_centre", [[2.5, 0.5], [4.5, 3.0], [0.5, 3.0]], Settings::new([6, 4]));
}

#[test]
fn flat_top_on_centres_is_drawn_and_flat_bottom_is_not() {
    check("flat_top", [[0.5, 0.5], [4.5, 0.5], [2.5, 2.5]], Settings::new([6, 4]));
    check("flat_bottom", [[2.5, 0.5], [4.5, 2.5], [0.5, 2.5]], Settings::new([6, 4]));
}

#[test]
fn needle_between_centre_lines_has_no_row() {
    check("needle", [[0.0, 0.6], [5.0, 0.9], [5.0, 1.4]], Settings::new([6, 4]));
}

#[test]
fn collinear_vertices_draw_nothing() {
    check("zero_area", [[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]], Settings::new([6, 4]));
}

#[test]
fn y_up_walks_down_from_the_greatest_row() {
    check(
        "y_up",
        [[0.5, 0.5], [4.5, 2.5], [0.5, 2.5]],
        Settings {
            y_axis: YAxis::Up,
            fill_rule: FillRule::RightOfPoint,
            arithmetic: Arithmetic::F64,
            ..Settings::new([6, 4])
        },
    );
}

/// The guess in f64 loses the third vertex beside the huge ones; the exact sign corrects it.
#[test]
fn huge_triangle_is_corrected_by_exact_signs() {
    check("corrected", [[-3e38, -3e38], [3e38, 3e38], [1.5, 2.0]], Settings::new([4, 3]));
}

#[test]
fn keeps_the_laws() {
    let mut random = Random::new(21);
    let mut coverage = Coverage::default();
    for _ in 0..1_500 {
        let vertices = triangle(&mut random);
        let huge = vertices.iter().flatten().any(|value| value.abs() > 1e18);
        let settings = Settings {
            fill_rule: random.pick(&FillRule::ALL),
            y_axis: random.pick(&[YAxis::Down, YAxis::Up]),
            // Overflow gives NaN, which is not equal to itself.
            arithmetic: if huge { Arithmetic::Exact } else { random.pick(&Arithmetic::ALL) },
            mistake: Some(random.pick(&Mistake::ALL)).filter(|_| !huge && random.below(3) == 0),
            ..Settings::new([9, 7])
        };
        let mut fast = Vec::new();
        scanline::fill(vertices, &settings, &mut Tally::default(), &mut |span| fast.push(span));
        let (traced, events) = run(vertices, &settings);
        check_laws(
            (&fast, &traced),
            &events,
            |budget| scanline::play(vertices, settings, budget),
            Snapshot::result,
            &mut coverage,
        );
    }
    coverage.check_every_line::<Snapshot>();
}

#[test]
fn tie_step_names_pixel_edge_and_verdict() {
    let mut player = scanline::play(ONE_TIE, Settings::new([12, 9]), Budget::default());
    let tie = player.markers().into_iter().find(|(_, marker)| marker.role == Role::Tie);
    let (step, _) = tie.expect("the left edge goes through a centre");
    player.seek(step);
    let sentence = player.sentence();
    assert_eq!(sentence.id, "scanline-tie-left-drawn");
    assert_eq!(
        format!("{:?}", &sentence.args[..3]),
        r#"[("x", Int(3)), ("y", Int(4)), ("edge", Text("V0V2"))]"#
    );
    let row = player.tables().swap_remove(0).rows.pop().expect("the row is in the table");
    assert_eq!((row.name.as_str(), row.active, row.role), ("4", true, Some(Role::Tie)));
}
