//! Coverage: every algorithm against an oracle in big integers, and the shared edges of meshes.

use crate::support::{Random, covered, triangle};
use rasterscope_core::{
    math::{Arithmetic, Tally},
    raster::{Algorithm, Counts, FillRule, Settings, YAxis, cover, rows},
};

/// ALGORITHMS' acceptance scene: the square's corners lie on pixel centres.
const SQUARE: [[[f32; 2]; 3]; 2] =
    [[[1.5, 1.5], [7.5, 1.5], [7.5, 7.5]], [[1.5, 1.5], [7.5, 7.5], [1.5, 7.5]]];

/// How often each pixel is drawn, as digits; a dot is 0.
fn picture(triangles: &[[[f32; 2]; 3]], algorithm: Algorithm, settings: &Settings) -> String {
    let [width, height] = settings.size.map(|n| n as usize);
    let mut hits = vec![vec![0_usize; width]; height];
    for &triangle in triangles {
        for span in rows(algorithm, triangle, settings, &mut Tally::default()) {
            hits[span.y as usize][span.begin as usize..span.end as usize].iter_mut().for_each(|n| *n += 1);
        }
    }
    let line =
        |row: Vec<usize>| row.into_iter().map(|n| ['.', '1', '2', '3', '4'][n.min(4)]).collect::<String>();
    hits.into_iter().map(line).collect::<Vec<_>>().join("\n")
}

fn check_square(fill_rule: FillRule, expected: [&str; 10]) {
    for algorithm in Algorithm::ALL {
        let settings = Settings { fill_rule, ..Settings::new([10, 10]) };
        assert_eq!(picture(&SQUARE, algorithm, &settings), expected.join("\n"), "{algorithm:?}");
    }
}

#[test]
fn top_left_fills_the_acceptance_square_once() {
    let [empty, row] = ["..........", ".111111..."];
    check_square(FillRule::TopLeft, [empty, row, row, row, row, row, row, empty, empty, empty]);
}

#[test]
fn inclusive_draws_the_diagonal_twice() {
    check_square(
        FillRule::Inclusive,
        [
            "..........",
            ".2111111..",
            ".1211111..",
            ".1121111..",
            ".1112111..",
            ".1111211..",
            ".1111121..",
            ".1111112..",
            "..........",
            "..........",
        ],
    );
}

#[test]
fn strict_leaves_holes_on_the_diagonal() {
    check_square(
        FillRule::Strict,
        [
            "..........",
            "..........",
            "...1111...",
            "..1.111...",
            "..11.11...",
            "..111.1...",
            "..1111....",
            "..........",
            "..........",
            "..........",
        ],
    );
}

#[test]
fn right_of_point_draws_both_horizontal_borders() {
    let [empty, row] = ["..........", ".111111..."];
    check_square(FillRule::RightOfPoint, [empty, row, row, row, row, row, row, row, empty, empty]);
}

#[test]
fn y_up_turns_top_into_greater_y() {
    let settings = Settings { y_axis: YAxis::Up, ..Settings::new([10, 10]) };
    let [empty, row] = ["..........", ".111111..."];
    for algorithm in Algorithm::ALL {
        let expected = [empty, empty, row, row, row, row, row, row, empty, empty].join("\n");
        assert_eq!(picture(&SQUARE, algorithm, &settings), expected, "{algorithm:?}");
    }
}

#[test]
fn all_algorithms_equal_the_oracle() {
    let mut random = Random::new(11);
    let mut pixels = 0;
    for _ in 0..24_000 {
        let vertices = triangle(&mut random);
        let settings = Settings {
            fill_rule: random.pick(&FillRule::ALL),
            y_axis: random.pick(&[YAxis::Down, YAxis::Up]),
            skip_row: random.below(2) == 0,
            ..Settings::new([9, 7])
        };
        let expected = covered(vertices, &settings);
        pixels += expected.iter().map(|span| u64::from(span.len())).sum::<u64>();
        for algorithm in Algorithm::ALL {
            let [a, b, c] = vertices;
            let order = random.pick(&[[a, b, c], [b, c, a], [c, a, b], [c, b, a], [a, c, b], [b, a, c]]);
            let spans = rows(algorithm, order, &settings, &mut Tally::default());
            assert_eq!(spans, expected, "{algorithm:?} {order:?} {settings:?}");
        }
    }
    assert!(pixels > 100_000, "the families hardly cover anything: {pixels}");
}

#[test]
fn fixed_point_is_exact_for_the_snapped_vertices() {
    let mut random = Random::new(12);
    for _ in 0..3_000 {
        let vertices = triangle(&mut random);
        let arithmetic = random.pick(&[Arithmetic::Fixed8, Arithmetic::Fixed4, Arithmetic::Fixed0]);
        let fixed = Settings { arithmetic, ..Settings::new([9, 7]) };
        let snapped = vertices.map(|vertex| vertex.map(|coordinate| arithmetic.snap(coordinate)));
        let expected = covered(snapped, &Settings::new([9, 7]));
        for algorithm in Algorithm::ALL {
            assert_eq!(rows(algorithm, vertices, &fixed, &mut Tally::default()), expected, "{vertices:?}");
        }
    }
    let snapped = |arithmetic: Arithmetic| [0.001953125, 0.46875, -0.3, 1e30].map(|x| arithmetic.snap(x));
    assert_eq!(snapped(Arithmetic::Fixed8), [0.0, 0.46875, -0.30078125, 1e30]);
    assert_eq!(snapped(Arithmetic::Fixed4), [0.0, 0.5, -0.3125, 1e30], "7.5 sixteenths go to the even 8");
    assert_eq!(snapped(Arithmetic::Fixed0), [0.0, 0.0, 0.0, 1e30]);
    assert_eq!(snapped(Arithmetic::F32), snapped(Arithmetic::Exact));
}

