//! The crate geo: a line string against a polygon. It clips any shapes, and pays for that.

use super::{Lines, Polygons, wide};
use crate::{
    lines::{Segment, Sides},
    measure::Each,
    polygons,
};
use geo::{BooleanOps, Line, LineString, MultiLineString, MultiPolygon, Polygon, Rect};

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

pub fn polygons(given: &[polygons::Polygon], sides: Sides, list: &mut Polygons) {
    let [xmin, ymin, xmax, ymax] = sides.map(f64::from);
    let window: Polygon = Rect::new([xmin, ymin], [xmax, ymax]).to_polygon();
    list.push(Box::new(Each::new(
        "geo 0.33.1, intersection",
        given
            .iter()
            .map(|polygon| Polygon::new(polygon.iter().map(|&p| wide(p)).collect::<LineString>(), Vec::new()))
            .collect(),
        move |polygon: &Polygon| polygon.intersection(&window),
        |pieces: &MultiPolygon| {
            // The last corner of a ring repeats the first.
            let open = |ring: &LineString| ring.0.iter().skip(1).map(|p| [p.x, p.y]).collect();
            pieces.0.iter().map(|piece| open(piece.exterior())).collect()
        },
    )));
}
