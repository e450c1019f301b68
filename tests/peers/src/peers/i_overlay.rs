//! The crate i_overlay: Boolean operations on any shapes.

use super::{Polygons, wide};
use crate::{lines::Sides, measure::Each, polygons::Polygon};
use i_overlay::{
    core::{fill_rule::FillRule, overlay_rule::OverlayRule},
    float::single::SingleFloatOverlay,
};

pub fn polygons(polygons: &[Polygon], sides: Sides, list: &mut Polygons) {
    let [xmin, ymin, xmax, ymax] = sides.map(f64::from);
    let window = vec![[xmin, ymin], [xmax, ymin], [xmax, ymax], [xmin, ymax]];
    list.push(Box::new(Each::new(
        "i_overlay 9.1.0, intersection",
        polygons.iter().map(|polygon| polygon.iter().map(|&p| wide(p)).collect()).collect(),
        move |polygon: &Vec<[f64; 2]>| polygon.overlay(&window, OverlayRule::Intersect, FillRule::NonZero),
        |shapes| shapes.iter().flatten().cloned().collect(),
    )));
}
