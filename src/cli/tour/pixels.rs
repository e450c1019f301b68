//! Pictures of the stages on the screen: pixel grids, cell by cell if the image is small.

use rasterscope_core::{
    depth::DepthFormat,
    explain::{Grid, Mark, Role, View},
    labs::Stage,
    message::Value,
    pipeline::{DrawOutputs, Layer, Overlay, ScreenTriangle},
    raster::YAxis,
};
use rasterscope_figure::overlay;
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

/// The pixels that have a fragment, each in the colour of the last one's draw.
fn covered(subject: &Subject<'_>) -> Mark {
    let size = subject.scene.size.map(|side| side as usize);
    let color = |i: usize| subject.last_draw(i).map_or(subject.theme.canvas, |draw| subject.color(draw));
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
        marks.push(covered(subject));
    } else if subject.is_named() {
        let screen = subject.outputs.draws.iter().flat_map(DrawOutputs::screen);
        marks.extend(screen.map(|&[x, y, ..]| Mark::Point { at: [x, y], role: Role::Neutral, label: None }));
    }
    drawing(subject, marks, "tour-picture-viewport")
}

/// Which pixels have a fragment.
pub(super) fn scan_conversion(subject: &Subject<'_>) -> Drawing {
    let mut marks = if subject.is_small() {
        cells(subject, |i| Some((Role::Accepted, Some(subject.last_draw(i)?), Value::None)))
    } else {
        vec![covered(subject)]
    };
    marks.extend(outlines(subject, false));
    drawing(subject, marks, "tour-picture-scan-conversion")
}

/// What an overlay lays on the image.
fn laid(subject: &Subject<'_>, of: Overlay, caption: &'static str) -> Drawing {
    let Subject { scene, outputs, counts, theme } = *subject;
    let layer = Layer::of(of, scene, outputs, Some(counts), None);
    let size = scene.size.map(|side| side as usize);
    drawing(subject, overlay::marks(&layer, size, &Arc::default(), theme), caption)
}

/// How many fragments each pixel got.
pub(super) fn fragments(subject: &Subject<'_>) -> Drawing {
    laid(subject, Overlay::Generated, "tour-picture-fragments")
}

/// The stencil values.
pub(super) fn stencil(subject: &Subject<'_>) -> Drawing {
    laid(subject, Overlay::Stencil, "tour-picture-stencil")
}

/// The stored depths.
pub(super) fn depth(subject: &Subject<'_>) -> Drawing {
    laid(subject, Overlay::Depth, "tour-picture-depth")
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
        let blended = |draw: usize| subject.scene.draws.get(draw).is_some_and(|draw| draw.blend.is_some());
        marks.extend(cells(subject, |i| {
            subject.last_draw(i).is_some_and(blended).then_some((Role::Changed, None, Value::None))
        }));
    }
    drawing(subject, marks, "tour-picture-blend")
}

/// The image.
pub(super) fn final_image(subject: &Subject<'_>) -> Drawing {
    drawing(subject, vec![image(&subject.outputs.frame)], "tour-picture-image")
}
