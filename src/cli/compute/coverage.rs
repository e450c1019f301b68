//! `coverage`: the pixels of a triangle.

use rasterscope_core::{
    labs,
    math::{Arithmetic, Tally},
    raster::{Algorithm, FillRule, Samples, Settings, Span, YAxis, cover_samples, rows},
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
    /// With several samples a pixel: `[x, y, mask]` for each pixel that has a covered one, row by row, the
    /// first sample in the lowest bit.
    #[serde(skip_serializing_if = "Option::is_none")]
    masks: Option<Vec<[u32; 3]>>,
}

pub(super) fn answer(request: &Request) -> Result<Answer, Refusal> {
    let (algorithm, settings) = conventions(request)?;
    let vertices = request.vertices()?;
    let samples = samples(request)?;
    let spans = rows(algorithm, vertices, &settings, &mut Tally::default());
    let rows = spans.into_iter().map(|Span { y, begin, end }| [y, begin, end]).collect();
    let masks = (samples != Samples::One).then(|| {
        let mut masks = Vec::new();
        cover_samples(vertices, samples, &settings, &mut Tally::default(), &mut |[x, y], mask| {
            masks.push([x, y, mask.into()]);
        });
        masks
    });
    Ok(Answer { rows, masks })
}

/// How many samples a pixel has; one if the field is left out. Masks are exact, or of snapped vertices.
fn samples(request: &Request) -> Result<Samples, Refusal> {
    let Some(field) = request.optional("samples") else { return Ok(Samples::One) };
    let count = field.value.as_f64().filter(|count| (1.0..=8.0).contains(count) && count.fract() == 0.0);
    let samples = count.and_then(|count| Samples::try_from(count as u32).ok());
    let samples = samples.ok_or_else(|| field.bad("error-bad-samples"))?;
    if samples != Samples::One {
        let exact = Arithmetic::ALL.into_iter().filter(|arithmetic| arithmetic.is_exact());
        request.arithmetic_of(&exact.collect::<Vec<_>>())?;
    }
    Ok(samples)
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
