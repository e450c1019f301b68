//! A value by area ratios: laws, golden logs, an exact oracle for every number on the way.

use crate::support::{Coverage, Random, areas, check_golden, check_laws, log_text, triangle};
use rasterscope_core::{
    explain::View,
    interpolate::{
        InterpolateError, Mode, Subject,
        area_ratios::{self as ar, Event, Outcome, Snapshot},
    },
    math::{Arithmetic, Dyadic, Tally},
};

const SUBJECT: Subject = Subject {
    vertices: [[1.0, 10.0, 2.0], [14.0, 7.0, 6.0], [5.0, 1.0, 3.0]],
    attribute: [0.0, 1.0, 0.5],
    at: [6.5, 6.5],
};

fn run(mode: Mode, subject: &Subject, arithmetic: Arithmetic) -> (Outcome, Vec<Event>) {
    let mut events = Vec::new();
    let outcome = ar::interpolate_traced(mode, subject, arithmetic, &mut Tally::default(), &mut events);
    (outcome, events)
}

#[track_caller]
fn check(name: &str, mode: Mode, subject: &Subject, expected: Outcome) {
    let (outcome, events) = run(mode, subject, Arithmetic::Exact);
    assert_eq!(outcome, expected);
    check_golden(&format!("area_ratios/{name}"), &log_text(&events));
}

#[test]
fn in_perspective_one_division_gives_the_value() {
    check("perspective", Mode::Perspective, &SUBJECT, Ok(0.3));
}

#[test]
fn at_the_centroid_each_vertex_weighs_a_third() {
    let vertices = [[1.0, 1.0, 1.0], [13.0, 1.0, 1.0], [4.0, 10.0, 1.0]];
    check("centroid", Mode::Affine, &Subject { vertices, at: [6.0, 4.0], ..SUBJECT }, Ok(0.5));
}

#[test]
fn outside_a_part_has_the_other_sign() {
    let subject = Subject { at: [11.5, 3.5], ..SUBJECT };
    check("outside", Mode::Affine, &subject, Err(InterpolateError::Outside));
}

#[test]
fn without_area_nothing_is_weighed() {
    let vertices = [[1.0, 1.0, 1.0], [7.0, 5.0, 2.0], [13.0, 9.0, 3.0]];
    check("zero_area", Mode::Affine, &Subject { vertices, ..SUBJECT }, Err(InterpolateError::ZeroArea));
}

#[test]
fn a_vertex_with_w_0_has_no_value_over_w() {
    let vertices = [[1.0, 10.0, 2.0], [14.0, 7.0, 0.0], [5.0, 1.0, 3.0]];
    check("zero_w", Mode::Perspective, &Subject { vertices, ..SUBJECT }, Err(InterpolateError::ZeroW));
}

#[test]
fn a_point_may_be_infinitely_far() {
    let vertices = [[0.0, 0.0, 1.0], [4.0, 0.0, -1.0], [0.0, 4.0, 1.0]];
    let subject = Subject { vertices, at: [2.0, 0.0], ..SUBJECT };
    check("infinite", Mode::Perspective, &subject, Err(InterpolateError::Infinite));
}

fn subject(random: &mut Random) -> Subject {
    let points = triangle(random);
    let w = match random.below(3) {
        0 => [2.0; 3],
        1 => [0; 3].map(|_| random.uniform(0.5, 9.0)),
        _ => [0; 3].map(|_| random.pick(&[1.0, -1.0, 2.0, 0.0, -0.5])),
    };
    let vertices = [0, 1, 2].map(|i| [points[i][0], points[i][1], w[i]]);
    let attribute = [0; 3].map(|_| random.uniform(-1.0, 1.0));
    let middle = [0, 1].map(|axis| (points[0][axis] + points[1][axis]) / 2.0);
    let inside = [0, 1].map(|axis| middle[axis] / 2.0 + points[2][axis] / 2.0);
    let centre = [random.below(9) as f32 + 0.5, random.below(7) as f32 + 0.5];
    let at = random.pick(&[middle, inside, centre, points[1]]);
    Subject { vertices, attribute, at: at.map(|value| value.clamp(f32::MIN, f32::MAX)) }
}

/// Every number of the exact run is the exact number, rounded once.
#[test]
fn every_weight_is_the_nearest_binary64() {
    let mut random = Random::new(61);
    let mut seen = 0;
    for _ in 0..5_000 {
        let subject = subject(&mut random);
        let parts = areas(subject.vertices.map(|[x, y, _]| [x, y]), subject.at);
        let whole = &(&parts[0] + &parts[1]) + &parts[2];
        let (_, events) = run(Mode::Perspective, &subject, Arithmetic::Exact);
        for event in events {
            match event {
                Event::Whole { area } => assert_eq!(area, whole.to_f64_nearest()),
                Event::Part { vertex, area } => {
                    assert_eq!(area, parts[usize::from(vertex)].to_f64_nearest());
                }
                Event::Share { vertex, l } => {
                    seen += 1;
                    // The nearest f64, so the f32 that it rounds to is at most one step off.
                    let part = &parts[usize::from(vertex)];
                    let nearest = Dyadic::ratio_to_f32(part, &whole);
                    assert!((nearest.next_down()..=nearest.next_up()).contains(&(l as f32)), "{subject:?}");
                }
                _ => {}
            }
        }
    }
    assert!(seen > 3_000, "{seen}");
}

#[test]
fn keeps_the_laws_in_every_arithmetic() {
    let mut random = Random::new(62);
    let mut coverage = Coverage::default();
    let infinite =
        Subject { vertices: [[0.0, 0.0, 1.0], [4.0, 0.0, -1.0], [0.0, 4.0, 1.0]], at: [2.0, 0.0], ..SUBJECT };
    let all = (0..250).map(|_| subject(&mut random)).chain([infinite]).collect::<Vec<_>>();
    for subject in all {
        for arithmetic in Arithmetic::ALL {
            for mode in Mode::ALL {
                let (traced, events) = run(mode, &subject, arithmetic);
                let fast = ar::interpolate(mode, &subject, arithmetic, &mut Tally::default());
                if log_text(&events).contains("NaN") {
                    continue; // taught arithmetic on huge numbers, and no NaN equals itself
                }
                check_laws(
                    (&Some(fast), &Some(traced)),
                    &events,
                    |budget| ar::play(mode, subject, arithmetic, View::SPACE, budget),
                    Snapshot::result,
                    &mut coverage,
                );
            }
        }
    }
    coverage.check_every_line::<Snapshot>();
}
