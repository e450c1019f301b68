//! `fill_polygon`: the pixels of a polygon of any number of contours.

use rasterscope_core::{
    labs,
    math::Tally,
    raster::{
        Span, YAxis,
        edge_table::{self, Settings, WindingRule},
    },
    scene::Scene,
};
use serde::Serialize;

use super::{Refusal, Request, lab_scene};

/// What a `fill_polygon` request asks for.
struct Input {
    contours: Vec<Vec<[f32; 2]>>,
    settings: Settings,
}

impl Input {
    fn read(request: &Request) -> Result<Self, Refusal> {
        let contours = request.required("contours")?;
        let contours = contours.items()?.map(|contour| contour.polygon()).collect::<Result<_, _>>()?;
        let rules = ("winding", "unknown-winding");
        let winding = request.choice(rules, &WindingRule::ALL, WindingRule::name, &[])?;
        let y_axis = request.choice(("y_axis", "unknown-y-axis"), &YAxis::ALL, YAxis::name, &[])?;
        let settings = Settings {
            winding: winding.unwrap_or_default(),
            y_axis: y_axis.unwrap_or_default(),
            arithmetic: request.arithmetic()?,
            ..Settings::new(request.size()?)
        };
        Ok(Self { contours, settings })
    }
}

/// The covered pixels, `[y, x_begin, x_end_exclusive]` for each run of them, by row and then by column.
#[derive(Debug, Serialize)]
pub(super) struct Answer {
    rows: Vec<[u32; 3]>,
}

impl Answer {
    pub(super) fn new(spans: Vec<Span>) -> Self {
        let mut rows: Vec<_> = spans.into_iter().map(|Span { y, begin, end }| [y, begin, end]).collect();
        rows.sort_unstable();
        Self { rows }
    }
}

pub(super) fn answer(request: &Request) -> Result<Answer, Refusal> {
    let Input { contours, settings } = Input::read(request)?;
    let mut spans = Vec::new();
    edge_table::fill(&contours, &settings, &mut Tally::default(), &mut |span| spans.push(span));
    Ok(Answer::new(spans))
}

/// The same request as a scene that opens a lab.
pub(super) fn lab(request: &Request) -> Result<Scene, Refusal> {
    let Input { contours, settings } = Input::read(request)?;
    let Settings { size, winding, y_axis, arithmetic } = settings;
    let input = labs::FillPolygon { contours, winding, arithmetic };
    Ok(Scene { y_axis, ..lab_scene(size, input) })
}
