mod crowded;

use rasterscope_core::message::Value;

use super::*;
use crate::{
    figure::Align,
    text,
    theme::{Color, ThemeName},
};

const SIZE: [f32; 2] = [692.0, 576.0];

fn units() -> View {
    View { min: [0.0, 0.0], max: [12.0, 10.0], y_up: true, grid: Grid::Units }
}

fn pixels(max: [f32; 2]) -> View {
    View { min: [0.0, 0.0], max, y_up: false, grid: Grid::Pixels }
}

fn drawn(marks: &[Mark], view: &View) -> Figure {
    let placement = Placement::fit(view, SIZE, 10.0);
    draw(marks, view, &placement, SIZE, ThemeName::Light.theme(), &Words::default())
}

fn point(at: [f32; 2], name: &str) -> Mark {
    Mark::Point { at, role: Role::Neutral, label: Some(Label::new(name, at)) }
}

/// Boxes of all texts.
fn boxes(figure: &Figure) -> Vec<Rect> {
    let boxes = figure.shapes.iter().filter_map(|shape| match shape {
        Shape::Text { at, align, text, font, size, .. } => {
            let extent = text::measure(*font, *size, text);
            let min = text::corner(*at, *align, extent);
            let max = [min[0] + extent[0], min[1] + extent[1]];
            Some(Rect { min: min.map(f64::from), max: max.map(f64::from) })
        }
        _ => None,
    });
    boxes.collect()
}

fn assert_readable(figure: &Figure) {
    let canvas = Rect { min: [0.0; 2], max: figure.size.map(f64::from) };
    let boxes = boxes(figure);
    for (i, a) in boxes.iter().enumerate() {
        assert!(a.inside(canvas), "{a:?} is cut off");
        for b in &boxes[i + 1..] {
            assert!(!a.overlaps(*b), "{a:?} covers {b:?}");
        }
    }
}

#[test]
fn plates_never_cover_each_other_nor_leave_the_canvas() {
    // A crowd in a corner, and points along all sides.
    let mut marks: Vec<_> = (0..8).map(|i| point([0.2 * i as f32, 9.8 - 0.1 * i as f32], "P")).collect();
    marks.extend((0..12).map(|i| point([i as f32, 0.0], "Q")));
    let figure = drawn(&marks, &units());
    assert!(figure.texts().count() >= 12);
    assert_readable(&figure);
}

#[test]
fn at_most_twelve_plates_show_values() {
    let marks: Vec<_> = (0..20).map(|i| point([0.6 * i as f32, (i % 5) as f32 * 2.0], "P")).collect();
    let figure = drawn(&marks, &units());
    let valued = figure.texts().filter(|text| text.contains('(')).count();
    assert_eq!(valued, 12);
    assert!(figure.texts().any(|text| text == "P"));
}

#[test]
fn labels_leave_the_line_of_the_step_free() {
    let line = [[1.0, 5.0], [11.0, 5.5]];
    let marks = [
        Mark::Segment { ends: line, role: Role::Active, label: None },
        point(line[0], "A"),
        point([6.0, 5.25], "M"),
        point(line[1], "B"),
    ];
    let figure = drawn(&marks, &units());
    let placement = Placement::fit(&units(), SIZE, 10.0);
    let ends = line.map(|p| placement.wide(p.map(f64::from)));
    assert_eq!(figure.texts().count(), 3);
    assert!(boxes(&figure).iter().all(|text| text.clip(ends).is_none()));
}

#[test]
fn held_labels_keep_their_side_while_their_point_moves() {
    let words = Words::default();
    let placement = Placement::fit(&units(), SIZE, 10.0);
    let draw = |x: f32, held: Option<&Places>| {
        let marks = [point([x, 5.0], "P"), point([6.0, 5.0], "Q")];
        draw_held(&marks, &units(), &placement, SIZE, (ThemeName::Dark.theme(), &words), held)
    };
    let (_, places) = draw(2.0, None);
    let (_, moved) = draw(5.0, Some(&places));
    assert_eq!(places, moved);
    assert_ne!(draw(5.0, None).1, places);
}

