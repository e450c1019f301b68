//! `depth`: the depth of a triangle at each of its pixels.

use rasterscope_core::{
    depth::{DepthFormat, DepthPlane},
    labs,
    math::Tally,
    raster::{Settings, Span, rows},
    scene::Scene,
};
use serde::{Serialize, Serializer};

use super::{
    Refusal, Request,
    coverage::{conventions, steppable},
    lab_scene,
};

/// The covered pixels with their depths, row by row; written as they are computed, for a large
/// triangle has millions.
#[derive(Debug, Serialize)]
pub(super) struct Answer {
    pixels: Pixels,
}

#[derive(Debug)]
struct Pixels {
    spans: Vec<Span>,
    plane: DepthPlane,
    format: DepthFormat,
}

impl Serialize for Pixels {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let pixels = self.spans.iter().flat_map(|span| (span.begin..span.end).map(|x| (x, span.y)));
        serializer.collect_seq(pixels.map(|(x, y)| {
            let code = self.plane.code([x, y], self.format, &mut Tally::default());
            (x, y, self.format.decode(code))
        }))
    }
}

fn format(request: &Request) -> Result<DepthFormat, Refusal> {
    let names = ("format", "unknown-format");
    Ok(request.choice(names, &DepthFormat::ALL, DepthFormat::name, &[])?.unwrap_or_default())
}

pub(super) fn answer(request: &Request) -> Result<Answer, Refusal> {
    let (algorithm, settings) = conventions(request)?;
    let format = format(request)?;
    let vertices = request.vertices::<3>()?;
    let spans = rows(algorithm, vertices.map(|[x, y, _]| [x, y]), &settings, &mut Tally::default());
    let plane = DepthPlane::new(vertices, settings.arithmetic, &mut Tally::default());
    Ok(Answer { pixels: Pixels { spans, plane, format } })
}

/// The same request as a scene that opens a lab.
pub(super) fn lab(request: &Request) -> Result<Scene, Refusal> {
    let Settings { size, fill_rule, y_axis, .. } = steppable(request)?;
    let depth_format = format(request)?;
    let input = labs::ZBuffer::of(vec![request.vertices()?]);
    Ok(Scene { fill_rule, y_axis, depth_format, ..lab_scene(size, input) })
}
