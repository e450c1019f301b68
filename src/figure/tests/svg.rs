//! SVG and PNG are one picture: an independent renderer draws the SVG file as the PNG file shows it.

use std::sync::Arc;

use rasterscope_core::{
    compare::Pair,
    explain::{Grid, Label, Mark, Role, Sign, View},
    message::{Message, Value},
    replay::Budget,
    scene::{Scene, preset},
};
use rasterscope_figure::{
    figure::{Figure, Shape},
    layout::{self, Placement},
    png, split, svg,
    theme::ThemeName,
    words::Words,
};
use resvg::{tiny_skia::Pixmap, usvg};

const SIZE: [f32; 2] = [360.0, 322.0];

/// Every kind of mark in every role.
fn marks() -> Vec<Mark> {
    let mut marks = Vec::new();
    for (i, role) in Role::ALL.into_iter().enumerate() {
        let [x, y] = [(i % 5) as f32 * 2.0, (i / 5) as f32 * 4.0];
        let label = Some(Label::new("P1′", [x, y]));
        marks.push(Mark::Point { at: [x + 0.5, y + 0.5], role, label: label.clone() });
        marks.push(Mark::Segment { ends: [[x, y + 1.0], [x + 1.5, y + 2.0]], role, label: None });
        let points = vec![[x, y + 2.0], [x + 1.6, y + 2.0], [x + 0.4, y + 2.4], [x, y + 3.6]];
        let bent = vec![[x, y + 3.8], [x + 0.5, y + 3.2], [x + 1.6, y + 3.6]];
        marks.push(Mark::Curve { points: bent, role, label: None });
        marks.push(Mark::Polygon { points, role, object: (i > 3).then_some(i), label: None });
        marks.push(Mark::Pixel { at: [i as i32, 8], role, object: Some(i), value: Value::F32(0.25) });
        marks.push(Mark::Guide { axis: 0, at: x + 1.9, role, label, note: None });
    }
    for sign in [Sign::Marker, Sign::Line] {
        marks.push(Mark::Key { role: Role::Rejected, sign, meaning: Message::new("figure-dark") });
    }
    marks.push(Mark::Span { y: 9, ends: [1.25, 7.5], role: Role::Active });
    marks.push(Mark::Text { at: [0.0, 4.0], label: Label::name("⌈0101⌉"), role: Role::Tie, big: true });
    marks
}

fn rendered(svg: &str, [width, height]: [u32; 2]) -> Pixmap {
    let tree = usvg::Tree::from_str(svg, &usvg::Options::default()).expect("our SVG files are valid");
    let mut pixmap = Pixmap::new(width, height).unwrap();
    resvg::render(&tree, usvg::Transform::default(), &mut pixmap.as_mut());
    pixmap
}

#[test]
fn an_independent_renderer_sees_the_same_picture() {
    for theme in ThemeName::ALL {
        for grid in [Grid::None, Grid::Units, Grid::Pixels] {
            let view = View { min: [0.0; 2], max: [11.0, 10.0], y_up: grid == Grid::Units, grid };
            let placement = Placement::fit(&view, SIZE, 8.0);
            let figure = layout::draw(&marks(), &view, &placement, SIZE, theme.theme(), &Words::default());
            let ours = png::pixmap(&figure, 1.0);
            let theirs = rendered(&svg::svg(&figure), [ours.width(), ours.height()]);
            // Coordinates in the file are rounded to a hundredth of a point.
            let far = |(a, b): (&u8, &u8)| a.abs_diff(*b) > 24;
            let differ = ours.data().iter().zip(theirs.data()).filter(|&pair| far(pair)).count();
            assert!(differ < ours.data().len() / 2000, "{} {grid:?}: {differ} values differ", theme.name());
        }
    }
}

#[test]
fn a_file_with_a_picture_in_it_is_read_by_others() {
    let rgba = Arc::new([10, 20, 30, 255].repeat(6));
    let shapes = vec![Shape::Image { min: [0.0; 2], max: [30.0, 20.0], size: [3, 2], rgba }];
    let figure = Figure { size: [30.0, 20.0], background: ThemeName::Dark.theme().canvas, shapes };
    assert!(usvg::Tree::from_str(&svg::svg(&figure), &usvg::Options::default()).is_ok());
}

/// Two sides are drawings in a drawing: nothing of one may run into the other.
#[test]
fn an_independent_renderer_sees_the_same_two_sides() {
    let preset = preset("two-sides-tie").expect("it is one");
    let scene = Scene::from_json(preset.json.as_bytes()).expect("it can be read");
    let setting = scene.compared().expect("it compares");
    let own = [setting.of(&scene).expect("it has one"), setting];
    let mut pair = Pair::play(&scene, Budget::default()).expect("it compares").expect("it runs");
    pair.seek(pair.len());
    let size = [760.0, 480.0];
    for theme in ThemeName::ALL {
        let figure = split::draw(&pair, own, size, 24.0, theme.theme(), &Words::default());
        let texts: Vec<_> = figure.texts().collect();
        assert!(texts.contains(&"top-left") && texts.contains(&"inclusive"), "{texts:?}");
        let ours = png::pixmap(&figure, 1.0);
        let theirs = rendered(&svg::svg(&figure), [ours.width(), ours.height()]);
        let far = |(a, b): (&u8, &u8)| a.abs_diff(*b) > 24;
        let differ = ours.data().iter().zip(theirs.data()).filter(|&pair| far(pair)).count();
        assert!(differ < ours.data().len() / 2000, "{}: {differ} values differ", theme.name());
    }
}
