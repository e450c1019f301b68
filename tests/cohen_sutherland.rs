//! Cohen-Sutherland: laws, golden logs, and an exact oracle that knows no outcodes.

use crate::support::{Coverage, Random, check_golden, check_laws, log_text};
use rasterscope_core::{
    clip::line::{
        Segment, Window,
        cohen_sutherland::{self as cs, Event, Snapshot},
    },
    math::{Arithmetic, Dyadic, Tally},
};

const WINDOW: [f32; 4] = [3.5, 2.0, 9.0, 6.5];

fn window(sides: [f32; 4]) -> Window {
    Window::new(sides).expect("the test's window is right")
}

fn run(segment: Segment, window: &Window, arithmetic: Arithmetic) -> (Option<Segment>, Vec<Event>) {
    let mut events = Vec::new();
    let result = cs::clip_traced(segment, window, arithmetic, &mut Tally::default(), &mut events);
    (result, events)
}

#[track_caller]
fn check(name: &str, segment: Segment) {
    let (_, events) = run(segment, &window(WINDOW), Arithmetic::Exact);
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

/// A random segment and window of one of several nasty families.
fn input(random: &mut Random) -> (Segment, Window) {
    let family = random.below(5);
    let mut side = || {
        let (a, b) = (random.grid(0, 5), random.grid(0, 5));
        [a.min(b), a.max(b)]
    };
    let [[xmin, xmax], [ymin, ymax]] = [side(), side()];
    let mut coordinate = |sides: [f32; 2]| match family {
        0 | 1 => random.grid(-3, 8),
        2 => {
            let border = random.pick(&sides);
            random.near(border)
        }
        3 => random.any(),
        _ => random.uniform(-1e3, 1e3),
    };
    let mut point = || [coordinate([xmin, xmax]), coordinate([ymin, ymax])];
    ([point(), point()], window([xmin, ymin, xmax, ymax]))
}

/// Parametric clipping in rational numbers: the exact interval of visible parameters.
fn oracle([p, q]: Segment, w: &Window) -> Option<Segment> {
    let [px, py, qx, qy] = [p[0], p[1], q[0], q[1]].map(Dyadic::from);
    let (dx, dy) = (&qx - &px, &qy - &py);
    // Entering and leaving parameters as fractions with a positive denominator.
    let (mut enter, mut leave) =
        ((Dyadic::from(0.0_f32), Dyadic::from(1.0_f32)), (Dyadic::from(1.0_f32), Dyadic::from(1.0_f32)));
    let less = |a: &(Dyadic, Dyadic), b: &(Dyadic, Dyadic)| &a.0 * &b.1 < &b.0 * &a.1;
    let zero = Dyadic::from(0.0_f32);
    for (delta, start, side, sign) in
        [(&dx, &px, w.xmin, -1), (&dx, &px, w.xmax, 1), (&dy, &py, w.ymin, -1), (&dy, &py, w.ymax, 1)]
    {
        // Inside iff sign (start + t delta - side) <= 0.
        let sign = Dyadic::from(sign);
        let (rate, distance) = (&sign * delta, &sign * &(&Dyadic::from(side) - start));
        if rate == zero {
            if distance < zero {
                return None;
            }
        } else if rate > zero {
            let t = (distance, rate);
            if less(&t, &leave) {
                leave = t;
            }
        } else {
            let t = (-distance, -rate);
            if less(&enter, &t) {
                enter = t;
            }
        }
    }
    if less(&leave, &enter) {
        return None;
    }
    let at = |(t, one): &(Dyadic, Dyadic), given: &Dyadic, end: [f32; 2]| {
        if *t == given * one {
            return end; // not cut: bit for bit
        }
        [Dyadic::ratio_to_f32(&(&px * one + t * &dx), one), Dyadic::ratio_to_f32(&(&py * one + t * &dy), one)]
    };
    Some([at(&enter, &zero, p), at(&leave, &Dyadic::from(1), q)])
}

#[test]
fn agrees_with_the_rational_oracle_and_keeps_the_laws() {
    let mut random = Random::new(1);
    let (mut coverage, mut visible) = (Coverage::default(), 0);
    for round in 0..60_000 {
        let (segment, window) = input(&mut random);
        let fast = cs::clip(segment, &window);
        assert_eq!(fast, oracle(segment, &window), "{segment:?} in {window:?}");
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
fn rounded_arithmetic_fails_where_exact_does_not() {
    let mut random = Random::new(2);
    let mut wrong = [0, 0];
    for _ in 0..20_000 {
        let (segment, window) = input(&mut random);
        let exact = cs::clip(segment, &window);
        for (count, arithmetic) in wrong.iter_mut().zip([Arithmetic::F32, Arithmetic::F64]) {
            *count += u32::from(run(segment, &window, arithmetic).0 != exact);
        }
    }
    assert!(wrong[0] > wrong[1] && wrong[1] > 0, "f32 {} wrong, f64 {} wrong", wrong[0], wrong[1]);
}