/// A jittered grid of quads that hangs over the image on all sides, each cut along a random
/// diagonal: whatever the jitter, each pixel is covered exactly once.
#[test]
fn mesh_covers_every_pixel_once() {
    let mut random = Random::new(13);
    let settings = Settings::new([24, 24]);
    for round in 0..60 {
        let mut corner = |x: usize, y: usize| {
            let mut shift = || match round % 3 {
                0 => random.below(5) as f32 / 2.0 - 1.0,
                1 => random.uniform(-1.2, 1.2),
                _ => random.near(0.5),
            };
            [x as f32 * 6.0 - 3.0 + shift(), y as f32 * 6.0 - 3.0 + shift()]
        };
        let corners: Vec<Vec<_>> = (0..6).map(|y| (0..6).map(|x| corner(x, y)).collect()).collect();
        let mut triangles = Vec::new();
        for (x, y) in (0..25).map(|i| (i % 5, i / 5)) {
            let [a, b, c, d] = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]].map(|[x, y]| corners[y][x]);
            triangles.extend(if random.below(2) == 0 {
                [[a, b, c], [a, c, d]]
            } else {
                [[b, c, d], [d, a, b]]
            });
        }
        for algorithm in Algorithm::ALL {
            let picture = picture(&triangles, algorithm, &settings);
            assert!(picture.chars().all(|c| c == '1' || c == '\n'), "{algorithm:?}\n{picture}");
        }
    }
}

#[test]
fn skip_row_changes_nothing_but_the_count() {
    let mut random = Random::new(14);
    let mut saved = Counts::default();
    for _ in 0..2_000 {
        let vertices = triangle(&mut random);
        let arithmetic = random.pick(&Arithmetic::ALL);
        let run = |skip_row| {
            let settings = Settings { skip_row, arithmetic, ..Settings::new([9, 7]) };
            let mut spans = Vec::new();
            let counts =
                cover(Algorithm::Aabb, vertices, &settings, &mut Tally::default(), &mut |s| spans.push(s));
            (spans, counts)
        };
        let ((with, on), (without, off)) = (run(true), run(false));
        assert_eq!(with, without, "{vertices:?}");
        assert_eq!((on.covered, on.tested + on.skipped), (off.covered, off.tested));
        assert_eq!(off.skipped, 0);
        saved += on;
    }
    assert!(saved.skipped > 1_000, "{saved:?}");
}

#[test]
fn rounded_edges_fail_where_exact_ones_do_not() {
    let mut random = Random::new(15);
    let mut wrong = [[0; 2]; 2];
    for _ in 0..4_000 {
        let vertices = triangle(&mut random);
        for (algorithm, wrong) in Algorithm::ALL.into_iter().zip(&mut wrong) {
            let run = |arithmetic| {
                let settings = Settings { arithmetic, ..Settings::new([9, 7]) };
                rows(algorithm, vertices, &settings, &mut Tally::default())
            };
            let exact = run(Arithmetic::Exact);
            wrong[0] += u32::from(run(Arithmetic::F32) != exact);
            wrong[1] += u32::from(run(Arithmetic::F64) != exact);
        }
    }
    assert!(wrong.iter().all(|[f32, f64]| f32 > f64 && *f64 > 0), "{wrong:?}");
}

/// The bounds of a whole row leave a doubt only near an edge, however far away its ends are.
#[test]
fn an_enormous_box_is_settled_nearly_without_exact_signs() {
    let vertices = [[-3.4e38, 3.4e38], [3.4e38, -3.3e38], [3.4e38, -3.4e38]];
    let settings = Settings { skip_row: false, ..Settings::new([512, 512]) };
    let mut tally = Tally::default();
    let spans = rows(Algorithm::Aabb, vertices, &settings, &mut tally);
    assert_eq!(spans, rows(Algorithm::Scanline, vertices, &settings, &mut Tally::default()));
    assert!(tally.calls > 512 * 512 && tally.exact < 2_000, "{tally:?}");
}

/// x grows by 1/10 a row, so that every tenth centre is a tie; adding 1/10 in f32 drifts past it.
#[test]
fn slopes_accumulated_over_400_rows_drift() {
    let vertices = [[0.5, 0.5], [40.5, 400.5], [41.5, 0.5]];
    let run = |arithmetic| {
        let settings = Settings { arithmetic, ..Settings::new([48, 400]) };
        rows(Algorithm::Scanline, vertices, &settings, &mut Tally::default())
    };
    let exact = run(Arithmetic::Exact);
    let moved = |arithmetic| run(arithmetic).iter().zip(&exact).filter(|(a, b)| a != b).count();
    assert_eq!((moved(Arithmetic::F32), moved(Arithmetic::F64)), (28, 24), "rows with another end");
}
