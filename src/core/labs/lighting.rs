//! The lab that lights one point of a surface.

use super::Family;
use crate::{
    compare::{Choice, Setting},
    math::Arithmetic,
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Problem, Scene, each_finite, refuse_if},
    shade::{
        Light, Material, Mistake, Model, Place,
        lighting::{self, Subject, Surface},
    },
    transform::matrices,
};
use serde::{Deserialize, Serialize};

/// A brightness has roots: it is not rational, so there is no exact one.
const ARITHMETICS: [Arithmetic; 2] = [Arithmetic::F64, Arithmetic::F32];

/// A slice through a surface, a light and an eye, y up.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lighting {
    /// The point of the surface, in world space.
    pub point: [f32; 2],
    /// Its normal in object space, of any length.
    pub normal: [f32; 2],
    /// Where the light is, or the direction to it.
    pub light: [f32; 2],
    /// Where it is seen from.
    pub eye: [f32; 2],
    /// Whether the light is so far away that it comes to every point from one direction.
    #[serde(default)]
    pub far: bool,
    /// How bright the light is, at least 0.
    #[serde(default = "one")]
    pub intensity: f32,
    /// c0, c1, c2: how it fades with the distance.
    #[serde(default = "steady")]
    pub attenuation: [f32; 3],
    /// ka, in 0..=1.
    #[serde(default = "ambient")]
    pub ambient: f32,
    /// kd, in 0..=1.
    #[serde(default = "diffuse")]
    pub diffuse: f32,
    /// ks, in 0..=1.
    #[serde(default = "specular")]
    pub specular: f32,
    /// s: how small the highlight is.
    #[serde(default = "exponent")]
    pub exponent: u32,
    /// What the highlight is made of.
    #[serde(default)]
    pub model: Model,
    /// Whether both sides of the surface are lit.
    #[serde(default)]
    pub two_sided: bool,
    /// The factors of the model matrix, which the surface is stretched by.
    #[serde(default = "unscaled")]
    pub scale: [f32; 2],
    /// A mistake made on purpose.
    #[serde(default)]
    pub mistake: Mistake,
    /// What it is computed in: `f64` or `f32`.
    #[serde(default = "wide")]
    pub arithmetic: Arithmetic,
}

fn one() -> f32 {
    1.0
}

fn steady() -> [f32; 3] {
    [1.0, 0.0, 0.0]
}

fn ambient() -> f32 {
    0.125
}

fn diffuse() -> f32 {
    0.5
}

fn specular() -> f32 {
    0.375
}

fn exponent() -> u32 {
    8
}

fn unscaled() -> [f32; 2] {
    [1.0; 2]
}

fn wide() -> Arithmetic {
    Arithmetic::F64
}

impl Lighting {
    /// How the surface answers to light.
    fn material(&self) -> Material {
        let Self { ambient, diffuse, specular, exponent, model, two_sided, .. } = *self;
        Material { ambient, diffuse, specular, exponent, model, two_sided, mistake: Mistake::None }
    }

    fn light(&self) -> Light {
        let place = if self.far { Place::Direction } else { Place::Position };
        Light {
            intensity: self.intensity,
            attenuation: self.attenuation,
            ..Light::new(place(lift(self.light)))
        }
    }

    /// The same in the plane z = 0 of space.
    fn subject(&self) -> Subject {
        let [x, y] = self.scale;
        Subject {
            surface: Surface { position: lift(self.point), normal: lift(self.normal) },
            model: matrices::model([0.0; 3], [0.0; 3], [x, y, 1.0]),
            mistaken: self.mistake == Mistake::ModelNormals,
            light: self.light(),
            eye: Place::Position(lift(self.eye)),
            material: self.material(),
            arithmetic: self.arithmetic,
        }
    }
}

fn lift([x, y]: [f32; 2]) -> [f32; 3] {
    [x, y, 0.0]
}

impl Family for Lighting {
    fn first() -> Self {
        Self {
            point: [0.0, 0.0],
            normal: [0.0, 1.0],
            light: [-1.5, 2.0],
            eye: [2.0, 1.5],
            far: false,
            intensity: one(),
            attenuation: steady(),
            ambient: ambient(),
            diffuse: diffuse(),
            specular: specular(),
            exponent: exponent(),
            model: Model::Phong,
            two_sided: false,
            scale: unscaled(),
            mistake: Mistake::None,
            arithmetic: wide(),
        }
    }

    fn name(&self) -> &'static str {
        "lighting"
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        for (field, vector) in
            [("point", self.point), ("normal", self.normal), ("eye", self.eye), ("scale", self.scale)]
        {
            each_finite(&vector).map_err(|e| e.within(field))?;
        }
        each_finite(&self.light).map_err(|e| e.within("light"))?;
        self.light().check()?;
        self.material().check()?;
        let problem = Problem::UnknownName {
            name: self.arithmetic.name().into(),
            known: ARITHMETICS.map(Arithmetic::name).to_vec(),
        };
        refuse_if(!ARITHMETICS.contains(&self.arithmetic), "arithmetic", problem)?;
        let known = vec!["none", "model-normals"];
        let problem = Problem::UnknownName { name: self.mistake.name().into(), known };
        refuse_if(self.mistake == Mistake::NotRenormalised, "mistake", problem)
    }

    fn play(&self, _: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        Ok(Box::new(lighting::play(self.subject(), budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        ARITHMETICS.map(Setting::Arithmetic).to_vec()
    }

    fn choices(&self) -> Vec<Choice> {
        let models = [("\"phong\"", "word-model-phong"), ("\"blinn-phong\"", "word-model-blinn-phong")];
        let sides = [("false", "word-one-side-lit"), ("true", "word-both-sides-lit")];
        let mistakes = [("\"none\"", "mistake-none"), ("\"model-normals\"", "mistake-model-normals")];
        let mut all = Choice::all("model", "compare-model", models).to_vec();
        all.extend(Choice::all("two_sided", "compare-sides-lit", sides));
        all.extend(Choice::all("mistake", "compare-mistake", mistakes));
        all
    }

    fn setting(&self, like: Setting) -> Option<Setting> {
        matches!(like, Setting::Arithmetic(_)).then_some(Setting::Arithmetic(self.arithmetic))
    }

    fn set(&mut self, setting: Setting) {
        if let Setting::Arithmetic(arithmetic) = setting {
            self.arithmetic = arithmetic;
        }
    }
}
