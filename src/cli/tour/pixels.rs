//! Pictures of the stages on the screen: pixel grids, cell by cell if the image is small.

use rasterscope_core::{
    depth::DepthFormat,
    explain::{Grid, Mark, Role, View},
    labs::Stage,
    message::Value,
    pipeline::{DrawOutputs, ScreenTriangle},
    raster::YAxis,
};
use rasterscope_figure::theme::Color;
use std::sync::Arc;

use super::{paint::image, picture::Drawing, subject::Subject};

/// Triangles up to this many are outlined.
const OUTLINED: usize = 300;

fn drawing(subject: &Subject<'_>, marks: Vec<Mark>, caption: &'static str) -> Drawing {
    Drawing { marks, view: view(subject.scene), caption, painted: false }
}

/// The plane of a scene's image.
pub(crate) fn view(scene: &rasterscope_core::scene::Scene) -> View {
    let max = scene.size.map(|side| side as f32);
    View { min: [0.0, 0.0], max, y_up: scene.y_axis == YAxis::Up, grid: Grid::Pixels }
}

/// The triangles on the screen; filled or as outlines only.
fn outlines(subject: &Subject<'_>, filled: bool) -> Vec<Mark> {
    let triangles: Vec<_> = subject.outputs.triangles().take(OUTLINED + 1).collect();
    if triangles.len() > OUTLINED {
        return Vec::new();
    }
    let outline = |triangle: &ScreenTriangle| Mark::Polygon {
        points: triangle.vertices.map(|[x, y, _]| [x, y]).to_vec(),
        role: Role::Neutral,
        object: filled.then_some(triangle.draw as usize),
        label: None,
    };
    triangles.iter().map(outline).collect()
}

/// One colour for each pixel.
fn flat_image(subject: &Subject<'_>, color: impl Fn(usize) -> Color) -> Mark {
    let size = subject.scene.size.map(|side| side as usize);
    let rgba = (0..size[0] * size[1]).flat_map(|i| color(i).0);
    Mark::Image { size, rgba: Arc::new(rgba.collect()) }
}

/// One mark for each pixel that `cell` wants.
fn cells(subject: &Subject<'_>, cell: impl Fn(usize) -> Option<(Role, Option<usize>, Value)>) -> Vec<Mark> {
    let [width, height] = subject.scene.size.map(|side| side as usize);
    let mark = |i: usize| {
        let (role, object, value) = cell(i)?;
        Some(Mark::Pixel { at: [(i % width) as i32, (i / width) as i32], role, object, value })
    };
    (0..width * height).filter_map(mark).collect()
}

/// The triangles in pixels.
pub(super) fn viewport(subject: &Subject<'_>) -> Drawing {
    let mut marks = outlines(subject, true);
    if marks.is_empty() {
        let coverage = subject.coverage();
        let empty = subject.theme.canvas;
        marks.push(flat_image(subject, |i| match coverage.counts[i] {
            0 => empty,
            _ => subject.color(coverage.last[i] as usize),
        }));
    } else if subject.is_named() {
        let screen = subject.outputs.draws.iter().flat_map(DrawOutputs::screen);
        marks.extend(screen.map(|&[x, y, ..]| Mark::Point { at: [x, y], role: Role::Neutral, label: None }));
    }
    drawing(subject, marks, "tour-picture-viewport")
}

/// Which pixels have a fragment.
pub(super) fn scan_conversion(subject: &Subject<'_>) -> Drawing {
    let coverage = subject.coverage();
    let mut marks = if subject.is_small() {
        cells(subject, |i| {
            let drawn = coverage.counts[i] > 0;
            drawn.then(|| (Role::Accepted, Some(coverage.last[i] as usize), Value::None))
        })
    } else {
        let empty = subject.theme.canvas;
        vec![flat_image(subject, |i| match coverage.counts[i] {
            0 => empty,
            _ => subject.color(coverage.last[i] as usize),
        })]
    };
    marks.extend(outlines(subject, false));
    drawing(subject, marks, "tour-picture-scan-conversion")
}

