//! Cyrus-Beck: laws, golden logs, an exact oracle for any convex window, and the bits of its
//! siblings in a rectangle.

use crate::support::{
    ARITHMETICS, Clipper, CohenSutherland, Coverage, CyrusBeck, Random, any_line, bits, check_golden,
    check_laws, check_log, convex, costs_what_it_says, log_text, rounding_fails, visible_part_of, window,
};
use rasterscope_core::{
    clip::line::{
        ConvexWindow, Flaw, Point, Segment,
        cyrus_beck::{self as cb, Event, Snapshot, Visible},
    },
    math::{Arithmetic, Tally, ulps_between},
    trace::NoTrace,
};

const PENTAGON: [Point; 5] = [[3.5, 2.5], [7.0, 1.5], [9.5, 4.5], [6.5, 7.5], [3.5, 6.0]];

fn run(segment: Segment, window: &ConvexWindow, arithmetic: Arithmetic) -> (Option<Visible>, Vec<Event>) {
    let mut events = Vec::new();
    let result = cb::clip_traced(segment, window, arithmetic, &mut Tally::default(), &mut events);
    (result, events)
}

fn all_bits(visible: Option<Visible>) -> Option<[u32; 6]> {
    visible.map(|Visible { segment: [[x1, y1], [x2, y2]], t: [t0, t1] }| {
        [x1, y1, x2, y2, t0, t1].map(f32::to_bits)
    })
}

#[test]
fn a_rectangle_is_four_edges() {
    check_log::<CyrusBeck>("rectangle", [[0.5, 0.5], [10.5, 8.5]]);
}

#[test]
fn parallel_and_beyond_is_rejected_there() {
    check_log::<CyrusBeck>("parallel_outside", [[1.0, 7.5], [11.0, 7.5]]);
}

#[test]
fn a_miss_is_known_after_all_edges() {
    check_log::<CyrusBeck>("misses", [[1.0, 5.0], [5.0, 9.0]]);
}

#[test]
fn a_pentagon_has_five_edges() {
    let window = ConvexWindow::new(&PENTAGON).expect("it is convex");
    let (_, events) = run([[1.0, 1.5], [10.5, 8.0]], &window, Arithmetic::Exact);
    check_golden("cyrus_beck/pentagon", &log_text(&events));
}

#[test]
fn corners_that_are_no_convex_window_are_refused() {
    let refused = |corners: &[Point]| ConvexWindow::new(corners).err();
    assert_eq!(refused(&PENTAGON), None);
    let mut clockwise = PENTAGON;
    clockwise.reverse();
    assert_eq!(refused(&clockwise), None, "either way round");
    assert_eq!(refused(&PENTAGON[..2]), Some(Flaw::Corners));
    assert_eq!(refused(&[[0.0, 0.0]; 33]), Some(Flaw::Corners));
    assert_eq!(refused(&[[0.0, 0.0], [1.0, 0.0], [f32::NAN, 1.0]]), Some(Flaw::NotFinite));
    assert_eq!(refused(&[[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]]), Some(Flaw::NoArea));
    let dart = [[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]];
    assert_eq!(refused(&dart), Some(Flaw::NotConvex));
    let bow_tie = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [2.0, 2.0]];
    assert_eq!(refused(&bow_tie), Some(Flaw::NotConvex));
    let pentagram = [0, 2, 4, 1, 3].map(|i| PENTAGON[i]);
    assert_eq!(refused(&pentagram), Some(Flaw::NotConvex), "every corner turns left, but twice round");
    // One ULP is enough.
    let square = |x: f32| [[0.0, 0.0], [x, 0.5], [0.0, 1.0], [-1.0, 0.5]];
    assert_eq!(refused(&square(0.0)), None, "a corner on the line of its neighbours");
    assert_eq!(refused(&square(-1e-45)), Some(Flaw::NotConvex));
}

#[test]
fn clockwise_corners_give_the_same_bits() {
    let mut random = Random::new(21);
    for _ in 0..5_000 {
        let (segment, corners) = convex(&mut random);
        let mut reversed = corners.clone();
        reversed.reverse();
        let [a, b] = [corners, reversed].map(|corners| {
            let window = ConvexWindow::new(&corners).expect("it is convex");
            bits(cb::clip(segment, &window))
        });
        assert_eq!(a, b, "{segment:?}");
    }
}

