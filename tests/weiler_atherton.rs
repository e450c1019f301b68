//! Weiler-Atherton: laws, golden logs, and the covered set of Sutherland-Hodgman.

use crate::{
    compute::check as check_compute,
    support::{
        Coverage, Exact, LINE_WINDOW, Random, Ratio, check_corners, check_golden, check_laws, exact,
        log_text, place, polygon, winding, window,
    },
};
use rasterscope_core::{
    clip::{
        line::{Point, Window},
        polygon::{
            sutherland_hodgman as sh,
            weiler_atherton::{self as wa, Event, Piece, Ring, Snapshot, Source, Why},
        },
    },
    explain::Role,
    math::Tally,
    replay::{Budget, Playback},
};

/// One to three contours, which may cross themselves and each other.
fn contours(random: &mut Random) -> (Vec<Vec<Point>>, Window) {
    let (first, window) = polygon(random);
    let mut contours = vec![first];
    if random.below(8) == 0 {
        // Around the window, with a hole inside or across a border.
        let [low, high] = [[window.xmin, window.ymin], [window.xmax, window.ymax]];
        let low = low.map(|c| (c - c.abs() - 1.0).max(f32::MIN));
        let high = high.map(|c| (c + c.abs() + 1.0).min(f32::MAX));
        contours[0] = vec![low, [high[0], low[1]], high, [low[0], high[1]]];
        let mut corner =
            || [random.uniform(window.xmin, window.xmax), random.uniform(window.ymin - 0.1, window.ymax)];
        contours.push(vec![corner(), corner(), corner()]);
    }
    while random.below(2) == 0 && contours.len() < 3 {
        contours.push(match random.below(3) {
            0 => contours[0].iter().rev().copied().collect(),
            1 => contours[0].iter().map(|[x, y]| [x / 2.0 + 1.0, y / 2.0 + 1.0]).collect(),
            _ => polygon(random).0,
        });
    }
    (contours, window)
}

fn rings(pieces: &[Piece]) -> impl Iterator<Item = &Ring> {
    pieces.iter().flat_map(|piece| std::iter::once(&piece.outer).chain(&piece.holes))
}

/// The same source, its edge counted within its own contour.
fn within_contour(source: Source, contours: &[Vec<Point>]) -> (usize, Source) {
    let split = |mut index: u32| {
        for (contour, points) in contours.iter().enumerate() {
            match index.checked_sub(points.len() as u32) {
                Some(rest) => index = rest,
                None => return (contour, index),
            }
        }
        panic!("no such corner: {source:?}");
    };
    match source {
        Source::Vertex(index) => {
            let (contour, index) = split(index);
            (contour, Source::Vertex(index))
        }
        Source::Crossing { edge, border } => {
            let (contour, edge) = split(edge);
            (contour, Source::Crossing { edge, border })
        }
        Source::Window(_) => (0, source),
    }
}

/// The rings without a rounding.
fn unrounded(pieces: &[Piece], contours: &[Vec<Point>], window: &Window) -> Vec<Vec<Exact>> {
    let corner = |source| {
        let (contour, source) = within_contour(source, contours);
        place(source, &contours[contour], window)
    };
    rings(pieces).map(|ring| ring.iter().map(|c| corner(c.source)).collect()).collect()
}

/// Twice the area that an outline surrounds, counted with its direction.
fn area(outline: &[Exact]) -> Ratio {
    let pairs = outline.iter().zip(outline.iter().cycle().skip(1));
    pairs.fold(Ratio::from(0.0), |sum, (a, b)| &sum + &(&(&a[0] * &b[1]) - &(&a[1] * &b[0])))
}

fn log(contours: &[Vec<Point>]) -> Vec<Event> {
    let mut events = Vec::new();
    wa::clip_traced(contours, &window(LINE_WINDOW), &mut Tally::default(), &mut events);
    events
}

