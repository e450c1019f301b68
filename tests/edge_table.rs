//! The edge table: laws, golden logs, and polygons against a winding number in integers of any size.

use crate::support::{Coverage, Random, check_golden, check_laws, log_text, polygon, triangle};
use rasterscope_core::{
    math::{Arithmetic, Dyadic, Sign, Tally},
    raster::{
        self, Algorithm, Span, YAxis,
        edge_table::{self, Event, Point, Settings, Snapshot, WindingRule},
        rows,
    },
    replay::{Budget, Playback},
};

const SIZE: [u32; 2] = [9, 7];

fn run(contours: &[Vec<Point>], settings: &Settings) -> (Vec<Span>, Vec<Event>) {
    let (mut events, mut spans) = (Vec::new(), Vec::new());
    let mut emit = |span| spans.push(span);
    edge_table::fill_traced(contours, settings, &mut Tally::default(), &mut events, &mut emit);
    (spans, events)
}

fn spans(contours: &[Vec<Point>], settings: &Settings) -> Vec<Span> {
    let mut spans = Vec::new();
    edge_table::fill(contours, settings, &mut Tally::default(), &mut |span| spans.push(span));
    spans
}

#[track_caller]
fn check(name: &str, contours: &[Vec<Point>], settings: Settings) {
    let (spans, events) = run(contours, &settings);
    let picture = picture(&spans, settings.size);
    check_golden(&format!("edge_table/{name}"), &format!("{picture}\n{}", log_text(&events)));
}

/// A number for each pixel that is drawn, a dot for the others.
fn picture(spans: &[Span], [width, height]: [u32; 2]) -> String {
    let hits = |x: u32, y: u32| spans.iter().filter(|s| s.y == y && (s.begin..s.end).contains(&x)).count();
    let row = |y: u32| (0..width).map(|x| [".", "#", "2"][hits(x, y).min(2)]).collect::<String>() + "\n";
    (0..height).map(row).collect()
}

/// The oracle: the winding number of every centre, moved right by an infinitesimal step and down by its
/// square, from the signs of exact determinants.
fn inside(contours: &[Vec<Point>], settings: &Settings) -> Vec<Span> {
    let down = settings.y_axis == YAxis::Down;
    let winding = |x: u32, y: u32| {
        let [cx, cy] = [x, y].map(|n| Dyadic::from(n as f32 + 0.5));
        let mut winding = 0;
        for corners in contours {
            for (i, &a) in corners.iter().enumerate() {
                let b = corners[(i + 1) % corners.len()];
                let [[ax, ay], [bx, by]] = [a, b].map(|end| end.map(Dyadic::from));
                // Whether the end is above the centre, which has moved down a little.
                let above = |end: &Dyadic| if down { *end <= cy } else { *end >= cy };
                if above(&ay) == above(&by) {
                    continue;
                }
                let turn = (&bx - &ax) * (&cy - &ay) - (&by - &ay) * (&cx - &ax);
                // The centre has moved right: on the edge is right of it.
                let right = match ay > by {
                    true => turn.sign() != Sign::Negative,
                    false => turn.sign() != Sign::Positive,
                };
                if right {
                    winding += if above(&ay) { 1 } else { -1 };
                }
            }
        }
        winding
    };
    let mut spans: Vec<Span> = Vec::new();
    let [width, height] = settings.size;
    for line in 0..height {
        let y = if down { line } else { height - 1 - line };
        for x in (0..width).filter(|&x| settings.winding.is_inside(winding(x, y))) {
            match spans.last_mut() {
                Some(last) if last.y == y && last.end == x => last.end += 1,
                _ => spans.push(Span { y, begin: x, end: x + 1 }),
            }
        }
    }
    spans
}

/// Contours that break fills: crossing, nested, repeated, turned round, without area, huge, tiny, on centres.
fn contours(random: &mut Random) -> Vec<Vec<Point>> {
    let count = 1 + random.below(3);
    let mut all: Vec<Vec<Point>> = Vec::new();
    for _ in 0..count {
        let mut contour = match random.below(6) {
            0 => triangle(random).to_vec(),
            1 => polygon(random).0,
            2 | 3 => {
                let corners = 3 + random.below(6);
                (0..corners).map(|_| [0; 2].map(|_| random.below(20) as f32 / 2.0 - 0.5)).collect()
            }
            4 => {
                let corners = random.below(8);
                let mut coordinate = || {
                    let centre = random.below(9) as f32 + 0.5;
                    random.near(centre)
                };
                (0..corners).map(|_| [coordinate(), coordinate()]).collect()
            }
            _ => {
                let (last, corners) = (all.last().cloned().unwrap_or_default(), 3 + random.below(4));
                let fresh = (0..corners).map(|_| [random.uniform(-3.0, 12.0), random.uniform(-3.0, 10.0)]);
                if last.is_empty() { fresh.collect() } else { last }
            }
        };
        if random.below(3) == 0 {
            contour.reverse();
        }
        all.push(contour);
    }
    all
}

fn star() -> Vec<Vec<Point>> {
    vec![vec![[4.5, 0.25], [6.75, 6.5], [1.0, 2.5], [8.0, 2.5], [2.25, 6.5]]]
}

#[test]
fn star_has_a_hole_by_one_rule_and_none_by_the_other() {
    for winding in WindingRule::ALL {
        let settings = Settings { winding, ..Settings::new(SIZE) };
        check(&format!("star_{}", winding.name().replace('-', "_")), &star(), settings);
    }
}

#[test]
fn edges_that_cross_between_rows_change_places() {
    check("crossing", &[vec![[1.0, 0.75], [8.0, 6.0], [8.0, 1.25], [1.0, 6.5]]], Settings::new(SIZE));
}