#[test]
fn agrees_with_the_rational_oracle_in_any_convex_window() {
    let mut random = Random::new(22);
    let mut seen = [0, 0];
    for _ in 0..100_000 {
        let (segment, corners) = convex(&mut random);
        let window = ConvexWindow::new(&corners).expect("it is convex");
        let answer = cb::clip(segment, &window);
        assert_eq!(answer, visible_part_of(segment, window.edges()), "{segment:?} in {corners:?}");
        let [p1, p2] = segment;
        let reversed = cb::clip([p2, p1], &window).map(|[a, b]| [b, a]);
        assert_eq!(bits(answer), bits(reversed), "{segment:?} reversed in {corners:?}");
        seen[usize::from(answer.is_some())] += 1;
    }
    assert!(seen.into_iter().all(|count| count > 20_000), "lopsided: {seen:?}");
}

/// With all the windows that have no area, and borders at -0.
#[test]
fn in_a_rectangle_it_has_the_bits_of_cohen_sutherland() {
    let mut random = Random::new(23);
    let same = |segment, window| {
        let [ours, theirs] = [CyrusBeck::clip(segment, &window), CohenSutherland::clip(segment, &window)];
        assert_eq!(bits(ours), bits(theirs), "{segment:?} in {window:?}");
    };
    for _ in 0..40_000 {
        let (segment, window) = any_line(&mut random);
        same(segment, window);
    }
    let huge = f32::MAX;
    for sides in [
        [2.0, 1.0, 2.0, 3.0],
        [1.0, 2.0, 4.0, 2.0],
        [2.0; 4],
        [huge, -huge, huge, huge],
        [-huge, huge, -huge, huge],
    ] {
        for _ in 0..500 {
            let mut end = || {
                [0, 1].map(|axis| {
                    let at = random.pick(&[sides[axis], sides[axis + 2], 0.0, 1.5, -2.0]);
                    random.near(at).clamp(-huge, huge)
                })
            };
            same([end(), end()], window(sides));
        }
    }
    same([[-1.0, -1.0], [2.0, 2.0]], window([-0.0, -0.0, 1.0, 1.0]));
}

#[test]
fn keeps_the_laws_in_every_arithmetic() {
    let mut random = Random::new(24);
    let mut coverage = Coverage::default();
    for _ in 0..2_000 {
        let (segment, corners) = convex(&mut random);
        let window = ConvexWindow::new(&corners).expect("it is convex");
        for arithmetic in ARITHMETICS {
            let fast = cb::clip_traced(segment, &window, arithmetic, &mut Tally::default(), &mut NoTrace);
            let (traced, events) = run(segment, &window, arithmetic);
            check_laws(
                (&all_bits(fast), &all_bits(traced)),
                &events,
                |budget| cb::play(segment, window.clone(), arithmetic, budget),
                |state: &Snapshot| all_bits(state.result()),
                &mut coverage,
            );
        }
    }
    coverage.check_every_line::<Snapshot>();
}

#[test]
fn events_cost_what_the_taught_form_costs() {
    costs_what_it_says::<CyrusBeck>(25);
}

#[test]
fn rounded_arithmetic_fails_where_exact_does_not() {
    rounding_fails::<CyrusBeck>(26);
    let window = ConvexWindow::new(&PENTAGON).expect("it is convex");
    let mut random = Random::new(27);
    let mut off = 0;
    for _ in 0..2_000 {
        let mut end = || [random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0)];
        let segment = [end(), end()];
        let rounded = run(segment, &window, Arithmetic::F32).0;
        for (a, b) in rounded
            .into_iter()
            .flat_map(|v| v.segment)
            .flatten()
            .zip(cb::clip(segment, &window).into_iter().flatten().flatten())
        {
            off = off.max(ulps_between(a, b));
        }
    }
    assert!(off > 2, "f32 is never off by more than {off} ULP");
}