#[track_caller]
fn check(name: &str, contours: &[&[Point]]) {
    let contours: Vec<Vec<Point>> = contours.iter().map(|contour| contour.to_vec()).collect();
    check_golden(&format!("weiler_atherton/{name}"), &log_text(&log(&contours)));
}

#[test]
fn a_convex_polygon_is_one_ring() {
    check("convex", &[&[[1.5, 3.0], [10.5, 1.0], [6.0, 8.0]]]);
}

#[test]
fn two_teeth_are_two_pieces() {
    check("two_teeth", &[&[[1.0, 3.0], [5.0, 3.0], [2.0, 4.0], [5.0, 5.0], [1.0, 6.0]]]);
}

#[test]
fn a_hole_inside_stays_a_hole_and_one_on_the_border_becomes_a_dent() {
    let outer = [[1.5, 1.0], [8.0, 1.5], [10.5, 4.0], [7.5, 7.5], [2.0, 7.0]];
    check("holes", &[&outer, &[[4.5, 3.0], [4.0, 4.5], [5.5, 5.0]], &[[6.5, 5.5], [6.0, 7.0], [8.0, 6.0]]]);
}

#[test]
fn around_the_window_leaves_the_window() {
    check("around", &[&[[0.0, 0.0], [12.0, 0.0], [12.0, 9.0], [0.0, 9.0]]]);
}

#[test]
fn touching_in_a_corner_leaves_nothing() {
    check("touches_a_corner", &[&[[9.0, 6.5], [11.0, 6.0], [10.0, 8.0]]]);
}

#[test]
fn an_edge_on_a_border_is_kept_bit_for_bit() {
    check("edge_on_a_border", &[&[[3.5, 1.0], [7.0, 3.0], [5.0, 8.0], [3.5, 6.0]]]);
}

#[test]
fn covers_what_sutherland_hodgman_covers() {
    let mut random = Random::new(1977);
    let (mut inside, mut counts, mut holes) = (0, [0; 5], 0);
    for _ in 0..25_000 {
        let (contours, window) = contours(&mut random);
        let pieces = wa::clip(&contours, &window);
        counts[pieces.len().min(4)] += 1;
        holes += pieces.iter().map(|piece| piece.holes.len()).sum::<usize>();
        for ring in rings(&pieces) {
            for corner in ring {
                let (contour, source) = within_contour(corner.source, &contours);
                check_corners(&[sh::Corner { source, ..*corner }], &contours[contour], &window);
            }
        }
        let given: Vec<Vec<Exact>> =
            contours.iter().map(|contour| contour.iter().copied().map(exact).collect()).collect();
        let left = unrounded(&pieces, &contours, &window);
        for _ in 0..4 {
            let at = [
                random.uniform(window.xmin, window.xmax).next_up(),
                random.uniform(window.ymin, window.ymax).next_up(),
            ];
            if !(window.xmin < at[0] && at[0] < window.xmax && window.ymin < at[1] && at[1] < window.ymax) {
                continue;
            }
            let at = exact(at);
            let odd = |outlines: &[Vec<Exact>]| {
                outlines.iter().map(|outline| winding(outline, &at)).sum::<i32>() % 2 != 0
            };
            assert_eq!(odd(&left), odd(&given), "{contours:?} in {window:?} at {at:?}");
            inside += u32::from(odd(&given));
        }
    }
    assert!(inside > 1_000 && holes > 20, "lopsided: {inside} inside, {holes} holes");
    assert!(counts[..4].iter().all(|&count| count > 20), "lopsided: {counts:?} pieces");
}

