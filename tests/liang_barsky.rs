//! Liang-Barsky: laws, golden logs, the exact oracle, and the bits of Cohen-Sutherland.

use crate::support::{
    Coverage, LINE_WINDOW, Random, check_golden, check_laws, line, log_text, visible_part, window,
};
use rasterscope_core::{
    clip::line::{
        Segment, Window, cohen_sutherland,
        liang_barsky::{self as lb, Event, Snapshot, Visible},
    },
    math::{Arithmetic, Tally},
    replay::{Budget, Playback},
    trace::NoTrace,
};

fn run(segment: Segment, window: &Window, arithmetic: Arithmetic) -> (Option<Visible>, Vec<Event>) {
    let mut events = Vec::new();
    let result = lb::clip_traced(segment, window, arithmetic, &mut Tally::default(), &mut events);
    (result, events)
}

fn fast(segment: Segment, window: &Window, arithmetic: Arithmetic) -> Option<Visible> {
    lb::clip_traced(segment, window, arithmetic, &mut Tally::default(), &mut NoTrace)
}

fn bits(visible: Option<Visible>) -> Option<[u32; 6]> {
    visible.map(|Visible { segment: [[x1, y1], [x2, y2]], t: [t0, t1] }| {
        [x1, y1, x2, y2, t0, t1].map(f32::to_bits)
    })
}

fn divisions(events: &[Event]) -> usize {
    events.iter().filter(|event| matches!(event, Event::Divide { .. })).count()
}

#[track_caller]
fn check(name: &str, segment: Segment) {
    let (_, events) = run(segment, &window(LINE_WINDOW), Arithmetic::Exact);
    check_golden(&format!("liang_barsky/{name}"), &log_text(&events));
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
        same_bits(segment, &window);
    }
}

#[track_caller]
fn same_bits(segment: Segment, window: &Window) {
    let ends = |ends: Option<Segment>| ends.map(|ends| ends.map(|p| p.map(f32::to_bits)));
    let [ours, theirs] = [lb::clip(segment, window), cohen_sutherland::clip(segment, window)];
    assert_eq!(ends(ours), ends(theirs), "{segment:?} in {window:?}");
}

#[test]
fn agrees_with_the_rational_oracle_and_cohen_sutherland_bit_for_bit() {
    let mut random = Random::new(3);
    let (mut rejected, mut cut) = (0, [0; 3]);
    for _ in 0..80_000 {
        let (segment, window) = line(&mut random);
        same_bits(segment, &window);
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
    let enough = |count: i32| count > 2_000;
    assert!(enough(rejected) && cut.into_iter().all(enough), "lopsided: {rejected} rejected, {cut:?} cut");
}

#[test]
fn keeps_the_laws_in_every_arithmetic() {
    let mut random = Random::new(4);
    let mut coverage = Coverage::default();
    for _ in 0..3_000 {
        let (segment, window) = line(&mut random);
        for arithmetic in [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64] {
            let (traced, events) = run(segment, &window, arithmetic);
            check_laws(
                (&bits(fast(segment, &window, arithmetic)), &bits(traced)),
                &events,
                |budget| lb::play(segment, window, arithmetic, budget),
                |state: &Snapshot| bits(state.result()),
                &mut coverage,
            );
            assert!(traced.is_some() || divisions(&events) == 0, "{segment:?} in {arithmetic:?}");
            let mut player = lb::play(segment, window, arithmetic, Budget::default());
            player.seek(player.len());
            assert_eq!(player.state().divisions(), divisions(&events), "the counter shown");
        }
    }
    coverage.check_every_line::<Snapshot>();
}

#[test]
fn rounded_arithmetic_fails_where_exact_does_not() {
    let mut random = Random::new(5);
    let mut wrong = [0, 0];
    for _ in 0..20_000 {
        let (segment, window) = line(&mut random);
        let exact = lb::clip(segment, &window);
        for (count, arithmetic) in wrong.iter_mut().zip([Arithmetic::F32, Arithmetic::F64]) {
            *count += u32::from(fast(segment, &window, arithmetic).map(|v| v.segment) != exact);
        }
    }
    assert!(wrong[0] > wrong[1] && wrong[1] > 0, "f32 {} wrong, f64 {} wrong", wrong[0], wrong[1]);
}
