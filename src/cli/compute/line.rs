//! `line` and `point`: the pixels of a line and of a point.

use rasterscope_core::{
    labs,
    math::{Arithmetic, Tally},
    message::Message,
    raster::{
        line::{self, Algorithm, FARTHEST},
        point,
    },
    scene::Scene,
};
use serde::Serialize;

use super::{Refusal, Request, fill_polygon, lab_scene, refusal::text};

/// What a `line` request asks for.
struct Input {
    algorithm: Algorithm,
    segment: [f32; 4],
    size: [u32; 2],
    arithmetic: Arithmetic,
}

impl Input {
    fn read(request: &Request) -> Result<Self, Refusal> {
        let names = ("algorithm", "unknown-algorithm");
        let algorithm = request.choice(names, &Algorithm::ALL, Algorithm::name, &[])?.unwrap_or_default();
        let segment: [f32; 4] = request.required("segment")?.numbers()?;
        if segment.iter().any(|coordinate| coordinate.abs() > FARTHEST as f32) {
            let message = Message::new("error-too-far").with("field", text("segment"));
            return Err(Refusal::new("bad-field", message.with("most", i64::from(FARTHEST))));
        }
        let arithmetic = request.arithmetic_of(algorithm.arithmetics())?;
        Ok(Self { algorithm, segment, size: request.size()?, arithmetic })
    }
}

/// The pixels in the image, from the first end of the line to the second.
#[derive(Debug, Serialize)]
pub(super) struct Answer {
    pixels: Vec<[u32; 2]>,
}

pub(super) fn answer(request: &Request) -> Result<Answer, Refusal> {
    let Input { algorithm, segment: [x0, y0, x1, y1], size, arithmetic } = Input::read(request)?;
    let ends = [[x0, y0], [x1, y1]];
    Ok(Answer { pixels: line::pixels(algorithm, ends, size, arithmetic, &mut Tally::default()) })
}

/// The same request as a scene that opens a lab.
pub(super) fn lab(request: &Request) -> Result<Scene, Refusal> {
    let Input { algorithm, segment, size, arithmetic } = Input::read(request)?;
    Ok(lab_scene(size, labs::DrawLine { algorithm, segment, arithmetic }))
}

/// A point and its size, 1 if it is left out.
fn point_of(request: &Request) -> Result<labs::DrawPoint, Refusal> {
    let point = request.required("point")?.numbers()?;
    let size = request.optional("point_size").map_or(Ok(1.0), |size| size.number())?;
    let arithmetic = request.arithmetic_of(&[Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64])?;
    Ok(labs::DrawPoint { point, size: size.max(0.0), arithmetic })
}

/// The covered pixels, as of a polygon.
pub(super) fn answer_point(request: &Request) -> Result<fill_polygon::Answer, Refusal> {
    let labs::DrawPoint { point, size, arithmetic } = point_of(request)?;
    let settings = point::Settings { size: request.size()?, arithmetic };
    let mut spans = Vec::new();
    point::draw(point, size, &settings, &mut Tally::default(), &mut |span| spans.push(span));
    Ok(fill_polygon::Answer::new(spans))
}

/// The same request as a scene that opens a lab.
pub(super) fn lab_point(request: &Request) -> Result<Scene, Refusal> {
    Ok(lab_scene(request.size()?, point_of(request)?))
}
