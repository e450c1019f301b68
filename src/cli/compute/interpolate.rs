//! `interpolate`: an attribute at a point of a triangle.

use rasterscope_core::{
    interpolate::{InterpolateError, Mode, interpolate},
    math::Tally,
};
use serde::Serialize;

use super::{Refusal, Request};

/// The attribute's value at the point.
#[derive(Debug, Serialize)]
pub(super) struct Answer {
    value: f64,
}

pub(super) fn answer(request: &Request) -> Result<Answer, Refusal> {
    let mode = request.choice(("mode", "unknown-mode"), &Mode::ALL, Mode::name, &[])?.unwrap_or_default();
    let arithmetic = request.arithmetic()?;
    let vertices = request.vertices()?;
    let attribute = request.required("attribute")?.numbers()?;
    let at = request.required("at")?.numbers()?;
    let value = interpolate(mode, vertices, attribute, at, arithmetic, &mut Tally::default())
        .map_err(|error| Refusal::new(code(error), error.message()))?;
    if value.is_finite() { Ok(Answer { value: value.into() }) } else { Err(Refusal::overflow(arithmetic)) }
}

fn code(error: InterpolateError) -> &'static str {
    match error {
        InterpolateError::ZeroArea => "zero-area",
        InterpolateError::Outside => "outside-triangle",
        InterpolateError::ZeroW => "zero-w",
        InterpolateError::Infinite => "infinite",
    }
}
