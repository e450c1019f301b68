//! `clip_polygon`: a polygon against a window.

use rasterscope_core::{
    clip::{
        line::{Point, Window},
        polygon::{
            Algorithm,
            sutherland_hodgman::{self, Mistake, Settings, SideOrder},
        },
    },
    labs,
    math::Tally,
    scene::Scene,
    trace::NoTrace,
};
use serde::Serialize;

use super::{Refusal, Request, lab_scene, wide};

/// What a `clip_polygon` request asks for.
struct Input {
    algorithm: Algorithm,
    window: Window,
    polygon: Vec<Point>,
    settings: Settings,
}

impl Input {
    fn read(request: &Request) -> Result<Self, Refusal> {
        let names = ("algorithm", "unknown-algorithm");
        let algorithm = request.choice(names, &Algorithm::ALL, Algorithm::name, &[])?.unwrap_or_default();
        let order = request.choice(("order", "unknown-order"), &SideOrder::ALL, SideOrder::name, &[])?;
        Ok(Self {
            algorithm,
            window: request.window()?,
            polygon: request.polygon("polygon")?,
            settings: Settings {
                arithmetic: request.arithmetic_of(algorithm.arithmetics())?,
                order: order.unwrap_or_default(),
                mistake: request.choice(("mistake", "unknown-mistake"), &Mistake::ALL, Mistake::name, &[])?,
            },
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
    let Input { window, polygon, settings, .. } = Input::read(request)?;
    let clipped =
        sutherland_hodgman::clip_traced(&[polygon], &window, settings, &mut Tally::default(), &mut NoTrace);
    let corners = clipped.iter().flatten().map(|corner| corner.at);
    if corners.clone().flatten().any(|number| !number.is_finite()) {
        return Err(Refusal::overflow(settings.arithmetic));
    }
    Ok(Answer { polygon: corners.map(wide).collect() })
}

/// The same request as a scene that opens a lab.
pub(super) fn lab(request: &Request) -> Result<Scene, Refusal> {
    let Input { algorithm, window, polygon, settings } = Input::read(request)?;
    let Settings { arithmetic, order, mistake } = settings;
    let (window, contours) = (window.array(), Vec::new());
    let input = labs::ClipPolygon { algorithm, window, polygon, contours, order, arithmetic, mistake };
    Ok(lab_scene([64, 64], input))
}
