//! Midpoint subdivision: laws, golden logs, and that it never hangs.

use crate::support::{
    ARITHMETICS, Clipper, CohenSutherland, Midpoint, Random, any_line, check_log, costs_what_it_says,
    keeps_the_laws, window,
};
use rasterscope_core::{
    clip::line::{
        Segment,
        midpoint::{self, Event, MOST_HALVINGS},
    },
    math::{Arithmetic, Tally},
};

#[track_caller]
fn check(name: &str, segment: Segment) {
    check_log::<Midpoint>(name, segment);
}

#[test]
fn corner_to_corner_searches_both_ends() {
    check("corner_to_corner", [[0.5, 0.5], [10.5, 8.5]]);
}

#[test]
fn inside_is_not_halved() {
    check("inside", [[4.0, 3.0], [8.0, 6.0]]);
}

#[test]
fn same_side_is_rejected_before_halving() {
    check("same_side", [[1.0, 1.0], [3.0, 8.0]]);
}

#[test]
fn passing_by_is_rejected_when_a_part_is_beyond_one_border() {
    check("passes_by", [[1.0, 5.0], [5.0, 9.0]]);
}

#[test]
fn one_end_inside_searches_once() {
    check("one_end", [[5.0, 3.0], [12.0, 5.0]]);
}

/// A third of the way is no binary fraction: no midpoint hits the corner.
#[test]
fn a_touched_corner_that_no_midpoint_hits_is_visible_in_exact_arithmetic() {
    let window = window([3.0625, 1.5, 9.5, 5.8125]);
    let segment = [[2.1875, 5.0], [4.8125, 7.4375]];
    assert_eq!(Midpoint::clip(segment, &window), Some([[3.0625, 5.8125]; 2]));
    let rounded = Midpoint::taught::<f32, _>(segment, &window, &mut rasterscope_core::trace::NoTrace);
    assert_eq!(rounded, None);
}

#[test]
fn no_search_takes_more_halvings_than_the_bound() {
    let mut random = Random::new(31);
    let (tiny, huge) = (1e-45, f32::MAX);
    let unit = window([0.0, 0.0, 1.0, 1.0]);
    let dot = window([tiny, 0.0, tiny, tiny]);
    let mut cases = vec![
        ([[-huge, -huge], [huge, huge]], unit),
        ([[-huge, tiny], [huge, tiny]], dot),
        ([[-huge, 0.0], [tiny, tiny]], dot),
        ([[huge, huge], [-1.0, -tiny]], unit),
    ];
    cases.extend((0..3_000).map(|_| any_line(&mut random)));
    let mut most = 0;
    for (segment, window) in cases {
        for arithmetic in ARITHMETICS {
            let mut events = Vec::new();
            midpoint::clip_traced(segment, &window, arithmetic, &mut Tally::default(), &mut events);
            for search in events.split(|event| matches!(event, Event::Search { .. })) {
                let halvings = search.iter().filter(|event| matches!(event, Event::Halve { .. })).count();
                let bound = MOST_HALVINGS - usize::from(arithmetic == Arithmetic::Exact);
                assert!(halvings <= bound, "{segment:?} in {window:?}: {halvings} in {arithmetic:?}");
                most = most.max(if arithmetic == Arithmetic::Exact { halvings } else { 0 });
            }
        }
    }
    assert!(most > 250, "the bound is not tried: {most}");
}

#[test]
fn keeps_the_laws_in_every_arithmetic() {
    keeps_the_laws::<Midpoint>(9, 400);
}

#[test]
fn events_cost_what_the_taught_form_costs() {
    costs_what_it_says::<Midpoint>(10);
}

#[test]
fn rounded_arithmetic_misses_what_exact_arithmetic_finds() {
    let mut random = Random::new(11);
    let mut wrong = [0; 3];
    for _ in 0..10_000 {
        let (segment, window) = any_line(&mut random);
        let right = CohenSutherland::clip(segment, &window).is_some();
        for (count, arithmetic) in wrong.iter_mut().zip(ARITHMETICS) {
            let mut events = Vec::new();
            *count +=
                u32::from(Midpoint::traced(segment, &window, arithmetic, &mut events).is_some() != right);
        }
    }
    let [exact, f32, f64] = wrong;
    // In f64 a midpoint hits a touched corner by luck even less often than in f32.
    assert!(exact == 0 && f32 > 0 && f64 > 0, "{exact} exact, {f32} in f32, {f64} in f64");
}
