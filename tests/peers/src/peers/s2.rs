//! The crate s2rst: a port of S2, whose plane edges are binary64.

use super::{Lines, wide};
use crate::{
    lines::{Segment, Sides},
    measure::Each,
};
use s2rst::{
    r2::{Point, Rect},
    s2::edge_clipping::clip_edge,
};

fn point([x, y]: [f64; 2]) -> Point {
    Point { x, y }
}

pub fn lines(segments: &[Segment], sides: Sides, list: &mut Lines) {
    let [xmin, ymin, xmax, ymax] = sides.map(f64::from);
    let window = Rect::from_points(point([xmin, ymin]), point([xmax, ymax]));
    list.push(Box::new(Each::new(
        "s2rst 0.5.1, clip_edge",
        segments.iter().map(|&[p, q]| [point(wide(p)), point(wide(q))]).collect(),
        move |&[p, q]: &[Point; 2]| clip_edge(p, q, window),
        |part| part.map(|(p, q)| [[p.x, p.y], [q.x, q.y]]),
    )));
}