#[test]
fn edges_on_centres_draw_the_upper_and_the_left_ones() {
    let nested = [
        vec![[0.5, 0.5], [7.5, 0.5], [7.5, 5.5], [0.5, 5.5]],
        vec![[2.5, 2.5], [5.5, 2.5], [5.5, 4.5], [2.5, 4.5]],
    ];
    check("on_centres", &nested, Settings::new(SIZE));
    check("on_centres_y_up", &nested, Settings { y_axis: YAxis::Up, ..Settings::new(SIZE) });
}

#[test]
fn no_row_and_no_area_draw_nothing() {
    check("between_rows", &[vec![[1.0, 2.6], [8.0, 2.75], [4.0, 3.25]]], Settings::new(SIZE));
    check("there_and_back", &[vec![[1.0, 1.0], [7.0, 5.0], [3.0, 2.25]], Vec::new()], Settings::new(SIZE));
}

/// The crossing in f64 loses the far corner beside the huge ones; the exact sign corrects it.
#[test]
fn huge_polygon_is_corrected_by_exact_signs() {
    check("corrected", &[vec![[-3e38, -3e38], [3e38, 3e38], [1.5, 2.0]]], Settings::new([4, 3]));
}

#[test]
fn slopes_are_added_row_by_row_in_rounded_arithmetic() {
    let thirds = [vec![[0.5, 0.5], [8.5, 0.5], [2.5, 6.5]]];
    check("f32", &thirds, Settings { arithmetic: Arithmetic::F32, ..Settings::new(SIZE) });
}

#[test]
fn keeps_the_laws() {
    let mut random = Random::new(31);
    let mut coverage = Coverage::default();
    for _ in 0..400 {
        let contours = contours(&mut random);
        let huge = contours.iter().flatten().flatten().any(|value| value.abs() > 1e18);
        let settings = Settings {
            size: SIZE,
            winding: random.pick(&WindingRule::ALL),
            y_axis: random.pick(&YAxis::ALL),
            // Overflow gives NaN, which is not equal to itself.
            arithmetic: if huge { Arithmetic::Exact } else { random.pick(&Arithmetic::ALL) },
        };
        let fast = spans(&contours, &settings);
        let (traced, events) = run(&contours, &settings);
        check_laws(
            (&fast, &traced),
            &events,
            |budget| edge_table::play(&contours, settings, budget),
            |state: &Snapshot| state.result().to_vec(),
            &mut coverage,
        );
    }
    coverage.check_every_line::<Snapshot>();
}

#[test]
fn polygons_equal_the_oracle() {
    let mut random = Random::new(32);
    let (mut pixels, mut rules_differ) = (0, 0);
    for _ in 0..2_500 {
        let contours = contours(&mut random);
        let y_axis = random.pick(&YAxis::ALL);
        let [odd, winding] = WindingRule::ALL.map(|winding| {
            let settings = Settings { winding, y_axis, ..Settings::new(SIZE) };
            let expected = inside(&contours, &settings);
            assert_eq!(spans(&contours, &settings), expected, "{contours:?} {settings:?}");
            expected
        });
        pixels += winding.iter().map(|span| u64::from(span.len())).sum::<u64>();
        rules_differ += u32::from(odd != winding);
    }
    assert!(pixels > 20_000 && rules_differ > 200, "the families show little: {pixels}, {rules_differ}");
}

#[test]
fn triangles_are_those_of_every_rasterizer() {
    let mut random = Random::new(33);
    for _ in 0..4_000 {
        let vertices = triangle(&mut random);
        let y_axis = random.pick(&YAxis::ALL);
        let winding = random.pick(&WindingRule::ALL);
        let settings = Settings { winding, y_axis, ..Settings::new(SIZE) };
        let mut ours = spans(&[vertices.to_vec()], &settings);
        ours.sort_unstable_by_key(|span| span.y);
        let settings = raster::Settings { y_axis, ..raster::Settings::new(SIZE) };
        for algorithm in Algorithm::ALL {
            let theirs = rows(algorithm, vertices, &settings, &mut Tally::default());
            assert_eq!(ours, theirs, "{algorithm:?} {vertices:?}");
        }
    }
}

/// Where contours start, their order, and all of them turned round decide nothing.
#[test]
fn nothing_depends_on_the_order_of_corners_and_contours() {
    let mut random = Random::new(34);
    for _ in 0..1_000 {
        let contours = contours(&mut random);
        let settings = Settings { winding: random.pick(&WindingRule::ALL), ..Settings::new(SIZE) };
        let expected = spans(&contours, &settings);
        let mut other = contours.clone();
        other.iter_mut().filter(|corners| !corners.is_empty()).for_each(|corners| corners.rotate_left(1));
        other.reverse();
        other.iter_mut().for_each(|corners| corners.reverse());
        assert_eq!(spans(&other, &settings), expected, "{contours:?}");
    }
}

#[test]
fn table_names_rows_slope_and_direction_of_each_edge() {
    let mut player = edge_table::play(&star(), Settings::new(SIZE), Budget::default());
    let built = player.markers()[0].0;
    player.seek(built);
    let table = player.tables().swap_remove(2);
    let text: Vec<_> = table.rows.iter().map(|row| format!("{} {:?}", row.name, row.cells)).collect();
    assert_eq!(
        text[..2],
        [
            "V0V1 [Int(0), Int(5), F64(0.36), Int(1)]".to_owned(),
            "V4V0 [Int(0), Int(5), F64(-0.36), Int(-1)]".to_owned(),
        ]
    );
    assert_eq!(table.rows.len(), 5);
    assert_eq!(player.sentence().id, "edge-table-built");
}
