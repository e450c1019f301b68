//! Sutherland-Hodgman: laws, golden logs, the rational oracle.

use crate::support::{
    Coverage, Exact, LINE_WINDOW, Random, check_corners, check_golden, check_laws, convex_part, exact, hull,
    log_text, place, polygon, turn, winding, window,
};
use rasterscope_core::{
    clip::{
        line::{Point, Window},
        polygon::sutherland_hodgman::{self as sh, Corner, Event, Mistake, Settings, SideOrder, Snapshot},
    },
    math::{Arithmetic, Tally},
    replay::{Budget, Playback},
    trace::NoTrace,
};

fn corners(polygon: &[Point], window: &Window, settings: Settings) -> Vec<Corner> {
    let mut results =
        sh::clip_traced(&[polygon.to_vec()], window, settings, &mut Tally::default(), &mut NoTrace);
    results.pop().expect("one polygon in, one out")
}

fn bits(points: &[Point]) -> Vec<[u32; 2]> {
    points.iter().map(|p| p.map(f32::to_bits)).collect()
}

fn log(polygon: &[Point], settings: Settings) -> Vec<Event> {
    let mut events = Vec::new();
    let polygons = [polygon.to_vec()];
    sh::clip_traced(&polygons, &window(LINE_WINDOW), settings, &mut Tally::default(), &mut events);
    events
}

#[track_caller]
fn check(name: &str, polygon: &[Point]) {
    let events = log(polygon, Settings::default());
    check_golden(&format!("sutherland_hodgman/{name}"), &log_text(&events));
}

#[test]
fn a_triangle_gains_a_corner_of_the_window() {
    check("triangle", &[[1.5, 3.0], [10.5, 1.0], [6.0, 8.0]]);
}

#[test]
fn inside_keeps_every_corner() {
    check("inside", &[[4.0, 3.0], [8.0, 3.0], [6.0, 6.0]]);
}

#[test]
fn outside_is_empty_after_one_side() {
    check("outside", &[[0.0, 3.0], [3.0, 3.0], [1.0, 6.0]]);
}

#[test]
fn a_corner_on_a_border_is_its_own_cut() {
    check("corner_on_a_border", &[[3.5, 3.0], [7.0, 4.0], [1.0, 5.0]]);
}

#[test]
fn two_teeth_are_joined_by_a_bridge() {
    check("two_teeth", &[[1.0, 3.0], [5.0, 3.0], [2.0, 4.0], [5.0, 5.0], [1.0, 6.0]]);
}

#[test]
fn touching_in_a_corner_leaves_nothing() {
    check("touches_a_corner", &[[9.0, 6.5], [11.0, 6.0], [10.0, 8.0]]);
}

#[test]
fn straight_and_repeated_corners_are_dropped() {
    check("straight", &[[4.0, 3.0], [6.0, 3.0], [8.0, 3.0], [8.0, 3.0], [6.0, 6.0]]);
}

#[test]
fn bridges_are_where_the_outline_runs_there_and_back() {
    let window = window(LINE_WINDOW);
    let settings = Settings::default();
    let teeth = corners(&[[1.0, 3.0], [5.0, 3.0], [2.0, 4.0], [5.0, 5.0], [1.0, 6.0]], &window, settings);
    assert_eq!(sh::bridges(&teeth, &window), [[[3.5, 3.5], [3.5, 4.5]]]);
    let triangle = corners(&[[1.5, 3.0], [10.5, 1.0], [6.0, 8.0]], &window, settings);
    assert!(sh::bridges(&triangle, &window).is_empty());
}

/// The same cycle, starting at its smallest corner.
fn rotated<T: Ord + Clone>(mut cycle: Vec<T>) -> Vec<T> {
    let start = (0..cycle.len())
        .min_by_key(|&i| (0..cycle.len()).map(|k| cycle[(i + k) % cycle.len()].clone()).collect::<Vec<_>>());
    cycle.rotate_left(start.unwrap_or_default());
    cycle
}

