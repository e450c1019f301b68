//! `clip_polygon`: a polygon against a window.

use rasterscope_core::{
    clip::{
        line::{Point, Window},
        polygon::sutherland_hodgman::{self, Settings},
    },
    math::{Arithmetic, Tally},
    trace::NoTrace,
};
use serde::Serialize;

use super::{Refusal, Request, wide};

/// What a `clip_polygon` request asks for.
struct Input {
    window: Window,
    polygon: Vec<Point>,
    arithmetic: Arithmetic,
}

impl Input {
    fn read(request: &Request) -> Result<Self, Refusal> {
        request.choice(("algorithm", "unknown-algorithm"), &["sutherland-hodgman"], |name| name, &[])?;
        Ok(Self {
            window: request.window()?,
            polygon: request.polygon("polygon")?,
            arithmetic: request.arithmetic_of(&[Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64])?,
        })
    }
}

/// The corners of what is left, turning like the polygon; pieces that fell apart are joined along the
/// borders.
#[derive(Debug, Serialize)]
pub(super) struct Answer {
    polygon: Vec<[f64; 2]>,
}

pub(super) fn answer(request: &Request) -> Result<Answer, Refusal> {
    let Input { window, polygon, arithmetic } = Input::read(request)?;
    let settings = Settings { arithmetic, ..Settings::default() };
    let clipped =
        sutherland_hodgman::clip_traced(&[polygon], &window, settings, &mut Tally::default(), &mut NoTrace);
    let corners = clipped.iter().flatten().map(|corner| corner.at);
    if corners.clone().flatten().any(|number| !number.is_finite()) {
        return Err(Refusal::overflow(arithmetic));
    }
    Ok(Answer { polygon: corners.map(wide).collect() })
}
