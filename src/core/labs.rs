//! The registry of what can be stepped: from a scene's lab input to a run.
//!
//! The window, `trace`, `figure` and `tour` all start a run here, so they show the same steps.

use crate::{
    clip::line::{Window, cohen_sutherland},
    message::{Message, Value},
    raster::{self, scanline},
    replay::{Budget, Playback},
    scene::{LabInput, Scene},
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

/// The stages of the pipeline, left to right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names are the meaning")]
pub enum Stage {
    Scene,
    Model,
    View,
    ClipSpace,
    Cull,
    Clip,
    Divide,
    Viewport,
    ScanConversion,
    Fragments,
    Stencil,
    Depth,
    Blend,
    Image,
}

impl Stage {
    /// In the order of the data flow.
    pub const ALL: [Self; 14] = [
        Self::Scene,
        Self::Model,
        Self::View,
        Self::ClipSpace,
        Self::Cull,
        Self::Clip,
        Self::Divide,
        Self::Viewport,
        Self::ScanConversion,
        Self::Fragments,
        Self::Stencil,
        Self::Depth,
        Self::Blend,
        Self::Image,
    ];

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::Scene => "stage-scene",
            Self::Model => "stage-model",
            Self::View => "stage-view",
            Self::ClipSpace => "stage-clip-space",
            Self::Cull => "stage-cull",
            Self::Clip => "stage-clip",
            Self::Divide => "stage-divide",
            Self::Viewport => "stage-viewport",
            Self::ScanConversion => "stage-scan-conversion",
            Self::Fragments => "stage-fragments",
            Self::Stencil => "stage-stencil",
            Self::Depth => "stage-depth",
            Self::Blend => "stage-blend",
            Self::Image => "stage-image",
        }
    }
}

/// Every lab, in pipeline order.
pub const ALL: [LabInfo; 5] = [
    LabInfo { name: "pipeline", stage: Stage::Image },
    LabInfo { name: "transform", stage: Stage::ClipSpace },
    LabInfo { name: "cohen-sutherland", stage: Stage::Clip },
    LabInfo { name: "scanline", stage: Stage::ScanConversion },
    LabInfo { name: "z-buffer", stage: Stage::Depth },
];

/// The lab of that name.
pub fn find(name: &str) -> Option<LabInfo> {
    ALL.into_iter().find(|lab| lab.name == name)
}

/// What a lab starts with on a scene that says nothing about it.
pub fn default_input(name: &str) -> Option<LabInput> {
    Some(match name {
        "pipeline" => LabInput::Pipeline,
        "transform" => LabInput::Transform { draw: 0, vertex: 0 },
        "cohen-sutherland" => LabInput::CohenSutherland {
            window: [3.5, 2.0, 9.0, 6.5],
            segment: [0.5, 0.5, 10.5, 8.5],
            arithmetic: crate::math::Arithmetic::Exact,
        },
        "scanline" => LabInput::Scanline { vertices: None, triangle: 0 },
        "z-buffer" => LabInput::ZBuffer { triangles: None },
        _ => return None,
    })
}

/// Starts the run of the scene's lab, at step 0.
///
/// The scene's models must be loaded. The message says what about the input cannot be run.
pub fn play(scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
    let Some(lab) = &scene.lab else { return Err(Message::new("error-no-lab")) };
    match &lab.input {
        LabInput::CohenSutherland { window, segment: [x1, y1, x2, y2], arithmetic } => {
            let window = Window::new(*window).ok_or_else(|| Message::new("error-window"))?;
            let segment = [[*x1, *y1], [*x2, *y2]];
            Ok(Box::new(cohen_sutherland::play(segment, window, *arithmetic, budget)))
        }
        LabInput::Scanline { vertices: Some(vertices), .. } => {
            Ok(Box::new(scanline::play(*vertices, scan_settings(scene), budget)))
        }
        other => Err(Message::new("error-nothing-to-step").with("lab", Value::text(other.name()))),
    }
}

/// The scene's conventions of scan conversion.
fn scan_settings(scene: &Scene) -> raster::Settings {
    raster::Settings { fill_rule: scene.fill_rule, y_axis: scene.y_axis, ..raster::Settings::new(scene.size) }
}