#[test]
fn a_label_that_does_not_fit_beside_its_point_has_a_leader_line() {
    let view = units();
    let mut marks = vec![point([6.0, 5.0], "C")];
    // Two crossing lines of the step leave no place beside the point.
    for ends in [
        [[0.0, 5.0], [12.0, 5.0]],
        [[6.0, 0.0], [6.0, 10.0]],
        [[5.2, 4.2], [6.8, 5.8]],
        [[5.2, 5.8], [6.8, 4.2]],
    ] {
        marks.push(Mark::Segment { ends, role: Role::Active, label: None });
    }
    let leaders = |figure: &Figure| {
        let dim = ThemeName::Light.theme().dim;
        let is_leader = |shape: &&Shape| matches!(shape, Shape::Line { stroke, .. } if stroke.color == dim);
        figure.shapes.iter().filter(is_leader).count()
    };
    let figure = drawn(&marks, &view);
    assert_eq!((leaders(&figure), figure.texts().count()), (1, 1));
    assert_eq!(leaders(&drawn(&marks[..1], &view)), 0);
}

#[test]
fn marks_of_any_size_draw_something_bounded() {
    let huge = f32::MAX / 2.0;
    let mut marks = vec![
        Mark::Polygon {
            points: vec![[-huge, -huge], [huge, -huge], [0.0, huge]],
            role: Role::Rejected,
            object: Some(9),
            label: Some(Label::name("T")),
        },
        Mark::Guide { axis: 0, at: f32::NAN, role: Role::Active, label: None, note: None },
        Mark::Span { y: i32::MAX, ends: [f32::NEG_INFINITY, huge], role: Role::Active },
        Mark::Pixel { at: [i32::MIN, 3], role: Role::Active, object: None, value: Value::F32(1.0) },
        Mark::Text { at: [huge, 0.0], label: Label::name("x"), role: Role::Tie, big: true },
        Mark::Image { size: [3, 3], rgba: std::sync::Arc::new(vec![0; 5]) },
    ];
    for role in Role::ALL {
        marks.push(Mark::Segment { ends: [[-huge, 3.0], [huge, f32::MIN_POSITIVE]], role, label: None });
        marks.push(Mark::Point { at: [f32::NAN, 1.0], role, label: Some(Label::name("P")) });
    }
    for view in [units(), pixels([8.0, 8.0]), View { min: [-huge; 2], max: [huge; 2], ..units() }] {
        let figure = drawn(&marks, &view);
        assert!(figure.shapes.len() < 2000, "{}", figure.shapes.len());
        let near = |p: &[f32; 2]| p.iter().all(|c| c.is_finite() && c.abs() < 2000.0);
        for shape in &figure.shapes {
            match shape {
                Shape::Fill { points, .. } | Shape::Line { points, .. } => assert!(points.iter().all(near)),
                Shape::Circle { center: at, .. } | Shape::Text { at, .. } => assert!(near(at)),
                Shape::Rect { min, .. } => assert!(near(min), "{min:?}"),
                Shape::Image { .. } => {}
                Shape::Inset { .. } => panic!("a drawing of marks holds no other drawing"),
            }
        }
    }
}

#[test]
fn dashes_do_not_crawl_when_a_line_is_clipped() {
    let segment = |ends| Mark::Segment { ends, role: Role::Rejected, label: None };
    let line = |figure: &Figure| {
        let found = figure.shapes.iter().find_map(|shape| match shape {
            Shape::Line { points, stroke, .. } if !stroke.dash.is_empty() => Some((points.clone(), *stroke)),
            _ => None,
        });
        found.unwrap()
    };
    let (whole, stroke) = line(&drawn(&[segment([[1.0, 5.0], [11.0, 5.0]])], &units()));
    assert_eq!(stroke.phase, 0.0);
    let (clipped, stroke) = line(&drawn(&[segment([[-40.0, 5.0], [11.0, 5.0]])], &units()));
    let scale = Placement::fit(&units(), SIZE, 10.0).scale as f32;
    let walked = clipped[0][0] - (whole[0][0] - 41.0 * scale);
    assert!((walked.rem_euclid(12.0) - stroke.phase).abs() < 0.01);
}

