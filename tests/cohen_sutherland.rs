//! Cohen-Sutherland: laws, golden logs, and an exact oracle that knows no outcodes.

use crate::support::{
    Clipper, CohenSutherland, Random, check_log, costs_what_it_says, keeps_the_laws, line, rounding_fails,
    window,
};
use rasterscope_core::{
    clip::line::{
        self, Kept, Mistake, Mistakes, Segment, clip_all,
        cohen_sutherland::{self as cs, Settings},
    },
    math::{Arithmetic, Tally, ulps_between},
    message::Value,
    replay::{Budget, Playback},
    trace::NoTrace,
};

#[track_caller]
fn check(name: &str, segment: Segment) {
    check_log::<CohenSutherland>(name, segment);
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

/// OR and AND of the table are those of the codes above them, or not yet known.
#[test]
fn or_and_and_belong_to_the_shown_codes() {
    let mut random = Random::new(7);
    for _ in 0..300 {
        let (segment, window) = line(&mut random);
        let mut player = CohenSutherland::play(segment, window, Arithmetic::Exact, Budget::default());
        for step in 0..=player.len() {
            player.seek(step);
            let codes: Vec<_> = player.tables()[0].rows.iter().map(|row| row.cells[2].clone()).collect();
            let bits = |code: &Value| if let Value::Bits { bits, .. } = code { Some(*bits) } else { None };
            let [c1, c2, or, and] = [0, 1, 2, 3].map(|row| bits(&codes[row]));
            let both = c1.zip(c2);
            assert!(or.is_none() || or == both.map(|(c1, c2)| c1 | c2), "step {step} of {segment:?}");
            assert!(and.is_none() || and == both.map(|(c1, c2)| c1 & c2), "step {step} of {segment:?}");
        }
    }
}

#[test]
fn keeps_the_laws_in_every_arithmetic() {
    keeps_the_laws::<CohenSutherland>(1, 3_000);
}

#[test]
fn events_cost_what_the_taught_form_costs() {
    costs_what_it_says::<CohenSutherland>(6);
}

#[test]
fn many_at_once_are_the_same_as_one_by_one() {
    let mut random = Random::new(6);
    for _ in 0..200 {
        let (_, window) = line(&mut random);
        let segments: Vec<_> = (0..50).map(|_| line(&mut random).0).collect();
        let before = Kept { index: 7, segment: segments[0] };
        let (mut kept, mut expected) = (vec![before], vec![before]);
        clip_all(&segments, &window, &mut kept);
        for (index, segment) in (0..).zip(&segments) {
            expected.extend(cs::clip(*segment, &window).map(|segment| Kept { index, segment }));
            let bits = |part: Option<Segment>| part.map(|ends| ends.map(|p| p.map(f32::to_bits)));
            assert_eq!(bits(line::clip(*segment, &window)), bits(cs::clip(*segment, &window)));
        }
        assert_eq!(kept, expected);
    }
}

#[test]
fn rounded_arithmetic_fails_where_exact_does_not() {
    rounding_fails::<CohenSutherland>(2);
}

fn clip(segment: Segment, settings: Settings) -> Option<Segment> {
    let unit = window([0.0, 0.0, 1.0, 1.0]);
    cs::clip_traced(segment, &unit, settings, &mut Tally::default(), &mut NoTrace)
}

#[test]
fn or_instead_of_and_rejects_what_crosses() {
    let mistakes = Mistakes::NONE.with(Mistake::OrForAnd);
    for arithmetic in [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64] {
        let clip = |segment| clip(segment, Settings { arithmetic, mistakes });
        assert_eq!(clip([[-1.0, 0.5], [2.0, 0.5]]), None, "through the window");
        assert_eq!(clip([[0.5, 0.5], [2.0, 0.5]]), None, "out of the window");
        let inside = [[0.25, 0.5], [0.75, 0.5]];
        assert_eq!(clip(inside), Some(inside), "inside");
    }
}

/// Two neighbours share an edge and walk it in opposite directions.
#[test]
fn the_other_order_opens_a_crack_in_rounded_arithmetic_only() {
    let mut cracks = [0; 3];
    for i in 0..1_000_u16 {
        let segment = [[-1.0 - f32::from(i) / 7.0, 0.1], [3.0, 0.9 - f32::from(i) / 3000.0]];
        for (count, arithmetic) in
            cracks.iter_mut().zip([Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64])
        {
            let [here, there] = [Mistakes::NONE, Mistakes::NONE.with(Mistake::OtherOrder)]
                .map(|mistakes| clip(segment, Settings { arithmetic, mistakes }).expect("it crosses"));
            let apart = (0..2).any(|end| ulps_between(here[end][1], there[end][1]) > 0);
            *count += usize::from(apart);
        }
    }
    let [exact, f32, f64] = cracks;
    assert_eq!(exact, 0);
    assert!(f32 > 100 && f32 > f64, "{f32} in f32, {f64} in f64");
}
