//! The registry of what can be stepped: from a scene's lab input to a run.
//!
//! The window, `trace`, `figure` and `tour` all start a run here, so they show the same steps.
//! One file holds one family of labs: the inputs they share as they stand in a scene file, what
//! makes sense there, and how a run starts. Adding a lab is such a file (or a name more in one),
//! a line in [`ALL`], and for a new family a line in `input.rs`.

mod back_face;
mod blend;
mod bvh;
mod clip_convex;
mod clip_line;
mod clip_plane;
mod clip_point;
mod clip_polygon;
mod clip_triangle;
mod depth_precision;
mod draw_line;
mod draw_point;
mod fill_polygon;
mod fill_triangle;
mod frustum_culling;
mod homogeneous;
mod input;
mod interpolation;
mod lectures;
mod lighting;
mod msaa;
mod of_pixel;
mod perspective_correction;
mod pipeline;
mod shading;
mod stencil;
mod stress;
mod transform;
mod z_buffer;

pub use self::lectures::Topic;
pub use self::of_pixel::lab_of;
pub use self::{
    back_face::BackFace,
    blend::{Blend, Layer},
    bvh::{Bvh, Over},
    clip_convex::ClipConvex,
    clip_line::ClipLine,
    clip_plane::ClipPlane,
    clip_point::ClipPoint,
    clip_polygon::ClipPolygon,
    clip_triangle::{ClipTriangle, Planes},
    depth_precision::DepthPrecision,
    draw_line::DrawLine,
    draw_point::DrawPoint,
    fill_polygon::FillPolygon,
    fill_triangle::FillTriangle,
    frustum_culling::FrustumCulling,
    homogeneous::Homogeneous,
    interpolation::{AreaRatios, Interpolation, PlaneEquation},
    lighting::Lighting,
    msaa::Msaa,
    perspective_correction::PerspectiveCorrection,
    pipeline::Pipeline,
    shading::{ShadeMode, Shading},
    stencil::{Order, Stencil},
    stress::Stress,
    transform::Transform,
    z_buffer::{TriangleState, ZBuffer},
};
pub use crate::stage::Stage;
pub(crate) use input::Family;
pub use input::LabInput;

use crate::{
    message::{Message, Value},
    raster,
    replay::{Budget, Playback},
    scene::{FieldError, Scene, read},
};
use std::fmt;

/// A lab: an algorithm with its inputs and everything that explains it.
#[derive(Clone, Copy)]
pub struct LabInfo {
    /// On the command line, in scene files, and the prefix of its message ids: `NAME` is the
    /// title's id, `NAME-about` that of one sentence.
    pub name: &'static str,
    /// The stage of the pipeline that it belongs to.
    pub stage: Stage,
    first: fn(&'static str) -> LabInput,
    read: fn(&'static str, &serde_json::Value) -> Result<LabInput, FieldError>,
}

impl LabInfo {
    const fn new<F: Family>(name: &'static str, stage: Stage) -> Self {
        Self {
            name,
            stage,
            first: |name| F::first().named(name).into(),
            read: |name, fields| Ok(read::<F>(fields)?.named(name).into()),
        }
    }

    /// What it starts with on a scene that says nothing about it.
    pub fn first_input(&self) -> LabInput {
        (self.first)(self.name)
    }

    /// Its input as it stands in a scene file, without the lab's name and step.
    pub(crate) fn read(&self, fields: &serde_json::Value) -> Result<LabInput, FieldError> {
        (self.read)(self.name, fields)
    }
}

impl fmt::Debug for LabInfo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("LabInfo")
            .field("name", &self.name)
            .field("stage", &self.stage)
            .finish_non_exhaustive()
    }
}

