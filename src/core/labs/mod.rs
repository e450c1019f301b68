//! The registry of what can be stepped: from a scene's lab input to a run.
//!
//! The window, `trace`, `figure` and `tour` all start a run here, so they show the same steps.
//! One file holds one family of labs: the inputs they share as they stand in a scene file, what
//! makes sense there, and how a run starts. Adding a lab is such a file (or a name more in one),
//! a line in [`ALL`], and for a new family a line in [`LabInput`].

mod back_face;
mod blend;
mod bvh;
mod clip_convex;
mod clip_line;
mod clip_plane;
mod clip_point;
mod clip_polygon;
mod clip_triangle;
mod draw_line;
mod draw_point;
mod fill_polygon;
mod fill_triangle;
mod frustum_culling;
mod interpolation;
mod lectures;
mod msaa;
mod perspective_correction;
mod pipeline;
mod stencil;
mod transform;
mod z_buffer;

pub use self::lectures::Topic;
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
    draw_line::DrawLine,
    draw_point::DrawPoint,
    fill_polygon::FillPolygon,
    fill_triangle::FillTriangle,
    frustum_culling::FrustumCulling,
    interpolation::{AreaRatios, Interpolation, PlaneEquation},
    msaa::Msaa,
    perspective_correction::PerspectiveCorrection,
    pipeline::Pipeline,
    stencil::{Order, Stencil},
    transform::Transform,
    z_buffer::ZBuffer,
};
pub use crate::stage::Stage;

use crate::{
    compare::{Choice, Setting},
    message::{Message, Value},
    raster,
    replay::{Budget, Playback},
    scene::{Checked, FieldError, Scene, read},
};
use serde::{Serialize, de::DeserializeOwned};
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
    LabInfo::new::<FillPolygon>("edge-table", Stage::ScanConversion),
    LabInfo::new::<DrawLine>("dda", Stage::ScanConversion),
    LabInfo::new::<DrawLine>("bresenham", Stage::ScanConversion),
    LabInfo::new::<DrawLine>("diamond-exit", Stage::ScanConversion),
    LabInfo::new::<DrawPoint>("points", Stage::ScanConversion),
    LabInfo::new::<Msaa>("msaa", Stage::ScanConversion),
    LabInfo::new::<AreaRatios>("area-ratios", Stage::Fragments),
    LabInfo::new::<PlaneEquation>("plane-equation", Stage::Fragments),
    LabInfo::new::<PerspectiveCorrection>("perspective-correction", Stage::Fragments),
    LabInfo::new::<Stencil>("stencil", Stage::Stencil),
    LabInfo::new::<ZBuffer>("z-buffer", Stage::Depth),
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

/// The inputs that a family of labs shares. What it serializes to stands in scene files.
pub(crate) trait Family: Clone + Serialize + DeserializeOwned + Into<LabInput> {
    /// What a lab of the family starts with.
    fn first() -> Self;

    /// The same input for the lab of that name, in a family of several.
    #[must_use]
    fn named(self, _name: &'static str) -> Self {
        self
    }

    /// Its lab.
    fn name(&self) -> &'static str;

    /// Whether it needs nothing but what the scene draws, and so starts on any scene.
    fn is_of_scene(&self) -> bool;

    /// What no single field can tell: ranges, counts and combinations.
    fn check(&self, scene: &Scene) -> Checked;

    /// Starts the run, at step 0. The message says what about the input cannot be run.
    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message>;

    /// Every value of every setting that the run reads, its own included: what it can be compared
    /// with. The algorithms of the family go without saying.
    fn settings(&self, _scene: &Scene) -> Vec<Setting> {
        Vec::new()
    }

    /// Every value of every input that is a choice among a few, the default of each first.
    fn choices(&self) -> Vec<Choice> {
        Vec::new()
    }

    /// The value here of a setting that is an input of this family; `None` if it is none.
    fn setting(&self, _like: Setting) -> Option<Setting> {
        None
    }

    /// Takes the value of a setting that is an input of this family; leaves others alone.
    fn set(&mut self, _setting: Setting) {}
}

