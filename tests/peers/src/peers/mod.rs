//! One file a crate: its call, the form it takes its input in, and how its answer is read.

mod agg;
mod geo;
mod line_clipping;
mod parry;
mod rasterscope;
mod s2;

use crate::{
    lines::{self, Segment, Sides},
    measure::Contender,
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

/// Binary32 is exact in binary64.
fn wide(p: [f32; 2]) -> [f64; 2] {
    p.map(f64::from)
}
