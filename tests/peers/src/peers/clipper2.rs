//! The crate clipper2-rust: a port of Clipper2, whose RectClip works on integers; binary64 is scaled.

use super::{Polygons, wide};
use crate::{lines::Sides, measure::Each, polygons::Polygon};
use clipper2_rust::{PathD, PathsD, PointD, RectD, rect_clip_d};

/// Decimal places that are kept: the most it takes.
const PRECISION: i32 = 8;

pub fn polygons(polygons: &[Polygon], sides: Sides, list: &mut Polygons) {
    let [xmin, ymin, xmax, ymax] = sides.map(f64::from);
    let window = RectD::new(xmin, ymin, xmax, ymax);
    list.push(Box::new(Each::new(
        "clipper2-rust 1.2.0, rect_clip",
        polygons
            .iter()
            .map(|polygon| {
                let path: PathD = polygon.iter().map(|&p| PointD { x: wide(p)[0], y: wide(p)[1] }).collect();
                vec![path]
            })
            .collect(),
        move |polygon: &PathsD| rect_clip_d(&window, polygon, PRECISION),
        |pieces| pieces.iter().map(|piece| piece.iter().map(|p| [p.x, p.y]).collect()).collect(),
    )));
}