/// How many fragments each pixel got.
pub(super) fn fragments(subject: &Subject<'_>) -> Drawing {
    let counts = subject.coverage().counts;
    let most = counts.iter().copied().max().unwrap_or(0).max(1);
    let marks = if subject.is_small() {
        let value = |i: usize| (Role::Neutral, None, Value::from(counts[i]));
        let mut marks = vec![flat_image(subject, |i| shade(subject, counts[i] as f32 / most as f32))];
        marks.extend(cells(subject, |i| (counts[i] > 0).then(|| value(i))));
        marks
    } else {
        vec![flat_image(subject, |i| shade(subject, counts[i] as f32 / most as f32))]
    };
    drawing(subject, marks, "tour-picture-fragments")
}

/// From the canvas (0) towards the text's colour (1).
fn shade(subject: &Subject<'_>, share: f32) -> Color {
    subject.theme.text.alpha(share.clamp(0.0, 1.0) * 0.75).over(subject.theme.canvas)
}

/// The stencil values.
pub(super) fn stencil(subject: &Subject<'_>) -> Drawing {
    let stencil = &subject.outputs.frame.stencil;
    let clear = subject.scene.clear.stencil;
    let most = stencil.iter().copied().max().unwrap_or(0).max(1);
    let mut marks =
        vec![flat_image(subject, |i| shade(subject, f32::from(stencil[i]) / f32::from(most) * 0.5))];
    if subject.is_small() {
        marks.extend(cells(subject, |i| {
            let role = if stencil[i] == clear { Role::Candidate } else { Role::Neutral };
            Some((role, None, Value::from(u32::from(stencil[i]))))
        }));
    }
    drawing(subject, marks, "tour-picture-stencil")
}

/// The stored depths: near is dark.
pub(super) fn depth(subject: &Subject<'_>) -> Drawing {
    let frame = &subject.outputs.frame;
    let clear = stored_clear(subject);
    let drawn = || frame.depth.iter().copied().filter(|z| *z != clear);
    let [low, high] = [drawn().fold(1.0, f32::min), drawn().fold(0.0, f32::max)];
    let near = |z: f32| {
        let share = if high > low { (high - z) / (high - low) } else { 0.5 };
        let share = if subject.scene.reversed { 1.0 - share } else { share };
        0.12 + 0.88 * share
    };
    let color = |i: usize| match frame.depth[i] {
        z if z == clear => subject.theme.canvas,
        z => shade(subject, near(z)),
    };
    let mut marks = vec![flat_image(subject, color)];
    if subject.is_small() {
        marks.extend(cells(subject, |i| {
            (frame.depth[i] != clear).then(|| (Role::Neutral, None, Value::from(frame.depth[i])))
        }));
    }
    drawing(subject, marks, "tour-picture-depth")
}

/// The depth of a pixel that nothing was drawn to, as it is stored.
pub(super) fn stored_clear(subject: &Subject<'_>) -> f32 {
    let (format, clear) = (subject.scene.depth_format, subject.scene.clear.depth);
    match format {
        DepthFormat::F32 => clear,
        _ => format.decode(format.encode(clear)) as f32,
    }
}

/// The image, without and with what blending adds.
pub(super) fn blend(subject: &Subject<'_>) -> Drawing {
    let mut marks = vec![image(&subject.outputs.frame)];
    if subject.is_small() && subject.outputs.frame.stats.stage(Stage::Blend).on {
        let blended =
            |draw: u32| subject.scene.draws.get(draw as usize).is_some_and(|draw| draw.blend.is_some());
        let coverage = subject.coverage();
        marks.extend(cells(subject, |i| {
            (coverage.counts[i] > 0 && blended(coverage.last[i])).then_some((
                Role::Changed,
                None,
                Value::None,
            ))
        }));
    }
    drawing(subject, marks, "tour-picture-blend")
}

/// The image.
pub(super) fn final_image(subject: &Subject<'_>) -> Drawing {
    drawing(subject, vec![image(&subject.outputs.frame)], "tour-picture-image")
}
