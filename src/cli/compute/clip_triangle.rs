//! `clip_triangle`: a triangle against the six planes of clip space.

use rasterscope_core::{
    clip::polygon::{PlaneSet, clip_triangle},
    math::{Arithmetic, Tally},
    transform::DepthRange,
};
use serde::Serialize;

use super::{Refusal, Request, wide};

/// The corners of what is left, turning like the triangle.
#[derive(Debug, Serialize)]
pub(super) struct Answer {
    polygon: Vec<[f64; 4]>,
}

pub(super) fn answer(request: &Request) -> Result<Answer, Refusal> {
    request.choice(("space", "unknown-space"), &["clip"], |space| space, &["camera", "ndc"])?;
    let ranges = ("depth_range", "unknown-depth-range");
    let range = request.choice(ranges, &DepthRange::ALL, DepthRange::name, &[])?.unwrap_or_default();
    request.arithmetic_of(&[Arithmetic::Exact])?;
    let vertices = request.vertices::<4>()?;
    let polygon = clip_triangle(vertices, range, PlaneSet::All, &mut Tally::default());
    Ok(Answer { polygon: polygon.corners().iter().map(|corner| wide(corner.position)).collect() })
}
