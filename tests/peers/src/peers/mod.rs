//! One file a crate: its call, the form it takes its input in, and how its answer is read.

mod agg;
mod clipper2;
mod engine;
mod euc;
mod geo;
mod i_overlay;
mod line_clipping;
mod parry;
mod pipeline;
mod rasterscope;
mod retrofire;
mod s2;
mod tiny_skia;

use crate::{
    frames::Soup,
    lines::{self, Segment, Sides},
    measure::Contender,
    meshes::Sight,
    painter::Maker,
    polygons::{self, Polygon},
};

/// A list that each crate adds itself to.
pub type Lines = Vec<Box<dyn Contender<lines::Answer>>>;

/// Everybody who clips segments.
pub fn lines(segments: &[Segment], window: Sides, list: &mut Lines) {
    rasterscope::lines(segments, window, list);
    line_clipping::lines(segments, window, list);
    agg::lines(segments, window, list);
    s2::lines(segments, window, list);
    parry::lines(segments, window, list);
    geo::lines(segments, window, list);
}

/// A list that each crate adds itself to.
pub type Polygons = Vec<Box<dyn Contender<polygons::Answer>>>;

/// Everybody who clips polygons.
pub fn polygons(polygons: &[Polygon], window: Sides, list: &mut Polygons) {
    rasterscope::polygons(polygons, window, list);
    line_clipping::polygons(polygons, window, list);
    clipper2::polygons(polygons, window, list);
    i_overlay::polygons(polygons, window, list);
    geo::polygons(polygons, window, list);
}

/// Binary32 is exact in binary64.
fn wide(p: [f32; 2]) -> [f64; 2] {
    p.map(f64::from)
}

/// Everybody who draws frames.
pub fn painters() -> Vec<Maker<Soup>> {
    let mut makers = engine::painters();
    makers.push(Box::new(euc::painter));
    makers.push(Box::new(retrofire::painter));
    makers.push(Box::new(tiny_skia::painter));
    makers
}

/// Everybody who draws meshes through a pipeline.
pub fn mesh_painters() -> Vec<Maker<Sight>> {
    let mut makers = Vec::from(pipeline::mesh_painters());
    makers.push(Box::new(euc::mesh_painter));
    makers.push(Box::new(retrofire::mesh_painter));
    makers
}
