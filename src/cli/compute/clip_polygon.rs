//! `clip_polygon`: a polygon against a window.

use rasterscope_core::{
    clip::{
        line::{Point, Window},
        polygon::{
            Algorithm,
            sutherland_hodgman::{self, Corner, Mistake, Settings, SideOrder},
            weiler_atherton,
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
    /// Holes and islands: Weiler-Atherton only.
    contours: Vec<Vec<Point>>,
    settings: Settings,
}

impl Input {
    fn read(request: &Request) -> Result<Self, Refusal> {
        let names = ("algorithm", "unknown-algorithm");
        let algorithm = request.choice(names, &Algorithm::ALL, Algorithm::name, &[])?.unwrap_or_default();
        let order = request.choice(("order", "unknown-order"), &SideOrder::ALL, SideOrder::name, &[])?;
        let contours = match request.optional("contours") {
            Some(_) if algorithm == Algorithm::SutherlandHodgman => {
                return Err(Refusal::unsupported("contours", algorithm.name()));
            }
            Some(field) => field.items()?.map(|contour| contour.polygon()).collect::<Result<_, _>>()?,
            None => Vec::new(),
        };
        Ok(Self {
            algorithm,
            window: request.window()?,
            polygon: request.polygon("polygon")?,
            contours,
            settings: Settings {
                arithmetic: request.arithmetic_of(algorithm.arithmetics())?,
                order: order.unwrap_or_default(),
                mistake: request.choice(("mistake", "unknown-mistake"), &Mistake::ALL, Mistake::name, &[])?,
            },
        })
    }
}

/// What is left of a polygon.
#[derive(Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Answer {
    /// The corners, turning like the polygon; pieces that fell apart are joined along the borders.
    Polygon(Vec<[f64; 2]>),
    /// Each piece as the ring around it and the rings of its holes.
    Polygons(Vec<Vec<Vec<[f64; 2]>>>),
}

pub(super) fn answer(request: &Request) -> Result<Answer, Refusal> {
    let Input { algorithm, window, polygon, contours, settings } = Input::read(request)?;
    let ring = |corners: &Vec<Corner>| corners.iter().map(|corner| wide(corner.at)).collect();
    if algorithm == Algorithm::WeilerAtherton {
        let contours: Vec<_> = std::iter::once(polygon).chain(contours).collect();
        let pieces = weiler_atherton::clip(&contours, &window);
        let rings = pieces.iter().map(|piece| std::iter::once(&piece.outer).chain(&piece.holes).map(ring));
        return Ok(Answer::Polygons(rings.map(Iterator::collect).collect()));
    }
    let clipped =
        sutherland_hodgman::clip_traced(&[polygon], &window, settings, &mut Tally::default(), &mut NoTrace);
    if clipped.iter().flatten().flat_map(|corner| corner.at).any(|number| !number.is_finite()) {
        return Err(Refusal::overflow(settings.arithmetic));
    }
    Ok(Answer::Polygon(clipped.first().map_or_else(Vec::new, ring)))
}

/// The same request as a scene that opens a lab.
pub(super) fn lab(request: &Request) -> Result<Scene, Refusal> {
    let Input { algorithm, window, polygon, contours, settings } = Input::read(request)?;
    let Settings { arithmetic, order, mistake } = settings;
    let window = window.array();
    let input = labs::ClipPolygon { algorithm, window, polygon, contours, order, arithmetic, mistake };
    Ok(lab_scene([64, 64], input))
}
