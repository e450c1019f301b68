//! Nicholl-Lee-Nicholl: laws and golden logs; one for each way through the listing.

use crate::support::{
    Clipper, NichollLeeNicholl, Random, any_line, check_log, costs_what_it_says, keeps_the_laws,
    rounding_fails,
};
use rasterscope_core::{
    clip::line::{Outcode, Segment, nicholl_lee_nicholl::Event},
    math::Arithmetic,
    message::Value,
    replay::{Budget, Playback},
};

#[track_caller]
fn check(name: &str, segment: Segment) {
    check_log::<NichollLeeNicholl>(name, segment);
}

#[test]
fn from_a_corner_through_the_window() {
    check("from_a_corner", [[0.5, 0.5], [10.5, 8.5]]);
}

#[test]
fn from_inside_past_a_corner() {
    check("from_inside", [[5.0, 3.0], [11.0, 9.0]]);
}

#[test]
fn from_an_edge_across() {
    check("from_an_edge", [[1.0, 4.0], [11.0, 5.0]]);
}

#[test]
fn from_an_edge_past_the_window() {
    check("misses", [[1.0, 5.0], [5.0, 9.0]]);
}

#[test]
fn on_the_same_side() {
    check("same_side", [[1.0, 1.0], [3.0, 8.0]]);
}

#[test]
fn inside() {
    check("inside", [[4.0, 3.0], [8.0, 6.0]]);
}

#[test]
fn zero_length_is_a_point() {
    check("point", [[9.0, 6.5], [9.0, 6.5]]);
}

/// Only points of the answer are computed: a quotient for each end that moves, and no other.
#[test]
fn only_the_answer_is_computed() {
    let mut random = Random::new(13);
    for _ in 0..20_000 {
        let (segment, window) = any_line(&mut random);
        let mut events = Vec::new();
        let answer = NichollLeeNicholl::traced(segment, &window, Arithmetic::Exact, &mut events);
        let cuts = events.iter().filter(|event| matches!(event, Event::Cut { .. })).count();
        let outside = segment.into_iter().filter(|[x, y]| {
            !(window.xmin..=window.xmax).contains(x) || !(window.ymin..=window.ymax).contains(y)
        });
        assert_eq!(cuts, if answer.is_some() { outside.count() } else { 0 }, "{segment:?} in {window:?}");
    }
}

/// In a row of the table, the code is that of the shown point.
#[test]
fn a_row_shows_a_point_and_its_own_code() {
    let mut random = Random::new(17);
    for _ in 0..300 {
        let (segment, window) = any_line(&mut random);
        let sides = [window.xmin, window.ymin, window.xmax, window.ymax];
        let mut player = NichollLeeNicholl::play(segment, window, Arithmetic::Exact, Budget::default());
        player.seek(player.len());
        for row in &player.tables()[0].rows {
            let [Value::F32(x), Value::F32(y), code, _] = &row.cells[..] else { panic!("{row:?}") };
            if let Value::Bits { bits, .. } = *code {
                let own = u32::from(Outcode::of([*x, *y], sides).0);
                // Of P2, only what was compared is known; of P1, all.
                let known = if row.name == "P1" { 0b1111 } else { bits };
                assert_eq!(bits, own & known, "{} of {segment:?} in {window:?}", row.name);
            }
        }
    }
}

#[test]
fn keeps_the_laws_in_every_arithmetic() {
    keeps_the_laws::<NichollLeeNicholl>(14, 3_000);
}

#[test]
fn events_cost_what_the_taught_form_costs() {
    costs_what_it_says::<NichollLeeNicholl>(15);
}

#[test]
fn rounded_arithmetic_fails_where_exact_does_not() {
    rounding_fails::<NichollLeeNicholl>(16);
}
