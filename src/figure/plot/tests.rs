//! Plots as a whole: every point has its place, and no text is cut or covers another one.

use super::{Axis, Guide, Plot, Point, Scale, Series, draw, panels};
use crate::{
    figure::Shape,
    geometry::Rect,
    text,
    theme::{Theme, ThemeName},
};
use rasterscope_core::explain::Role;

const SIZES: [[f32; 2]; 3] = [[880.0, 640.0], [620.0, 560.0], [1_400.0, 900.0]];

fn point(at: [f64; 2], label: &str) -> Point {
    Point { at, spread: Some([at[1] * 0.9, at[1] * 1.1]), label: label.to_owned() }
}

fn series(name: &str, role: Role, points: &[([f64; 2], &str)]) -> Series {
    let points = points.iter().map(|(at, label)| point(*at, label)).collect();
    Series { name: name.to_owned(), role, joined: false, points }
}

/// What the benchmark draws: exact ones in the lane of 0, rounded ones far to the right.
fn scatter() -> Plot {
    Plot {
        title: "Line clipping: run time against error".into(),
        subtitle: "Inputs: on a border or a centre, or two steps beside it. To the left is more exact."
            .into(),
        axes: [
            Axis::new("worst error (ULP of binary32), logarithmic".into(), Scale::Log),
            Axis::new("time a segment (ns), logarithmic".into(), Scale::Log),
        ],
        series: vec![
            series(
                "exact",
                Role::Exact,
                &[
                    ([0.0, 21.4], "Cohen–Sutherland"),
                    ([0.0, 17.8], "Liang–Barsky"),
                    ([1.0, 96.0], "Midpoint subdivision"),
                ],
            ),
            series(
                "f32, as taught",
                Role::Taught,
                &[
                    ([41_000.0, 6.1], "Cohen–Sutherland"),
                    ([f64::INFINITY, 5.2], "Liang–Barsky"),
                    ([2e9, 4.0], "Nicholl–Lee–Nicholl"),
                ],
            ),
        ],
        guides: vec![Guide { at: 50.0, label: "a limit".into() }],
        frontier: Some("none is faster and more exact".into()),
        foot:
            "A processor of some name, two processors, linux x86_64; version 0.1.0, release build, vectors \
               sse2. Compare times of one table only. Median of 15 rounds."
                .into(),
    }
}

fn bars() -> Plot {
    let names = ["bunny", "teapot", "torus"].map(String::from).to_vec();
    let bars = |name, role, heights: [f64; 3]| Series {
        points: (0..3).map(|i| point([i as f64, heights[i]], "")).collect(),
        ..series(name, role, &[])
    };
    Plot {
        axes: [
            Axis::new("model".into(), Scale::Names(names)),
            Axis::new("share of triangles that face away".into(), Scale::Linear),
        ],
        series: vec![
            bars("one", Role::Accepted, [0.48, 0.52, 0.6]),
            bars("two", Role::Taught, [0.1, 0.02, 0.0]),
        ],
        guides: vec![Guide { at: 0.5, label: "half".into() }],
        frontier: None,
        ..scatter()
    }
}

/// The boxes of all texts.
fn boxes(plot: &Plot, size: [f32; 2], theme: &Theme) -> Vec<(String, Rect)> {
    let shapes = draw(plot, size, theme, None).figure.shapes;
    let boxes = shapes.iter().filter_map(|shape| match shape {
        Shape::Text { at, align, text, font, size, .. } => {
            let extent = text::measure(*font, *size, text);
            let min = text::corner(*at, *align, extent);
            let max = [min[0] + extent[0], min[1] + extent[1]];
            Some((text.clone(), Rect { min: min.map(f64::from), max: max.map(f64::from) }))
        }
        _ => None,
    });
    boxes.collect()
}

