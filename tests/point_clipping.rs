//! Clipping a point: the closed window, in every arithmetic.

use crate::support::{
    ARITHMETICS, Coverage, LINE_WINDOW, Random, any_line, check_golden, check_laws, counted, log_text, window,
};
use rasterscope_core::{
    clip::{
        line::Point,
        point::{self, Event, Snapshot},
    },
    explain::{Explain, Operations},
    math::{Arithmetic, Dyadic},
};

#[track_caller]
fn check(name: &str, at: Point) {
    let mut events: Vec<Event> = Vec::new();
    point::clip_traced(at, &window(LINE_WINDOW), Arithmetic::Exact, &mut events);
    check_golden(&format!("point_clipping/{name}"), &log_text(&events));
}

#[test]
fn inside_has_no_bits() {
    check("inside", [6.0, 4.0]);
}

#[test]
fn beyond_a_corner_has_two_bits() {
    check("beyond_two", [2.0, 8.0]);
}

#[test]
fn on_a_corner_is_inside() {
    check("on_a_corner", [3.5, 2.0]);
}

#[test]
fn one_step_beside_the_border_is_told_apart() {
    let window = window(LINE_WINDOW);
    for (at, visible) in [
        ([9.0, 4.0], true),
        ([9.0_f32.next_up(), 4.0], false),
        ([9.0_f32.next_down(), 4.0], true),
        ([4.0, 2.0_f32.next_down()], false),
        ([f32::MAX, 4.0], false),
        ([4.0, -f32::MAX], false),
    ] {
        assert_eq!(point::is_visible(at, &window), visible, "{at:?}");
    }
}

#[test]
fn keeps_the_laws_and_agrees_with_exact_numbers_in_every_arithmetic() {
    let mut random = Random::new(41);
    let mut coverage = Coverage::default();
    let mut seen = [0, 0];
    for round in 0..100_000 {
        let ([at, _], window) = any_line(&mut random);
        let visible = point::is_visible(at, &window);
        let within = |axis: usize| {
            let [low, high] = window.sides(axis).map(Dyadic::from);
            (low..=high).contains(&Dyadic::from(at[axis]))
        };
        assert_eq!(visible, within(0) && within(1), "{at:?} in {window:?}");
        seen[usize::from(visible)] += 1;
        if round % 20 != 0 {
            continue;
        }
        let arithmetic = random.pick(&ARITHMETICS);
        let mut events: Vec<Event> = Vec::new();
        let traced = point::clip_traced(at, &window, arithmetic, &mut events);
        check_laws(
            (&Some(visible), &Some(traced)),
            &events,
            |budget| point::play(at, window, arithmetic, budget),
            |state: &Snapshot| state.result(),
            &mut coverage,
        );
        let (_, cost) =
            counted(|| point::clip_taught::<crate::support::Counted, _>(at, &window, &mut Vec::new()));
        let said = events.iter().map(Snapshot::operations).fold(Operations::NONE, |a, b| a + b);
        assert_eq!(cost, said);
    }
    coverage.check_every_line::<Snapshot>();
    assert!(seen.into_iter().all(|count| count > 10_000), "lopsided: {seen:?}");
}
