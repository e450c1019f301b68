//! The crate line-clipping: Cohen-Sutherland and Sutherland-Hodgman in binary64.

use super::{Lines, wide};
use crate::{
    lines::{Segment, Sides},
    measure::Each,
};
use line_clipping::{LineSegment, Point, Window, cohen_sutherland::clip_line};

fn point(p: [f32; 2]) -> Point {
    let [x, y] = wide(p);
    Point::new(x, y)
}

fn window([xmin, ymin, xmax, ymax]: Sides) -> Window {
    let [xmin, ymin, xmax, ymax] = [xmin, ymin, xmax, ymax].map(f64::from);
    Window::new(xmin, xmax, ymin, ymax)
}

pub fn lines(segments: &[Segment], sides: Sides, list: &mut Lines) {
    let window = window(sides);
    list.push(Box::new(Each::new(
        "line-clipping 0.3.8, Cohen-Sutherland",
        segments.iter().map(|&[p, q]| LineSegment::new(point(p), point(q))).collect(),
        move |segment| clip_line(*segment, window),
        |part| part.map(|LineSegment { p1, p2 }| [[p1.x, p1.y], [p2.x, p2.y]]),
    )));
}
