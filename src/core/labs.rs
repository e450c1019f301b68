//! The registry of what can be stepped: from a scene's lab input to a run.
//!
//! The window, `trace`, `figure` and `tour` all start a run here, so they show the same steps.

pub use crate::stage::Stage;
use crate::{
    clip::line::{Algorithm, Window, cohen_sutherland, liang_barsky},
    depth::{DepthState, z_buffer},
    math::Arithmetic,
    message::{Message, Value},
    pipeline::{screen_names, screen_triangles},
    raster::{self, scanline},
    replay::{Budget, Playback},
    scene::{LabInput, Scene},
    transform::chain::{self, Chain},
};

/// A lab: an algorithm with its inputs and everything that explains it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LabInfo {
    /// On the command line, in scene files, and the prefix of its message ids: `NAME` is the
    /// title's id, `NAME-about` that of one sentence.
    pub name: &'static str,
    /// The stage of the pipeline that it belongs to.
    pub stage: Stage,
}

/// Every lab, in pipeline order.
pub const ALL: [LabInfo; 6] = [
    LabInfo { name: "pipeline", stage: Stage::Image },
    LabInfo { name: "transform", stage: Stage::ClipSpace },
    LabInfo { name: "cohen-sutherland", stage: Stage::Clip },
    LabInfo { name: "liang-barsky", stage: Stage::Clip },
    LabInfo { name: "scanline", stage: Stage::ScanConversion },
    LabInfo { name: "z-buffer", stage: Stage::Depth },
];

/// The lab of that name.
pub fn find(name: &str) -> Option<LabInfo> {
    ALL.into_iter().find(|lab| lab.name == name)
}

/// What a lab starts with on a scene that says nothing about it.
pub fn default_input(name: &str) -> Option<LabInput> {
    let line = |algorithm| LabInput::ClipLine {
        algorithm,
        window: [3.5, 2.0, 9.0, 6.5],
        segment: [0.5, 0.5, 10.5, 8.5],
        arithmetic: Arithmetic::Exact,
    };
    Some(match name {
        "pipeline" => LabInput::Pipeline,
        "transform" => LabInput::Transform { draw: 0, vertex: 0 },
        "cohen-sutherland" => line(Algorithm::CohenSutherland),
        "liang-barsky" => line(Algorithm::LiangBarsky),
        "scanline" => LabInput::Scanline { vertices: None, triangle: 0 },
        "z-buffer" => LabInput::ZBuffer { triangles: None },
        _ => return None,
    })
}

/// Most pixels of a scene whose pipeline is stepped as a whole; of larger ones only a lab's own
/// triangles are.
const MOST_PIXELS: u64 = 256 * 256;

/// Starts the run of the scene's lab, at step 0.
///
/// The scene's models must be loaded. The message says what about the input cannot be run.
pub fn play(scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
    let Some(lab) = &scene.lab else { return Err(Message::new("error-no-lab")) };
    let nothing = || Message::new("error-nothing-to-step").with("lab", Value::text(lab.input.name()));
    match &lab.input {
        LabInput::ClipLine { algorithm, window, segment: [x1, y1, x2, y2], arithmetic } => {
            let window = Window::new(*window).ok_or_else(|| Message::new("error-window"))?;
            let segment = [[*x1, *y1], [*x2, *y2]];
            Ok(match algorithm {
                Algorithm::CohenSutherland => {
                    Box::new(cohen_sutherland::play(segment, window, *arithmetic, budget))
                }
                Algorithm::LiangBarsky => Box::new(liang_barsky::play(segment, window, *arithmetic, budget)),
            })
        }
        LabInput::Scanline { vertices, triangle } => {
            let of_scene =
                || screen_triangles(scene).get(*triangle).map(|t| t.vertices.map(|[x, y, _]| [x, y]));
            let vertices = vertices.or_else(of_scene).ok_or_else(nothing)?;
            Ok(Box::new(scanline::play(vertices, scan_settings(scene), budget)))
        }
        LabInput::ZBuffer { triangles: Some(triangles) } => {
            let settings = depth_settings(scene, DepthState::default());
            Ok(Box::new(z_buffer::play(triangles.clone(), Vec::new(), settings, budget)))
        }
        LabInput::ZBuffer { triangles: None } => play_depth_of(scene, budget),
        LabInput::Transform { draw, vertex } => {
            let draw = scene.draws.get(*draw).ok_or_else(nothing)?;
            let mesh = draw.geometry.mesh().ok_or_else(nothing)?;
            let position = *mesh.positions.get(*vertex).ok_or_else(nothing)?;
            Ok(Box::new(chain::play(vec![position], Chain::of(scene, draw), budget)))
        }
        LabInput::Pipeline => {
            let [width, height] = scene.size.map(u64::from);
            let plain = scene.draws.iter().all(|draw| draw.stencil.is_none() && draw.blend.is_none());
            if !plain {
                return Err(Message::new("error-steps-without-stencil"));
            }
            if width * height > MOST_PIXELS {
                return Err(Message::new("error-too-large-to-step").with("most", 256));
            }
            play_depth_of(scene, budget)
        }
    }
}

/// The depth test of all of the scene's triangles, which must agree on its state.
fn play_depth_of(scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
    let mut states = scene.draws.iter().map(|draw| draw.depth);
    let state = states.next().unwrap_or_default();
    if states.any(|other| other != state) {
        return Err(Message::new("error-mixed-depth-states"));
    }
    let triangles = screen_triangles(scene);
    let names = screen_names(scene, &triangles)
        .zip(&triangles)
        .map(|(text, piece)| z_buffer::Name { text, object: piece.draw as usize })
        .collect();
    let triangles = triangles.iter().map(|triangle| triangle.vertices).collect();
    Ok(Box::new(z_buffer::play(triangles, names, depth_settings(scene, state), budget)))
}

/// The scene's conventions of scan conversion.
fn scan_settings(scene: &Scene) -> raster::Settings {
    raster::Settings { fill_rule: scene.fill_rule, y_axis: scene.y_axis, ..raster::Settings::new(scene.size) }
}

/// The scene's conventions of the depth test.
fn depth_settings(scene: &Scene, state: DepthState) -> z_buffer::Settings {
    z_buffer::Settings {
        algorithm: raster::Algorithm::Scanline,
        raster: scan_settings(scene),
        format: scene.depth_format,
        clear: scene.clear.depth,
        state,
    }
}
