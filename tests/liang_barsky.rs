//! Liang-Barsky: laws, golden logs, the exact oracle, and the bits of Cohen-Sutherland.

use crate::support::{
    ARITHMETICS, Clipper, CohenSutherland, LiangBarsky, Random, any_line, bits, check_log,
    costs_what_it_says, keeps_the_laws, rounding_fails, visible_part, window,
};
use rasterscope_core::{
    clip::line::{
        Segment, Window,
        liang_barsky::{self as lb, Event, Visible},
    },
    math::{Arithmetic, Tally},
    replay::{Budget, Playback},
};

fn run(segment: Segment, window: &Window, arithmetic: Arithmetic) -> (Option<Visible>, Vec<Event>) {
    let mut events = Vec::new();
    let result = lb::clip_traced(segment, window, arithmetic, &mut Tally::default(), &mut events);
    (result, events)
}

fn divisions(events: &[Event]) -> usize {
    events.iter().filter(|event| matches!(event, Event::Divide { .. })).count()
}

#[track_caller]
fn check(name: &str, segment: Segment) {
    check_log::<LiangBarsky>(name, segment);
}

#[test]
fn two_inner_crossings_cut() {
    check("kept", [[0.5, 0.5], [10.5, 8.5]]);
}

#[test]
fn wrong_order_is_rejected() {
    check("wrong_order", [[1.0, 5.0], [5.0, 9.0]]);
}

#[test]
fn parallel_and_beyond_is_rejected_at_once() {
    check("parallel_outside", [[1.0, 7.5], [11.0, 7.5]]);
}

#[test]
fn parallel_and_between_is_cut_twice() {
    check("parallel", [[11.0, 5.0], [1.0, 5.0]]);
}

#[test]
fn inside_divides_nothing() {
    check("inside", [[4.0, 3.0], [8.0, 6.0]]);
}

#[test]
fn touching_a_corner_is_visible() {
    check("touches_a_corner", [[2.5, 5.5], [4.5, 7.5]]);
}

#[test]
fn zero_length_is_a_point() {
    check("point", [[9.0, 6.5], [9.0, 6.5]]);
}

/// Borders at -0: both algorithms must assign the same one of two equal borders.
#[test]
fn a_corner_at_minus_zero_has_the_bits_of_cohen_sutherland() {
    let window = window([-0.0, -0.0, 1.0, 1.0]);
    for segment in [[[-1.0, -1.0], [2.0, 2.0]], [[2.0, 2.0], [-1.0, -1.0]], [[-1.0, 1.0], [1.0, -1.0]]] {
        let [ours, theirs] = [LiangBarsky::clip(segment, &window), CohenSutherland::clip(segment, &window)];
        assert_eq!(bits(ours), bits(theirs), "{segment:?} in {window:?}");
    }
}

#[test]
fn parameters_are_correctly_rounded_and_nothing_is_divided_in_vain() {
    let mut random = Random::new(3);
    let (mut rejected, mut cut) = (0, [0; 3]);
    for _ in 0..40_000 {
        let (segment, window) = any_line(&mut random);
        let (visible, events) = run(segment, &window, Arithmetic::Exact);
        let found = visible.map(|visible| (visible.segment, visible.t));
        assert_eq!(found, visible_part(segment, &window), "{segment:?} in {window:?}");
        match visible {
            Some(Visible { t: [t0, t1], .. }) => {
                assert!(0.0 <= t0 && t0 <= t1 && t1 <= 1.0, "{segment:?}: {t0} {t1}");
                cut[divisions(&events)] += 1;
            }
            None => {
                assert_eq!(divisions(&events), 0, "{segment:?} in {window:?}");
                rejected += 1;
            }
        }
    }
    let enough = |count: i32| count > 1_000;
    assert!(enough(rejected) && cut.into_iter().all(enough), "lopsided: {rejected} rejected, {cut:?} cut");
}

#[test]
fn keeps_the_laws_in_every_arithmetic() {
    keeps_the_laws::<LiangBarsky>(4, 3_000);
}

#[test]
fn the_counter_counts_the_divisions() {
    let mut random = Random::new(7);
    for _ in 0..3_000 {
        let (segment, window) = any_line(&mut random);
        for arithmetic in ARITHMETICS {
            let (visible, events) = run(segment, &window, arithmetic);
            assert!(visible.is_some() || divisions(&events) == 0, "{segment:?} in {arithmetic:?}");
            let mut player = lb::play(segment, window, arithmetic, Budget::default());
            player.seek(player.len());
            assert_eq!(player.state().divisions(), divisions(&events), "the counter shown");
        }
    }
}

#[test]
fn events_cost_what_the_taught_form_costs() {
    costs_what_it_says::<LiangBarsky>(8);
}

#[test]
fn rounded_arithmetic_fails_where_exact_does_not() {
    rounding_fails::<LiangBarsky>(5);
}
