//! Pictures of 36 by 24 points: what comes out of each stage.

use rasterscope_core::{
    labs::Stage,
    pipeline::{DrawOutputs, Outputs, Point},
    transform::divide,
};
use rasterscope_figure::{
    figure::{Figure, Shape, Stroke},
    theme::{Color, Theme, ThemeName},
};
use std::sync::Arc;

const WIDTH: usize = 36;
const HEIGHT: usize = 24;
/// With more triangles than this, their covered pixels stand for them.
const MOST: usize = 400;

/// The thumbnail of a stage; `None` if there is nothing to see.
pub(super) fn of(stage: Stage, outputs: &Outputs, theme: ThemeName) -> Option<Figure> {
    let theme = theme.theme();
    let triangles: usize = outputs.draws.iter().map(|draw| draw.mesh().triangles.len()).sum();
    let many = triangles > MOST;
    let mut shapes = Vec::new();
    match stage {
        Stage::ScanConversion => shapes.push(rows(outputs, theme)?),
        Stage::Fragments | Stage::Stencil | Stage::Blend => shapes.push(mask(outputs, theme, |_, _| true)?),
        Stage::Depth => shapes.push(depths(outputs)?),
        Stage::Image => shapes.push(colors(outputs)?),
        _ if many => shapes.push(mask(outputs, theme, |_, _| true)?),
        Stage::Scene | Stage::Cull | Stage::Clip => polygons(&mut shapes, stage, outputs, theme, true),
        _ => polygons(&mut shapes, stage, outputs, theme, false),
    }
    Some(Figure { size: [WIDTH as f32, HEIGHT as f32], background: theme.canvas, shapes })
}

/// Polygons as the camera sees them, filled or as outlines.
fn polygons(shapes: &mut Vec<Shape>, stage: Stage, outputs: &Outputs, theme: &Theme, filled: bool) {
    let after = stage >= Stage::Cull;
    for (i, draw) in outputs.draws.iter().enumerate() {
        let polygons = if after { clipped(draw) } else { whole(draw, outputs) };
        for polygon in polygons {
            let points: Vec<[f32; 2]> = polygon.iter().map(|point| small(*point, outputs)).collect();
            if filled {
                shapes.push(Shape::Fill { points: points.clone(), color: theme.object(i).0 });
            }
            if !filled || stage == Stage::Clip {
                shapes.push(Shape::Line { points, closed: true, stroke: Stroke::solid(theme.text, 1.0) });
            }
        }
    }
}

fn clipped(draw: &DrawOutputs) -> Vec<Vec<Point>> {
    let polygons = draw.clipped().polygons.iter().filter(|polygon| !polygon.carried);
    polygons.map(|polygon| draw.screen()[polygon.first as usize..][..polygon.len as usize].to_vec()).collect()
}

/// The triangles before culling that lie in front of the eye.
fn whole(draw: &DrawOutputs, outputs: &Outputs) -> Vec<Vec<Point>> {
    let in_front = |triangle: &[u32; 3]| {
        let clip = triangle.map(|vertex| draw.clip().get(vertex as usize).copied().unwrap_or_default());
        clip.iter()
            .all(|point| point[3] > 0.0)
            .then(|| clip.map(|point| outputs.viewport.to_screen(divide(point))).to_vec())
    };
    draw.mesh().triangles.iter().filter_map(in_front).collect()
}

/// From pixels of the image to points of the thumbnail.
fn small([x, y, ..]: Point, outputs: &Outputs) -> [f32; 2] {
    let [w, h] = outputs.frame.size.map(|side| side.max(1) as f32);
    let far = |v: f32, limit: f32| v.clamp(-4.0 * limit, 4.0 * limit);
    [far(x / w * WIDTH as f32, WIDTH as f32), far(y / h * HEIGHT as f32, HEIGHT as f32)]
}

/// An image made pixel by pixel from the pixels of the frame.
fn raster(outputs: &Outputs, color: impl Fn(usize, [usize; 2]) -> Option<[u8; 4]>) -> Option<Shape> {
    let [w, h] = outputs.frame.size.map(|side| side as usize);
    if w == 0 || h == 0 {
        return None;
    }
    let mut rgba = Vec::with_capacity(4 * WIDTH * HEIGHT);
    for y in 0..HEIGHT {
        for x in 0..WIDTH {
            let at = (y * h + h / 2) / HEIGHT * w + (x * w + w / 2) / WIDTH;
            rgba.extend(color(at, [x, y]).unwrap_or([0; 4]));
        }
    }
    let max = [WIDTH as f32, HEIGHT as f32];
    Some(Shape::Image { min: [0.0; 2], max, size: [WIDTH, HEIGHT], rgba: Arc::new(rgba) })
}

fn colors(outputs: &Outputs) -> Option<Shape> {
    raster(outputs, |at, _| outputs.frame.color[4 * at..4 * at + 4].try_into().ok())
}

/// The pixels that differ from the clear values in depth or colour.
fn mask(outputs: &Outputs, theme: &Theme, wanted: impl Fn(usize, usize) -> bool) -> Option<Shape> {
    let Color(ink) = theme.dim;
    raster(outputs, |at, [x, y]| (drawn(outputs, at) && wanted(x, y)).then_some(ink))
}

fn rows(outputs: &Outputs, theme: &Theme) -> Option<Shape> {
    mask(outputs, theme, |_, y| y % 2 == 0)
}

fn drawn(outputs: &Outputs, at: usize) -> bool {
    let frame = &outputs.frame;
    frame.depth[at] != frame.depth[0] || frame.color[4 * at..4 * at + 4] != frame.color[..4]
}

/// Near is light.
fn depths(outputs: &Outputs) -> Option<Shape> {
    let depth = &outputs.frame.depth;
    let inside = |(at, z): (usize, &f32)| drawn(outputs, at).then_some(*z);
    let seen = || depth.iter().enumerate().filter_map(inside);
    let (low, high) = seen().fold((f32::MAX, f32::MIN), |(low, high), z| (low.min(z), high.max(z)));
    let span = (high - low).max(1e-9);
    raster(outputs, |at, _| {
        let code = 250.0 - 190.0 * ((depth[at] - low) / span).clamp(0.0, 1.0);
        drawn(outputs, at).then_some([code as u8, code as u8, code as u8, 255])
    })
}