#[test]
fn no_text_is_cut_or_covers_another_one() {
    for plot in [scatter(), bars()] {
        for size in SIZES {
            for name in ThemeName::ALL {
                let sheet = Rect { min: [0.0; 2], max: size.map(f64::from) };
                let boxes = boxes(&plot, size, name.theme());
                assert!(boxes.len() > 12);
                for (i, (text, rect)) in boxes.iter().enumerate() {
                    assert!(rect.inside(sheet), "{name:?} {size:?}: {text:?} is cut: {rect:?}");
                    for (other, taken) in &boxes[i + 1..] {
                        let rect = rect.grown(-1.0);
                        assert!(!rect.overlaps(*taken), "{name:?} {size:?}: {text:?} covers {other:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn every_point_has_a_spot_in_its_place() {
    let drawn = draw(&scatter(), SIZES[0], ThemeName::Dark.theme(), Some([0, 0]));
    assert_eq!(drawn.spots.len(), 6);
    let at = |point: [usize; 2]| drawn.spots.iter().find(|spot| spot.point == point).expect("a spot").at;
    let [[exact_x, exact_y], [rounded_x, rounded_y]] = [at([0, 1]), at([1, 0])];
    assert!(exact_x < rounded_x && exact_y < rounded_y, "less error is left, more time is up");
    assert_eq!(at([0, 0])[0], exact_x, "all exact ones stand in one lane");
    assert!(at([1, 1])[0] > at([1, 2])[0], "what is not finite is beyond all numbers");
    assert!(drawn.figure.texts().any(|text| text == "Cohen–Sutherland"));
}

#[test]
fn panels_number_their_points_one_after_the_other() {
    let both = panels(&[scatter(), bars()], 2, [1_600.0, 600.0], ThemeName::Light.theme());
    assert_eq!(both.spots.len(), 12);
    let of_bars = both.spots.iter().filter(|spot| spot.point[0] >= 2);
    assert!(of_bars.clone().count() == 6 && of_bars.clone().all(|spot| spot.at[0] > 800.0));
}

#[test]
fn nothing_measured_draws_axes_all_the_same() {
    let empty = Plot { series: Vec::new(), guides: Vec::new(), ..scatter() };
    for size in [[20.0, 20.0], [300.0, 200.0]] {
        let drawn = draw(&empty, size, ThemeName::Projector.theme(), Some([3, 3]));
        assert!(drawn.spots.is_empty() && !drawn.figure.shapes.is_empty());
    }
}

#[test]
fn the_name_of_a_guide_is_on_no_bar_if_there_is_room() {
    let names = ["cube", "tetrahedron", "icosphere", "pawn", "trefoil"].map(str::to_owned);
    let points: Vec<_> =
        [1.0, 1.0, 1.1, 1.2, 1.4].iter().enumerate().map(|(i, y)| ([i as f64, *y], "")).collect();
    let plot = Plot {
        title: "It pays to cull before clipping.".into(),
        subtitle: String::new(),
        axes: [
            Axis::new("model".into(), Scale::Names(names.into())),
            Axis::new("time of culling late, by that of early".into(), Scale::Linear),
        ],
        series: vec![series("time", Role::Accepted, &points)],
        guides: vec![Guide { at: 1.0, label: "no difference".into() }],
        frontier: None,
        foot: String::new(),
    };
    for theme in ThemeName::ALL.map(ThemeName::theme) {
        // Larger words need wider gaps.
        let wide = if theme.name == ThemeName::Projector { 1_100.0 } else { 870.0 };
        let drawn = draw(&plot, [wide, 640.0], theme, None);
        let bar = theme.style(Role::Accepted).color;
        let label = drawn.figure.shapes.iter().find_map(|shape| match shape {
            Shape::Text { at, text, font, size, .. } if text == "no difference" => {
                let extent = text::measure(*font, *size, text);
                Some(Rect {
                    min: at.map(f64::from),
                    max: [at[0] + extent[0], at[1] + extent[1]].map(f64::from),
                })
            }
            _ => None,
        });
        let label = label.expect("the guide has a name");
        let bars = drawn.figure.shapes.iter().filter_map(|shape| match shape {
            Shape::Rect { min, max, fill: Some(fill), .. } if *fill == bar => {
                Some(Rect { min: min.map(f64::from), max: max.map(f64::from) })
            }
            _ => None,
        });
        let bars: Vec<_> = bars.collect();
        assert_eq!(bars.len(), 5);
        assert!(bars.iter().all(|bar| !bar.overlaps(label)), "{label:?}");
    }
}