/// The exact area of a triangle's rest is the same by both algorithms.
#[test]
fn has_the_area_of_sutherland_hodgman() {
    let mut random = Random::new(1978);
    let mut some = 0;
    for _ in 0..10_000 {
        let (mut points, window) = polygon(&mut random);
        points.truncate(3);
        let (contours, tally) = ([points.clone()], &mut Tally::default());
        let (mut events, mut their_events) = (Vec::new(), Vec::new());
        let ours = unrounded(&wa::clip_traced(&contours, &window, tally, &mut events), &contours, &window);
        let theirs = sh::clip_traced(&contours, &window, sh::Settings::default(), tally, &mut their_events);
        let theirs: Vec<Exact> =
            theirs.iter().flatten().map(|corner| place(corner.source, &points, &window)).collect();
        let merged = events.iter().any(|event| matches!(event, Event::Drop { why: Why::Repeats, .. }))
            || their_events.iter().any(|event| matches!(event, sh::Event::Drop { why: Why::Repeats, .. }));
        if merged || ours.is_empty() || theirs.is_empty() {
            continue; // corners that become one by rounding have lost a source
        }
        let sum = ours.iter().fold(Ratio::from(0.0), |sum, ring| &sum + &area(ring));
        assert_eq!(sum, area(&theirs), "{points:?} in {window:?}");
        some += 1;
    }
    assert!(some > 300, "lopsided: {some}");
}

#[test]
fn keeps_the_laws() {
    let mut random = Random::new(1979);
    let mut coverage = Coverage::default();
    for _ in 0..500 {
        let (contours, window) = contours(&mut random);
        let mut events = Vec::new();
        let traced = wa::clip_traced(&contours, &window, &mut Tally::default(), &mut events);
        let places = |pieces: &[Piece]| -> Vec<Vec<(Point, Source)>> {
            rings(pieces).map(|ring| ring.iter().map(|c| (c.at, c.source)).collect()).collect()
        };
        check_laws(
            (&places(&wa::clip(&contours, &window)), &places(&traced)),
            &events,
            |budget| wa::play(&contours, window, budget),
            |state: &Snapshot| places(&state.pieces()),
            &mut coverage,
        );
    }
    coverage.check_every_line::<Snapshot>();
}

#[test]
fn compute_answers_with_pieces_and_holes() {
    check_compute(&[
        (
            r#"{"op":"clip_polygon","algorithm":"weiler-atherton","window":[0,0,4,4],"polygon":[[-2,0],[2,1],[-1,2],[2,3],[-2,4]]}"#,
            r#"{"polygons":[[[[0.0,0.5],[2.0,1.0],[0.0,1.6666666269302368]]],[[[0.0,2.3333332538604736],[2.0,3.0],[0.0,3.5]]]]}"#,
        ),
        (
            r#"{"op":"clip_polygon","algorithm":"weiler-atherton","window":[0,0,4,4],"polygon":[[-9,-9],[9,-9],[9,9],[-9,9]],"contours":[[[1,1],[2,1],[1,2]]]}"#,
            r#"{"polygons":[[[[0.0,0.0],[4.0,0.0],[4.0,4.0],[0.0,4.0]],[[1.0,1.0],[2.0,1.0],[1.0,2.0]]]]}"#,
        ),
        (
            r#"{"op":"clip_polygon","algorithm":"weiler-atherton","window":[0,0,4,4],"polygon":[[4,4],[6,4],[6,6]]}"#,
            r#"{"polygons":[]}"#,
        ),
    ]);
}

/// The ribbon counts pieces by the marks of the timeline: a ring each, but for holes.
#[test]
fn marks_tell_how_many_pieces_there_are() {
    let mut random = Random::new(29);
    let mut most = 0;
    for _ in 0..500 {
        let (contours, window) = contours(&mut random);
        let markers = wa::play(&contours, window, Budget::default()).markers();
        let count = |role| markers.iter().filter(|(_, marker)| marker.role == role).count();
        let pieces = wa::clip(&contours, &window).len();
        assert_eq!(count(Role::Accepted) - count(Role::Changed), pieces, "{contours:?} in {window:?}");
        most = most.max(pieces);
    }
    assert!(most > 2);
}
