//! The canvas's part of [`Links`](crate::link::Links): which mark the pointer is on, and a raised
//! ground under the marks that another panel points at.

use super::handles::Plane;
use crate::{face::Face, link::Thing, theme::Text};
use egui::{Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Vec2, pos2, vec2};
use rasterscope_core::explain::{Grid, Label, Mark, View};

/// A mark is pointed at from this near.
const REACH: f32 = 9.0;
/// How much wider than a mark its ground is.
const WIDTH: f32 = 12.0;

/// What the pointer is on: the nearest mark with a name, else the row of pixels.
pub(super) fn pointed(plane: &Plane, marks: &[Mark], view: &View, at: Pos2) -> Option<Thing> {
    let near = marks.iter().filter_map(|mark| Some((named(mark)?, distance(plane, mark, at)?)));
    let near = near.filter(|(_, far)| *far <= REACH);
    let nearest = near.min_by(|a, b| a.1.total_cmp(&b.1));
    if let Some((name, _)) = nearest {
        return Some(Thing::Name(name.to_owned()));
    }
    let [x, y] = plane.point(at);
    let inside = (view.min[0]..view.max[0]).contains(&x) && (view.min[1]..view.max[1]).contains(&y);
    (view.grid == Grid::Pixels && inside).then_some(Thing::Row(y.floor() as i64))
}

/// Paints what lies under the marks that are lit; called before the drawing.
pub(super) fn under(painter: &Painter, face: &Face<'_>, plane: &Plane, marks: &[Mark]) {
    if face.links.now().is_none() {
        return;
    }
    let stroke = Stroke::new(WIDTH, face.look.raised);
    for mark in marks.iter().filter(|mark| named(mark).is_some_and(|name| face.links.name(name))) {
        match mark {
            Mark::Point { at, .. } => {
                painter.circle_filled(plane.place(*at), WIDTH, face.look.raised);
            }
            _ => lines(plane, mark).into_iter().for_each(|ends| {
                painter.line_segment(ends, stroke);
            }),
        }
    }
}

/// Paints what lies round a row of pixels that is lit; called after the drawing.
pub(super) fn over(painter: &Painter, face: &Face<'_>, plane: &Plane, view: &View) {
    let Some(Thing::Row(y)) = face.links.now() else { return };
    if view.grid == Grid::Pixels {
        let y = *y as f32;
        let corners = [[view.min[0], y], [view.max[0], y + 1.0]].map(|at| plane.place(at));
        let row = Rect::from_two_pos(corners[0], corners[1]);
        painter.rect_stroke(row, 0, face.look.stroke(1.5, face.look.edge), StrokeKind::Outside);
    }
}

/// Outlines the triangle under the pointer and names it; called after the drawing.
pub(super) fn triangle(painter: &Painter, face: &Face<'_>, plane: &Plane, corners: &[[f32; 2]], name: &str) {
    let corners: Vec<Pos2> = corners.iter().map(|at| plane.place(*at)).collect();
    if corners.is_empty() {
        return;
    }
    let sum = corners.iter().fold(Vec2::ZERO, |sum, at| sum + at.to_vec2());
    let middle = sum / corners.len() as f32;
    for (width, color) in [(6.0, face.look.canvas), (3.0, face.look.text)] {
        painter.add(Shape::closed_line(corners.clone(), Stroke::new(width, color)));
    }
    let galley = painter.layout_no_wrap(name.to_owned(), face.look.font(Text::MonoStrong), face.look.text);
    let plate = Rect::from_center_size(middle.to_pos2(), galley.size() + vec2(10.0, 4.0));
    // What is seen of a small triangle stays in sight beside its plate.
    let small = Rect::from_points(&corners).height() < 3.0 * plate.height();
    let plate = if small { plate.translate(vec2(0.0, -1.5 * plate.height())) } else { plate };
    painter.rect_filled(plate, 3, face.look.canvas);
    painter.galley(plate.center() - galley.size() / 2.0, galley, face.look.text);
}

/// The name that a mark bears.
fn named(mark: &Mark) -> Option<&str> {
    let label = match mark {
        Mark::Point { label, .. }
        | Mark::Segment { label, .. }
        | Mark::Curve { label, .. }
        | Mark::Guide { label, .. }
        | Mark::Polygon { label, .. } => label,
        _ => return None,
    };
    label.as_ref().map(|label: &Label| label.name.as_str()).filter(|name| !name.is_empty())
}

/// The lines of a mark on the screen.
fn lines(plane: &Plane, mark: &Mark) -> Vec<[Pos2; 2]> {
    let along = |points: &[[f32; 2]], closed: bool| {
        let places: Vec<Pos2> = points.iter().map(|at| plane.place(*at)).collect();
        let last = places.last().copied().zip(places.first().copied()).filter(|_| closed);
        let mut lines: Vec<[Pos2; 2]> = places.windows(2).map(|ends| [ends[0], ends[1]]).collect();
        lines.extend(last.map(|(end, start)| [end, start]));
        lines
    };
    match mark {
        Mark::Segment { ends, .. } => along(ends, false),
        Mark::Curve { points, .. } => along(points, false),
        Mark::Polygon { points, .. } => along(points, true),
        Mark::Guide { axis, at, .. } => {
            let place = plane.place([*at; 2]);
            let rect = plane.rect;
            vec![if *axis == 0 {
                [pos2(place.x, rect.top()), pos2(place.x, rect.bottom())]
            } else {
                [pos2(rect.left(), place.y), pos2(rect.right(), place.y)]
            }]
        }
        _ => Vec::new(),
    }
}

/// How far a mark is from a place on the screen; a point is nearer than a line through it.
fn distance(plane: &Plane, mark: &Mark, from: Pos2) -> Option<f32> {
    if let Mark::Point { at, .. } = mark {
        return Some((plane.place(*at).distance(from) - REACH).max(0.0));
    }
    let far = |[a, b]: [Pos2; 2]| {
        let along = b - a;
        let t = ((from - a).dot(along) / along.length_sq().max(1e-9)).clamp(0.0, 1.0);
        (a + along * t).distance(from)
    };
    lines(plane, mark).into_iter().map(far).min_by(f32::total_cmp).map(|far| far + 0.5)
}