#[test]
fn rulers_number_every_cell_from_forty_points_on_else_every_sixth() {
    let ruler = |max| {
        let figure = drawn(&[], &pixels(max));
        figure.texts().map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(ruler([3.0, 2.0]), ["0", "1", "2", "0", "1"]);
    assert_eq!(ruler([36.0, 24.0]), ["0", "6", "12", "18", "24", "30", "0", "6", "12", "18"]);
    assert_readable(&drawn(&[], &pixels([1000.0, 900.0])));
}

#[test]
fn values_appear_when_their_cells_have_room() {
    let marks: Vec<_> = (0..4)
        .map(|x| Mark::Pixel { at: [x, 0], role: Role::Neutral, object: Some(0), value: Value::F32(0.25) })
        .collect();
    let view = pixels([8.0, 8.0]);
    let texts = |scale: f64| {
        let placement = Placement { scale, offset: [40.0; 2], y_up: false };
        assert_eq!(hidden_values(&marks, &placement).is_some(), scale < 18.0);
        let figure = draw(&marks, &view, &placement, SIZE, ThemeName::Dark.theme(), &Words::default());
        figure.texts().filter(|text| *text == "0.25").count()
    };
    assert_eq!([texts(64.0), texts(17.0)], [4, 0]);
}

#[test]
fn cells_keep_three_decimals_and_clear_cells_say_one() {
    let pixel =
        |x, object, value: f32| Mark::Pixel { at: [x, 0], role: Role::Neutral, object, value: value.into() };
    let marks = [pixel(0, None, 1.0), pixel(1, Some(0), 0.35), pixel(2, Some(1), 0.317_25)];
    let figure = drawn(&marks, &pixels([8.0, 8.0]));
    let values: Vec<_> = figure.texts().filter(|text| text.contains('.') || *text == "1").collect();
    assert_eq!(values[values.len() - 3..], ["1", "0.350", "0.317"]);
}

#[test]
fn equal_neighbours_are_one_rectangle() {
    let marks: Vec<_> = (0..6)
        .map(|x| Mark::Pixel {
            at: [x, 1],
            role: Role::Neutral,
            object: Some(usize::from(x > 2)),
            value: Value::None,
        })
        .collect();
    let figure = drawn(&marks, &pixels([8.0, 8.0]));
    assert_eq!(figure.shapes.iter().filter(|shape| matches!(shape, Shape::Rect { .. })).count(), 2);
}

#[test]
fn rejected_areas_are_hatched_and_later_objects_too() {
    let triangle = |role, object| Mark::Polygon {
        points: vec![[1.0, 1.0], [9.0, 1.0], [5.0, 9.0]],
        role,
        object,
        label: None,
    };
    let count = |mark: Mark| drawn(&[mark], &View { grid: Grid::None, ..units() }).shapes.len();
    let plain = count(triangle(Role::Neutral, Some(0)));
    assert_eq!(plain, 2);
    assert!(count(triangle(Role::Rejected, None)) > 10);
    assert!(count(triangle(Role::Neutral, Some(4))) > 10);
}

#[test]
fn an_image_keeps_its_first_row_at_its_first_row() {
    let rgba = std::sync::Arc::new(vec![1, 1, 1, 1, 2, 2, 2, 2]);
    for y_up in [false, true] {
        let view = View { y_up, ..pixels([1.0, 2.0]) };
        let figure = drawn(&[Mark::Image { size: [1, 2], rgba: rgba.clone() }], &view);
        let Some(Shape::Image { rgba, min, max, .. }) = figure.shapes.first() else { panic!("no image") };
        assert_eq!(rgba[0], if y_up { 2 } else { 1 });
        assert!(min[1] < max[1]);
    }
}

#[test]
fn every_role_draws_in_its_own_colour_in_every_theme() {
    for name in ThemeName::ALL {
        let theme = name.theme();
        for role in Role::ALL {
            let marks = [
                Mark::Point { at: [2.0, 2.0], role, label: None },
                Mark::Segment { ends: [[1.0, 1.0], [3.0, 3.0]], role, label: None },
            ];
            let placement = Placement::fit(&units(), SIZE, 10.0);
            let figure = draw(&marks, &units(), &placement, SIZE, theme, &Words::default());
            let color: Color = theme.style(role).color;
            let wears = |shape: &&Shape| match shape {
                Shape::Line { stroke, .. } => stroke.color == color,
                Shape::Fill { color: own, .. } => *own == color,
                Shape::Circle { fill, stroke, .. } | Shape::Rect { fill, stroke, .. } => {
                    *fill == Some(color) || stroke.is_some_and(|stroke| stroke.color == color)
                }
                _ => false,
            };
            assert!(figure.shapes.iter().filter(wears).count() >= 2, "{name:?} {role:?}");
        }
    }
}

#[test]
fn no_label_lacks_a_glyph() {
    let label = Label::new("P1′ ⌈x⌉ ≤ ∞", [-0.25_f32, 1e-9]);
    let figure = drawn(&[Mark::Point { at: [6.0, 5.0], role: Role::Tie, label: Some(label) }], &units());
    for shape in &figure.shapes {
        if let Shape::Text { text, font, size, align, .. } = shape {
            assert_eq!(text::layout(*font, *size, text).missing, []);
            assert_eq!(*align, [Align::Center, Align::Center]);
        }
    }
}

#[test]
fn names_of_areas_wear_their_object_and_stand_inside_their_own() {
    let triangle = |x: f32, object| Mark::Polygon {
        points: vec![[x, 1.0], [x + 7.0, 1.0], [x + 3.5, 9.0]],
        role: Role::Neutral,
        object: None,
        label: Some(Label::name(["A", "B"][object]).of(object)),
    };
    let theme = ThemeName::Light.theme();
    let figure = drawn(&[triangle(0.5, 0), triangle(3.5, 1)], &units());
    let placement = Placement::fit(&units(), SIZE, 10.0);
    for (object, free) in [(0, 0.5..4.6), (1, 6.4..10.5)] {
        let plate = figure.shapes.iter().find_map(|shape| match shape {
            Shape::Rect { min, max, fill, .. } if *fill == Some(theme.objects[object]) => {
                Some(placement.to_scene([(min[0] + max[0]) / 2.0, (min[1] + max[1]) / 2.0]))
            }
            _ => None,
        });
        let [x, _] = plate.expect("a plate in the object's colour");
        assert!(free.contains(&x), "object {object} is named at {x}");
    }
    assert_readable(&figure);
}

#[test]
fn no_lines_run_over_a_picture_whose_pixels_are_small() {
    let lines = |pictured: bool, size: f32| {
        let rgba = std::sync::Arc::new(vec![7; 4 * (size * size) as usize]);
        let picture = Mark::Image { size: [size as usize; 2], rgba };
        let figure = drawn(if pictured { std::slice::from_ref(&picture) } else { &[] }, &pixels([size; 2]));
        figure.shapes.iter().filter(|shape| matches!(shape, Shape::Line { .. })).count()
    };
    assert_eq!(lines(true, 600.0), 4, "the frame stays");
    assert!(lines(false, 600.0) > 4 && lines(true, 20.0) > 40);
}

#[test]
fn a_text_whose_place_is_taken_stands_below() {
    let text = |name: &str, big| Mark::Text {
        at: [0.0, 10.0],
        label: Label::name(name),
        role: Role::Candidate,
        big,
    };
    let figure = drawn(&[text("1001", true), text("T B R L", false)], &units());
    let [code, legend] = boxes(&figure)[..] else { panic!("two texts") };
    assert!(legend.min[1] >= code.max[1] && (legend.min[0] - code.min[0]).abs() < 1.0);
}

#[test]
fn the_note_of_a_line_stands_beside_it() {
    let note = Some(Message::new("figure-dark"));
    let line = Mark::Guide { axis: 1, at: 5.0, role: Role::Active, label: Some(Label::new("y", 5.0)), note };
    let figure = drawn(&[line], &units());
    assert!(figure.texts().any(|text| text == "Dark"));
    assert_readable(&figure);
}
