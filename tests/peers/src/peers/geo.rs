//! The crate geo: a line string against a polygon. It clips any shapes, and pays for that.

use super::{Lines, wide};
use crate::{
    lines::{Segment, Sides},
    measure::Each,
};
use geo::{BooleanOps, Line, LineString, MultiLineString, Polygon, Rect};

pub fn lines(segments: &[Segment], sides: Sides, list: &mut Lines) {
    let [xmin, ymin, xmax, ymax] = sides.map(f64::from);
    let window: Polygon = Rect::new([xmin, ymin], [xmax, ymax]).to_polygon();
    list.push(Box::new(Each::new(
        "geo 0.33.1, clip",
        segments
            .iter()
            .map(|&[p, q]| MultiLineString::new(vec![LineString::from(Line::new(wide(p), wide(q)))]))
            .collect(),
        move |segment| window.clip(segment, false),
        |part: &MultiLineString| {
            let line = part.0.first()?;
            let (first, last) = (line.0.first()?, line.0.last()?);
            Some([[first.x, first.y], [last.x, last.y]])
        },
    )));
}
