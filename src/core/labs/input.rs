//! The inputs of all labs as one type: what stands in a scene file under `lab`. A family of labs shares
//! its inputs; a new family is a line in the list below.

use super::{
    ALL, AreaRatios, BackFace, Blend, Bvh, ClipConvex, ClipLine, ClipPlane, ClipPoint, ClipPolygon,
    ClipTriangle, DepthPrecision, DrawLine, DrawPoint, FillPolygon, FillTriangle, FrustumCulling,
    Homogeneous, Lighting, Msaa, PerspectiveCorrection, Pipeline, PlaneEquation, Shading, Stencil, Stress,
    Transform, ZBuffer, default_input, find,
};
use crate::{
    compare::{Choice, Setting},
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Scene},
};
use serde::{Serialize, de::DeserializeOwned};

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

            pub(super) fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
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
    /// One triangle with w, and its pixels.
    Homogeneous
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
    /// One point of a surface in a light.
    Lighting
    /// The scene through the vertex and the fragment stage.
    Shading
    /// The stencil test, draw by draw.
    Stencil
    /// Cases driven to where arithmetic breaks.
    Stress
    /// Triangles, fragment by fragment.
    ZBuffer
    /// The step of depth along the line of sight.
    DepthPrecision
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
