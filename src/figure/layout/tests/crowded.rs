//! What stands close together: values in cells, names of curves, lines over pictures.

use super::*;

/// A pixel with a verdict, and then the pixel in hand with the value there.
fn tested(x: i32, value: f32) -> [Mark; 2] {
    let mark = |role, value| Mark::Pixel { at: [x, 0], role, object: Some(0), value };
    [mark(Role::Accepted, Value::None), mark(Role::Active, Value::F32(value))]
}

#[test]
fn a_plate_never_cuts_the_verdict_in_the_corner_of_its_cell() {
    let marks = tested(0, 0.584);
    for theme in ThemeName::ALL {
        let placement = Placement { scale: 53.0, offset: [40.0, 40.0], y_up: false };
        let view = pixels([2.0, 2.0]);
        let figure = draw(&marks, &view, &placement, SIZE, theme.theme(), &Words::default());
        let disc = figure
            .shapes
            .iter()
            .position(|shape| matches!(shape, Shape::Circle { radius, .. } if *radius > 6.0));
        let plate = figure
            .shapes
            .iter()
            .rposition(|shape| matches!(shape, Shape::Rect { radius, fill: Some(_), .. } if *radius == 3.0));
        assert!(disc.expect("it passed") > plate.expect("it has a value"), "{theme:?}");
    }
}

#[test]
fn values_of_neighbours_stand_apart_or_are_left_out() {
    let marks: Vec<_> = (0..6).flat_map(|x| tested(x, 0.381 + 0.063 * x as f32)).collect();
    let mut shown = 0;
    for scale in 18..80 {
        let placement = Placement { scale: scale.into(), offset: [40.0, 40.0], y_up: false };
        let view = pixels([6.0, 2.0]);
        let theme = ThemeName::Projector.theme();
        let figure = draw(&marks, &view, &placement, SIZE, theme, &Words::default());
        let values = figure.texts().filter(|text| text.contains('.')).count();
        assert!(values == 0 || values == 6, "{values} at {scale}");
        shown += values;
        let mut boxes: Vec<_> = boxes(&figure).into_iter().filter(|text| text.min[1] > 44.0).collect();
        boxes.retain(|text| text.min[0] > 44.0);
        for pair in boxes.windows(2) {
            assert!(pair[1].min[0] - pair[0].max[0] > 5.0, "{pair:?} at {scale}");
        }
    }
    assert!(shown > 0);
}

#[test]
fn the_name_of_a_curve_stands_on_no_other_curve() {
    // Two steep curves side by side: at the middle of either there is no room between them.
    let curve = |x: f32, name: &str| Mark::Curve {
        points: (0..=96).map(|i| [x + 0.02 * i as f32, 0.1 * i as f32]).collect(),
        role: Role::Candidate,
        label: Some(Label::name(name)),
    };
    let wall = |x: f32| Mark::Segment { ends: [[x, 3.0], [x, 7.0]], role: Role::Neutral, label: None };
    let marks = [curve(4.0, "unorm16"), curve(5.0, "unorm24"), wall(4.0), wall(7.0)];
    let view = units();
    let figure = drawn(&marks, &view);
    let placement = Placement::fit(&view, SIZE, 10.0);
    for mark in &marks[..2] {
        let Mark::Curve { points, .. } = mark else { continue };
        let points: Vec<_> = points.iter().map(|p| placement.wide(p.map(f64::from))).collect();
        for text in boxes(&figure).iter().filter(|text| text.max[0] - text.min[0] > 40.0) {
            assert!(points.windows(2).all(|ends| text.clip([ends[0], ends[1]]).is_none()), "{text:?}");
        }
    }
}

#[test]
fn lines_over_a_picture_have_a_strip_of_canvas() {
    let picture = Mark::Image { size: [1, 1], rgba: vec![0, 0, 0, 255].into() };
    let line = Mark::Segment { ends: [[1.0, 1.0], [6.0, 4.0]], role: Role::Neutral, label: None };
    let lines = |marks: &[Mark]| {
        let figure = drawn(marks, &pixels([8.0; 2]));
        let slanted = |shape: &&Shape| match shape {
            Shape::Line { points, .. } => points[0][0] != points[1][0] && points[0][1] != points[1][1],
            _ => false,
        };
        figure.shapes.iter().filter(slanted).count()
    };
    assert_eq!([lines(std::slice::from_ref(&line)), lines(&[picture, line.clone()])], [1, 2]);
}