/// A corner as a value: the two zeros are one.
fn key([x, y]: Point) -> [u32; 2] {
    [x + 0.0, y + 0.0].map(f32::to_bits)
}

/// Rounded once; corners that become one are one, and less than three are none.
fn rounded(outline: &[Exact]) -> Vec<[u32; 2]> {
    let mut keys: Vec<_> = outline.iter().map(|[x, y]| key([x.to_f32(), y.to_f32()])).collect();
    keys.dedup();
    while keys.len() > 1 && keys.first() == keys.last() {
        keys.pop();
    }
    if keys.len() < 3 { Vec::new() } else { rotated(keys) }
}

#[test]
fn convex_polygons_keep_exactly_their_corners() {
    let mut random = Random::new(1974);
    let mut counts = [0; 10];
    for case in 0..60_000 {
        let (mut points, window) = polygon(&mut random);
        if case % 3 == 0 {
            let corners = hull(points.iter().copied().map(exact).collect());
            points = corners.iter().map(|[x, y]| [x.to_f32(), y.to_f32()]).collect();
        } else {
            points.truncate(3);
        }
        if points.is_empty() {
            continue;
        }
        let mut part = convex_part(&points, &window);
        let outline: Vec<_> = points.iter().copied().map(exact).collect();
        if area_sign(&outline) < 0 {
            part.reverse();
        }
        let ours = sh::clip(&points, &window);
        let found = rotated(ours.iter().copied().map(key).collect());
        assert_eq!(found, rounded(&part), "{points:?} in {window:?} gives {ours:?}");
        counts[ours.len().min(9)] += 1;
    }
    assert!(counts[0] > 5_000 && counts[3..7].iter().all(|&count| count > 400), "lopsided: {counts:?}");
}

/// The sign of twice the area of a convex outline.
fn area_sign(outline: &[Exact]) -> i32 {
    let center = &outline[0];
    let turns = outline.windows(2).map(|pair| turn([center, &pair[0], &pair[1]]));
    turns.map(|sign| sign as i32 - 1).find(|sign| *sign != 0).unwrap_or_default()
}

#[test]
fn every_shape_keeps_its_winding_numbers_and_corners_their_sources() {
    let mut random = Random::new(1975);
    let (mut inside, mut bridged) = (0, 0);
    for _ in 0..30_000 {
        let (points, window) = polygon(&mut random);
        let order = random.pick(&SideOrder::ALL);
        let result = corners(&points, &window, Settings { order, ..Settings::default() });
        check_corners(&result, &points, &window);
        let ours: Vec<_> = result.iter().map(|corner| corner.at).collect();
        if order == SideOrder::default() {
            assert_eq!(bits(&sh::clip(&points, &window)), bits(&ours), "the fast call");
        }
        let given: Vec<_> = points.iter().copied().map(exact).collect();
        let left: Vec<_> = result.iter().map(|corner| place(corner.source, &points, &window)).collect();
        for _ in 0..4 {
            let around = [
                random.uniform(window.xmin, window.xmax).next_up(),
                random.uniform(window.ymin, window.ymax).next_up(),
            ];
            if around[0] <= window.xmin
                || around[0] >= window.xmax
                || around[1] <= window.ymin
                || around[1] >= window.ymax
            {
                continue;
            }
            let around = exact(around);
            let expected = winding(&given, &around);
            assert_eq!(winding(&left, &around), expected, "{points:?} in {window:?} at {around:?}");
            inside += i32::from(expected != 0);
            bridged += i32::from(expected.abs() > 1);
        }
    }
    assert!(inside > 5_000 && bridged > 100, "lopsided: {inside} {bridged}");
}

#[test]
fn direction_and_start_cannot_matter() {
    let mut random = Random::new(1976);
    for _ in 0..20_000 {
        let (mut points, window) = polygon(&mut random);
        let once = rotated(bits(&sh::clip(&points, &window)));
        points.rotate_left(1);
        assert_eq!(rotated(bits(&sh::clip(&points, &window))), once, "{points:?} in {window:?}");
        points.reverse();
        let mut back = bits(&sh::clip(&points, &window));
        back.reverse();
        assert_eq!(rotated(back), once, "{points:?} in {window:?}");
    }
}

