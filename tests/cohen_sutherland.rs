//! Cohen-Sutherland: laws, golden logs, and an exact oracle that knows no outcodes.

use crate::support::{
    Coverage, LINE_WINDOW, Random, check_golden, check_laws, line, log_text, visible_part, window,
};
use rasterscope_core::{
    clip::line::{
        Kept, Segment, Window,
        cohen_sutherland::{self as cs, Event, Snapshot},
    },
    math::{Arithmetic, Tally},
};

fn run(segment: Segment, window: &Window, arithmetic: Arithmetic) -> (Option<Segment>, Vec<Event>) {
    let mut events = Vec::new();
    let result = cs::clip_traced(segment, window, arithmetic, &mut Tally::default(), &mut events);
    (result, events)
}

#[track_caller]
fn check(name: &str, segment: Segment) {
    let (_, events) = run(segment, &window(LINE_WINDOW), Arithmetic::Exact);
    check_golden(&format!("cohen_sutherland/{name}"), &log_text(&events));
}

#[test]
fn corner_to_corner_takes_three_cuts() {
    check("three_cuts", [[0.5, 0.5], [10.5, 8.5]]);
}

#[test]
fn inside_is_accepted_at_once() {
    check("inside", [[4.0, 3.0], [8.0, 6.0]]);
}

#[test]
fn same_side_is_rejected_by_and() {
    check("same_side", [[1.0, 1.0], [3.0, 8.0]]);
}

#[test]
fn diagonal_past_a_corner_is_rejected_after_a_cut() {
    check("past_a_corner", [[1.0, 5.0], [5.0, 9.0]]);
}

#[test]
fn touching_a_corner_is_visible() {
    check("touches_a_corner", [[2.5, 5.5], [4.5, 7.5]]);
}

#[test]
fn zero_length_is_a_point() {
    check("point", [[9.0, 6.5], [9.0, 6.5]]);
}

/// The segments that broke other clippers, and what the exact answer is.
#[test]
fn failures_of_others_are_right_here() {
    let unit = window([0.0, 0.0, 1.0, 1.0]);
    let huge = f32::MAX;
    let cases: [(Segment, Option<Segment>); 6] = [
        // x2 - x1 overflows in f32.
        ([[-huge, 0.5], [huge, 0.5]], Some([[0.0, 0.5], [1.0, 0.5]])),
        ([[-huge, -huge], [huge, huge]], Some([[0.0, 0.0], [1.0, 1.0]])),
        // Along a border: no NaN.
        ([[-2.0, 1.0], [3.0, 1.0]], Some([[0.0, 1.0], [1.0, 1.0]])),
        ([[-2.0, 1.0_f32.next_up()], [3.0, 1.0_f32.next_up()]], None),
        // Through a corner, and one ULP beside it.
        ([[-1.0, 0.0], [1.0, 2.0]], Some([[0.0, 1.0], [0.0, 1.0]])),
        ([[-1.0, 0.0_f32.next_up()], [1.0, 2.0]], None),
    ];
    for (segment, expected) in cases {
        assert_eq!(cs::clip(segment, &unit), expected, "{segment:?}");
        let [p1, p2] = segment;
        let reversed = expected.map(|[a, b]| [b, a]);
        assert_eq!(cs::clip([p2, p1], &unit), reversed, "{segment:?} reversed");
    }
}

#[test]
fn agrees_with_the_rational_oracle_and_keeps_the_laws() {
    let mut random = Random::new(1);
    let (mut coverage, mut visible) = (Coverage::default(), 0);
    for round in 0..60_000 {
        let (segment, window) = line(&mut random);
        let fast = cs::clip(segment, &window);
        assert_eq!(fast, visible_part(segment, &window).map(|(ends, _)| ends), "{segment:?} in {window:?}");
        visible += u32::from(fast.is_some());
        if round % 20 != 0 {
            continue;
        }
        for arithmetic in [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64] {
            let untraced = cs::clip_traced(
                segment,
                &window,
                arithmetic,
                &mut Tally::default(),
                &mut rasterscope_core::trace::NoTrace,
            );
            let (traced, events) = run(segment, &window, arithmetic);
            let bits = |s: Option<Segment>| s.map(|s| s.map(|p| p.map(f32::to_bits)));
            check_laws(
                (&bits(untraced), &bits(traced)),
                &events,
                |budget| cs::play(segment, window, arithmetic, budget),
                |state: &Snapshot| bits(state.result()),
                &mut coverage,
            );
        }
    }
    coverage.check_every_line::<Snapshot>();
    assert!((5_000..55_000).contains(&visible), "the families are lopsided: {visible} visible");
}

#[test]
fn many_at_once_are_the_same_as_one_by_one() {
    let mut random = Random::new(6);
    for _ in 0..200 {
        let (_, window) = line(&mut random);
        let segments: Vec<_> = (0..50).map(|_| line(&mut random).0).collect();
        let before = Kept { index: 7, segment: segments[0] };
        let (mut kept, mut expected) = (vec![before], vec![before]);
        cs::clip_all(&segments, &window, &mut kept);
        for (index, segment) in (0..).zip(&segments) {
            expected.extend(cs::clip(*segment, &window).map(|segment| Kept { index, segment }));
        }
        assert_eq!(kept, expected);
    }
}

#[test]
fn rounded_arithmetic_fails_where_exact_does_not() {
    let mut random = Random::new(2);
    let mut wrong = [0, 0];
    for _ in 0..20_000 {
        let (segment, window) = line(&mut random);
        let exact = cs::clip(segment, &window);
        for (count, arithmetic) in wrong.iter_mut().zip([Arithmetic::F32, Arithmetic::F64]) {
            *count += u32::from(run(segment, &window, arithmetic).0 != exact);
        }
    }
    assert!(wrong[0] > wrong[1] && wrong[1] > 0, "f32 {} wrong, f64 {} wrong", wrong[0], wrong[1]);
}
