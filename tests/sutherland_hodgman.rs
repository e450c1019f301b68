//! Sutherland-Hodgman: laws, golden logs, the rational oracle.

use crate::support::{Exact, Random, check_corners, convex_part, exact, hull, place, polygon, winding};
use rasterscope_core::{
    clip::{
        line::{Point, Window},
        polygon::sutherland_hodgman::{self as sh, Corner, Event, Settings, SideOrder},
    },
    math::{Arithmetic, Tally},
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
    let turns = outline.windows(2).map(|pair| crate::support::turn([center, &pair[0], &pair[1]]));
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
