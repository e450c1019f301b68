//! `coverage`: the pixels of a triangle.

use rasterscope_core::{
    labs,
    math::{Arithmetic, Tally},
    raster::{Algorithm, FillRule, Settings, Span, YAxis, rows},
    scene::Scene,
};
use serde::Serialize;

use super::{Refusal, Request, lab_scene};

/// The conventions of a `coverage` or `depth` request.
pub(super) fn conventions(request: &Request) -> Result<(Algorithm, Settings), Refusal> {
    let names = ("algorithm", "unknown-algorithm");
    let algorithm = request.choice(names, &Algorithm::ALL, Algorithm::name, &[])?;
    let rules = ("fill_rule", "unknown-fill-rule");
    let fill_rule = request.choice(rules, &FillRule::ALL, FillRule::name, &[])?;
    let axes = ("y_axis", "unknown-y-axis");
    let y_axis = request.choice(axes, &[YAxis::Down, YAxis::Up], axis_name, &[])?;
    let settings = Settings {
        fill_rule: fill_rule.unwrap_or_default(),
        y_axis: y_axis.unwrap_or_default(),
        arithmetic: request.arithmetic()?,
        ..Settings::new(request.size()?)
    };
    Ok((algorithm.unwrap_or_default(), settings))
}

/// The conventions of a `depth` request that is to be stepped, which is done in exact arithmetic.
pub(super) fn steppable(request: &Request) -> Result<Settings, Refusal> {
    request.arithmetic_of(&[Arithmetic::Exact])?;
    conventions(request).map(|(_, settings)| settings)
}

fn axis_name(axis: YAxis) -> &'static str {
    match axis {
        YAxis::Down => "down",
        YAxis::Up => "up",
    }
}

/// The covered pixels, `[y, x_begin, x_end_exclusive]` for each row that has any.
#[derive(Debug, Serialize)]
pub(super) struct Answer {
    rows: Vec<[u32; 3]>,
}

pub(super) fn answer(request: &Request) -> Result<Answer, Refusal> {
    let (algorithm, settings) = conventions(request)?;
    let spans = rows(algorithm, request.vertices()?, &settings, &mut Tally::default());
    Ok(Answer { rows: spans.into_iter().map(|Span { y, begin, end }| [y, begin, end]).collect() })
}

/// The same request as a scene that opens a lab.
pub(super) fn lab(request: &Request) -> Result<Scene, Refusal> {
    let (algorithm, Settings { size, fill_rule, y_axis, arithmetic, .. }) = conventions(request)?;
    let vertices = request.vertices()?;
    if algorithm == Algorithm::Homogeneous {
        let input = labs::Homogeneous::of(vertices.map(|[x, y]| [x, y, 1.0]));
        return Ok(Scene { fill_rule, y_axis, ..lab_scene(size, labs::Homogeneous { arithmetic, ..input }) });
    }
    let input = labs::FillTriangle { arithmetic, ..labs::FillTriangle::of(algorithm, vertices) };
    Ok(Scene { fill_rule, y_axis, ..lab_scene(size, input) })
}