macro_rules! families {
    ($($(#[$doc:meta])* $family:ident)*) => {
        /// The inputs of each family of labs.
        #[derive(Clone, Debug, PartialEq, Serialize)]
        #[serde(untagged)]
        pub enum LabInput {
            $($(#[$doc])* $family($family),)*
        }

        $(impl From<$family> for LabInput {
            fn from(input: $family) -> Self {
                Self::$family(input)
            }
        })*

        impl LabInput {
            /// The lab's name, on the command line and in scene files.
            pub fn name(&self) -> &'static str {
                match self { $(Self::$family(input) => input.name(),)* }
            }

            /// Whether it needs nothing but what the scene draws, and so starts on any scene.
            pub fn is_of_scene(&self) -> bool {
                match self { $(Self::$family(input) => input.is_of_scene(),)* }
            }

            /// The same input for another lab of its family; `None`: that lab has other inputs.
            pub fn carried(&self, name: &'static str) -> Option<Self> {
                match self { $(Self::$family(input) => {
                    let carried = input.clone().named(name);
                    // A lab may have a family of its own although its algorithm belongs to this one.
                    let own = matches!(default_input(name), Some(Self::$family(_)));
                    (own && carried.name() == name).then(|| carried.into())
                })* }
            }

            pub(crate) fn check(&self, scene: &Scene) -> Checked {
                match self { $(Self::$family(input) => input.check(scene),)* }
            }

            /// Every value of every setting that the run reads, its own included.
            pub(crate) fn settings(&self, scene: &Scene) -> Vec<Setting> {
                let choices = self.choices().into_iter().map(Setting::Choice);
                let own = match self { $(Self::$family(input) => input.settings(scene),)* };
                choices.chain(own).collect()
            }

            /// Every value of every input that is a choice among a few, the default of each first.
            pub(crate) fn choices(&self) -> Vec<Choice> {
                match self { $(Self::$family(input) => input.choices(),)* }
            }

            /// The value here of a setting that is an input; `None` if it is none.
            pub(crate) fn setting(&self, like: Setting) -> Option<Setting> {
                match (self, like) {
                    (_, Setting::Algorithm(_)) => Some(Setting::Algorithm(self.name())),
                    (_, Setting::Choice(like)) => self.choice(like).map(Setting::Choice),
                    $((Self::$family(input), like) => input.setting(like),)*
                }
            }

            /// Takes the value of a setting that is an input; leaves others alone.
            pub(crate) fn set(&mut self, setting: Setting) {
                if let Setting::Choice(choice) = setting {
                    return self.choose(choice);
                }
                match (self, setting) {
                    $((Self::$family(input), Setting::Algorithm(name)) => {
                        *input = input.clone().named(name);
                    })*
                    $((Self::$family(input), setting) => input.set(setting),)*
                }
            }

            fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
                match self { $(Self::$family(input) => input.play(scene, budget),)* }
            }
        }
    };
}

families! {
    /// A point against a window.
    ClipPoint
    /// A line against a window.
    ClipLine
    /// A line against a convex polygon.
    ClipConvex
    /// Polygons against a window.
    ClipPolygon
    /// One triangle and its pixels.
    FillTriangle
    /// A polygon, row by row.
    FillPolygon
    /// A line of one pixel's width.
    DrawLine
    /// A point of any size.
    DrawPoint
    /// Triangles, sample by sample.
    Msaa
    /// An attribute at a point of a triangle.
    AreaRatios
    /// An attribute along a row of pixels.
    PlaneEquation
    /// A checkered parallelogram, with and without perspective correction.
    PerspectiveCorrection
    /// The stencil test, draw by draw.
    Stencil
    /// Triangles, fragment by fragment.
    ZBuffer
    /// Layers over one pixel.
    Blend
    /// One vertex through all the spaces.
    Transform
    /// One triangle: does the eye see its back?
    BackFace
    /// One triangle against one plane.
    ClipPlane
    /// One triangle against the planes of the frustum.
    ClipTriangle
    /// Objects against the frustum.
    FrustumCulling
    /// A tree of boxes against the frustum.
    Bvh
    /// The whole scene, stage by stage.
    Pipeline
}

impl LabInput {
    /// The whole scene.
    pub const PIPELINE: Self = Self::Pipeline(Pipeline {});

    /// The value of an input that is a choice.
    fn choice(&self, like: Choice) -> Option<Choice> {
        let fields = serde_json::to_value(self).ok()?;
        let mut all = self.choices().into_iter().filter(|choice| choice.field == like.field);
        match fields.get(like.field).filter(|value| !value.is_null()) {
            Some(value) => all.find(|choice| choice.is(value)),
            None => all.next(),
        }
    }

    /// Takes the value of an input that is a choice; what is none leaves it as it is.
    fn choose(&mut self, choice: Choice) {
        let default = self.choices().into_iter().find(|other| other.field == choice.field);
        let (Ok(serde_json::Value::Object(mut fields)), Some(default)) =
            (serde_json::to_value(&*self), default)
        else {
            return;
        };
        fields.remove(choice.field);
        if choice != default {
            fields.insert(choice.field.to_owned(), choice.value());
        }
        if let Some(Ok(input)) = find(self.name()).map(|lab| lab.read(&fields.into())) {
            *self = input;
        }
    }

    /// The names of the labs whose algorithms take these very inputs, its own included.
    pub fn algorithms(&self) -> Vec<&'static str> {
        let family = std::mem::discriminant(self);
        let mine = ALL.iter().filter(|lab| std::mem::discriminant(&lab.first_input()) == family);
        mine.map(|lab| lab.name).collect()
    }
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