#[test]
fn keeps_the_laws_in_every_arithmetic() {
    let mut random = Random::new(1977);
    let mut coverage = Coverage::default();
    for case in 0..600 {
        let (first, window) = polygon(&mut random);
        let (second, _) = polygon(&mut random);
        let polygons = if case % 3 == 0 { vec![first, second] } else { vec![first] };
        let settings = Settings {
            arithmetic: random.pick(&[Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64]),
            order: random.pick(&SideOrder::ALL),
            mistake: random.pick(&[None, Some(Mistake::TwoSides), Some(Mistake::EitherEnd)]),
        };
        let mut events = Vec::new();
        let (tally, fast) = (&mut Tally::default(), &mut NoTrace);
        let traced = sh::clip_traced(&polygons, &window, settings, tally, &mut events);
        let fast = sh::clip_traced(&polygons, &window, settings, tally, fast);
        if traced.iter().flatten().flat_map(|corner| corner.at).any(f32::is_nan) {
            continue; // equal to nothing, itself included
        }
        check_laws(
            (&fast, &traced),
            &events,
            |budget| sh::play(&polygons, window, settings, budget),
            |state: &Snapshot| state.results().to_vec(),
            &mut coverage,
        );
    }
    coverage.check_every_line::<Snapshot>();
}

/// Two polygons with a common edge, of coordinates that are not round.
fn neighbours(random: &mut Random) -> ([Vec<Point>; 2], Window) {
    let mut number = || random.uniform(-10.0, 10.0);
    let [p, q] = [[number(), number()], [number(), number()]];
    let [a, b] = [[number(), number()], [number(), number()]];
    let around = window([-4.1, -3.7, 4.3, 3.9]);
    ([vec![p, q, a], vec![q, p, b]], around)
}

#[test]
fn neighbours_meet_in_the_same_bits() {
    let mut random = Random::new(1978);
    let (mut shared, mut cracked) = (0, [0; 2]);
    for _ in 0..5_000 {
        let (polygons, window) = neighbours(&mut random);
        let cracks = |arithmetic, mistake| {
            let settings = Settings { arithmetic, mistake, ..Settings::default() };
            let mut player = sh::play(&polygons, window, settings, Budget::default());
            player.seek(player.len());
            player.state().cracks().len()
        };
        let either = Some(Mistake::EitherEnd);
        assert_eq!(cracks(Arithmetic::Exact, None), 0, "{polygons:?}");
        assert_eq!(cracks(Arithmetic::Exact, either), 0, "{polygons:?}");
        assert_eq!(cracks(Arithmetic::F32, None), 0, "from the inner end, {polygons:?}");
        for (count, arithmetic) in cracked.iter_mut().zip([Arithmetic::F32, Arithmetic::F64]) {
            *count += u32::from(cracks(arithmetic, either) > 0);
        }
        shared += 1;
    }
    assert!(cracked[0] > shared / 10, "of {shared} cracked {cracked:?}");
}

#[test]
fn rounded_arithmetic_fails_where_exact_does_not() {
    let mut random = Random::new(1979);
    let mut wrong = [0, 0];
    for _ in 0..5_000 {
        let (points, window) = polygon(&mut random);
        let in_ = |arithmetic| {
            let corners = corners(&points, &window, Settings { arithmetic, ..Settings::default() });
            corners.iter().map(|corner| corner.at.map(f32::to_bits)).collect::<Vec<_>>()
        };
        let mut exact = in_(Arithmetic::Exact);
        exact.sort_unstable();
        for (count, arithmetic) in wrong.iter_mut().zip([Arithmetic::F32, Arithmetic::F64]) {
            let mut taught = in_(arithmetic);
            taught.sort_unstable();
            taught.dedup();
            *count += u32::from(!exact.iter().all(|corner| taught.contains(corner)));
        }
    }
    assert!(wrong[0] > wrong[1] && wrong[1] > 0, "f32 {} wrong, f64 {} wrong", wrong[0], wrong[1]);
}