/// Every lab, in pipeline order.
pub const ALL: &[LabInfo] = &[
    LabInfo::new::<Pipeline>("pipeline", Stage::Image),
    LabInfo::new::<Transform>("transform", Stage::ClipSpace),
    LabInfo::new::<BackFace>("back-face", Stage::Cull),
    LabInfo::new::<FrustumCulling>("frustum-culling", Stage::Cull),
    LabInfo::new::<Bvh>("bvh", Stage::Cull),
    LabInfo::new::<ClipPoint>("point-clipping", Stage::Clip),
    LabInfo::new::<ClipLine>("cohen-sutherland", Stage::Clip),
    LabInfo::new::<ClipLine>("liang-barsky", Stage::Clip),
    LabInfo::new::<ClipPlane>("clip-plane", Stage::Clip),
    LabInfo::new::<ClipConvex>("cyrus-beck", Stage::Clip),
    LabInfo::new::<ClipLine>("midpoint", Stage::Clip),
    LabInfo::new::<ClipLine>("nicholl-lee-nicholl", Stage::Clip),
    LabInfo::new::<ClipTriangle>("clip-triangle", Stage::Clip),
    LabInfo::new::<ClipPolygon>("sutherland-hodgman", Stage::Clip),
    LabInfo::new::<ClipPolygon>("weiler-atherton", Stage::Clip),
    LabInfo::new::<FillTriangle>("scanline", Stage::ScanConversion),
    LabInfo::new::<FillTriangle>("aabb", Stage::ScanConversion),
    LabInfo::new::<FillTriangle>("backtracking", Stage::ScanConversion),
    LabInfo::new::<FillTriangle>("zigzag", Stage::ScanConversion),
    LabInfo::new::<FillTriangle>("tiled", Stage::ScanConversion),
    LabInfo::new::<Homogeneous>("homogeneous", Stage::ScanConversion),
    LabInfo::new::<FillPolygon>("edge-table", Stage::ScanConversion),
    LabInfo::new::<DrawLine>("dda", Stage::ScanConversion),
    LabInfo::new::<DrawLine>("bresenham", Stage::ScanConversion),
    LabInfo::new::<DrawLine>("diamond-exit", Stage::ScanConversion),
    LabInfo::new::<DrawPoint>("points", Stage::ScanConversion),
    LabInfo::new::<Msaa>("msaa", Stage::ScanConversion),
    LabInfo::new::<Stress>("stress", Stage::ScanConversion),
    LabInfo::new::<AreaRatios>("area-ratios", Stage::Fragments),
    LabInfo::new::<PlaneEquation>("plane-equation", Stage::Fragments),
    LabInfo::new::<PerspectiveCorrection>("perspective-correction", Stage::Fragments),
    LabInfo::new::<Lighting>("lighting", Stage::Fragments),
    LabInfo::new::<Shading>("shading", Stage::Fragments),
    LabInfo::new::<Stencil>("stencil", Stage::Stencil),
    LabInfo::new::<ZBuffer>("z-buffer", Stage::Depth),
    LabInfo::new::<DepthPrecision>("depth-precision", Stage::Depth),
    LabInfo::new::<Blend>("blend", Stage::Blend),
];

/// The lab of that name.
pub fn find(name: &str) -> Option<LabInfo> {
    ALL.iter().find(|lab| lab.name == name).copied()
}

/// What a lab starts with on a scene that says nothing about it.
pub fn default_input(name: &str) -> Option<LabInput> {
    find(name).map(|lab| lab.first_input())
}

/// Starts the run of the scene's lab, at step 0.
///
/// The scene's models must be loaded. The message says what about the input cannot be run.
pub fn play(scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
    match &scene.lab {
        Some(lab) => lab.input.play(scene, budget),
        None => Err(Message::new("error-no-lab")),
    }
}

/// The lab finds nothing in the scene that it could run.
fn nothing_to_step(input: &impl Family) -> Message {
    Message::new("error-nothing-to-step").with("lab", Value::text(input.name()))
}

/// Most pixels of a scene whose fragments are stepped; of larger ones only a lab's own triangles are.
const MOST_PIXELS: u64 = 256 * 256;

/// Refuses a scene of too many pixels to step through.
fn refuse_large(scene: &Scene) -> Result<(), Message> {
    let [width, height] = scene.size.map(u64::from);
    if width * height > MOST_PIXELS {
        return Err(Message::new("error-too-large-to-step").with("most", 256));
    }
    Ok(())
}

/// The scene's conventions of scan conversion.
fn scan_settings(scene: &Scene) -> raster::Settings {
    raster::Settings { fill_rule: scene.fill_rule, y_axis: scene.y_axis, ..raster::Settings::new(scene.size) }
}
