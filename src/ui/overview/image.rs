//! The image with the outlines of what was drawn and of what was culled.

use crate::document::ViewState;
use rasterscope_core::{
    explain::{Grid, Label, Mark, Role, View},
    message::Value,
    pipeline::{DrawOutputs, Fate, Outputs, Point},
    raster::YAxis,
    scene::Scene,
    transform::divide,
};
use std::sync::Arc;

/// Most triangles whose outlines are drawn; beyond that they would hide the image.
const MOST_OUTLINES: usize = 64;

/// Larger images have no grid until they are zoomed in.
const MOST_GRID: u32 = 160;

/// The marks of the image, or of what lies on it, and their view.
pub(super) fn drawing(
    outputs: &Outputs,
    scene: &Scene,
    (rgba, laid): (&Arc<Vec<u8>>, Option<&[Mark]>),
    view: &ViewState,
) -> (Vec<Mark>, View) {
    let [w, h] = scene.size;
    let mut marks = match laid {
        Some(laid) => laid.to_vec(),
        None => vec![Mark::Image { size: [w as usize, h as usize], rgba: Arc::clone(rgba) }],
    };
    let triangles: usize = outputs.draws.iter().map(|draw| draw.mesh().triangles.len()).sum();
    if view.outlines && triangles <= MOST_OUTLINES {
        for (draw, stages) in scene.draws.iter().zip(&outputs.draws) {
            culled(&mut marks, &draw.name, stages, outputs);
            kept(&mut marks, &draw.name, stages);
        }
    }
    if let Some([x, y]) = view.pixel.filter(|[x, y]| *x < w && *y < h) {
        marks.push(Mark::Pixel {
            at: [x as i32, y as i32],
            role: Role::Active,
            object: None,
            value: Value::None,
        });
    }
    // On a large image grid and rulers come with zooming in.
    let grid = if w.max(h) <= MOST_GRID { Grid::Pixels } else { Grid::None };
    let view = View { min: [0.0; 2], max: [w as f32, h as f32], y_up: scene.y_axis == YAxis::Up, grid };
    (marks, view)
}

fn kept(marks: &mut Vec<Mark>, name: &str, draw: &DrawOutputs) {
    let mut label = (!name.is_empty()).then(|| Label::name(name));
    for polygon in draw.clipped().polygons.iter().filter(|polygon| !polygon.carried) {
        let first = polygon.first as usize;
        let corners = &draw.screen()[first..first + polygon.len as usize];
        marks.push(outline(corners, Role::Neutral, label.take()));
    }
}

/// What is culled for its facing, where it would have been drawn.
fn culled(marks: &mut Vec<Mark>, name: &str, draw: &DrawOutputs, outputs: &Outputs) {
    let mut label = (!name.is_empty()).then(|| Label::name(name));
    let decided = draw.mesh().triangles.iter().zip(&draw.culled().decisions);
    for (triangle, _) in
        decided.filter(|(_, decision)| decision.fate != Fate::Drawn && decision.facing.is_some())
    {
        let clip = triangle.map(|vertex| draw.clip()[vertex as usize]);
        if clip.iter().all(|point| point[3] > 0.0) {
            let screen = clip.map(|point| outputs.viewport.to_screen(divide(point)));
            marks.push(outline(&screen, Role::Rejected, label.take()));
        }
    }
}

fn outline(corners: &[Point], role: Role, label: Option<Label>) -> Mark {
    Mark::Polygon { points: corners.iter().map(|[x, y, ..]| [*x, *y]).collect(), role, object: None, label }
}
