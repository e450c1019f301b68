//! The crate parry2d-f64: a segment against an axis-aligned box.

use super::{Lines, wide};
use crate::{
    lines::{Segment, Sides},
    measure::Each,
};
use parry2d_f64::{bounding_volume::Aabb, math::Vector};

pub fn lines(segments: &[Segment], sides: Sides, list: &mut Lines) {
    let [xmin, ymin, xmax, ymax] = sides.map(f64::from);
    let window = Aabb::new(Vector::new(xmin, ymin), Vector::new(xmax, ymax));
    list.push(Box::new(Each::new(
        "parry2d-f64 0.31.1, clip_segment",
        segments.iter().map(|segment| segment.map(|p| Vector::from(wide(p)))).collect(),
        move |&[p, q]: &[Vector; 2]| window.clip_segment(p, q),
        |part| part.map(|part| [part.a, part.b].map(|p| [p.x, p.y])),
    )));
}
