//! Shading: how bright a point of a surface is, from its direction, the lights and the eye.
//!
//! Contract: roots and powers are not rational, so a brightness is *defined* as a fixed sequence of
//! binary64 operations on binary32 inputs, each rounded correctly, none fused, with no function of the
//! platform: the same bits on every machine. It is rounded to binary32, or to the code, once at the end.
//! Lights are white: a brightness is one number, which multiplies the surface's colour where it is matte
//! and is added to it where it is glossy.

mod illumination;
pub mod lighting;
mod normals;
pub mod shading;

pub use illumination::Illumination;
pub use lighting::{Brightness, Surface, brightness};
pub use normals::{NormalMatrix, smooth_normals};

use crate::scene::{Checked, Problem, each_finite, refuse_if};
use serde::{Deserialize, Serialize};

/// The largest exponent of a highlight.
pub const MOST_EXPONENT: u32 = 1024;

/// Which angle makes a highlight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Model {
    /// Between the mirrored light and the eye: `r . v`.
    #[default]
    Phong,
    /// Between the normal and the direction halfway from the light to the eye: `n . h`.
    BlinnPhong,
}

impl Model {
    /// Both models, the default first.
    pub const ALL: [Self; 2] = [Self::Phong, Self::BlinnPhong];

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::Phong => "word-model-phong",
            Self::BlinnPhong => "word-model-blinn-phong",
        }
    }
}

/// A common mistake, made on purpose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mistake {
    /// None.
    #[default]
    None,
    /// Normals go through the model matrix as points do.
    ModelNormals,
    /// An interpolated normal, which is shorter than 1, is used as it is.
    NotRenormalised,
}

impl Mistake {
    /// The name in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::ModelNormals => "model-normals",
            Self::NotRenormalised => "not-renormalised",
        }
    }
}

/// How a surface answers to light.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Material {
    /// ka: what is there without any light, in 0..=1.
    pub ambient: f32,
    /// kd: how much light goes out evenly, in 0..=1.
    pub diffuse: f32,
    /// ks: how much light is mirrored, in 0..=1.
    pub specular: f32,
    /// s: how small the highlight is, in 1..=[`MOST_EXPONENT`].
    pub exponent: u32,
    /// Which angle makes the highlight.
    pub model: Model,
    /// Whether a normal that points away from the eye is turned around.
    pub two_sided: bool,
    /// A mistake made on purpose.
    pub mistake: Mistake,
}

impl Default for Material {
    fn default() -> Self {
        Self {
            ambient: 0.25,
            diffuse: 0.75,
            specular: 0.25,
            exponent: 16,
            model: Model::Phong,
            two_sided: false,
            mistake: Mistake::None,
        }
    }
}

impl Material {
    /// Whether it makes sense; else the path of its first bad field.
    pub(crate) fn check(&self) -> Checked {
        let shares = [("ambient", self.ambient), ("diffuse", self.diffuse), ("specular", self.specular)];
        for (field, share) in shares {
            refuse_if(!(0.0..=1.0).contains(&share), field, Problem::Range { min: 0.0, max: 1.0 })?;
        }
        let range = Problem::Range { min: 1.0, max: f64::from(MOST_EXPONENT) };
        refuse_if(!(1..=MOST_EXPONENT).contains(&self.exponent), "exponent", range)
    }
}

/// Where something is, a light or an eye, as a surface sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// At a point of world space.
    Position([f32; 3]),
    /// Infinitely far away, towards this vector of any length.
    Direction([f32; 3]),
}

/// A white light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Where it comes from, in world space.
    pub place: Place,
    /// How bright it is, at least 0.
    pub intensity: f32,
    /// c, l, q of `1 / (c + l d + q d^2)` at the distance d; at least 0, not all 0. A light in infinity
    /// is the same everywhere.
    pub attenuation: [f32; 3],
}

impl Light {
    /// A light of intensity 1 that does not fade.
    pub fn new(place: Place) -> Self {
        Self { place, intensity: 1.0, attenuation: [1.0, 0.0, 0.0] }
    }

    /// Whether it makes sense; else the path of its first bad field.
    pub(crate) fn check(&self) -> Checked {
        let (field, vector) = match &self.place {
            Place::Position(position) => ("position", position),
            Place::Direction(direction) => ("direction", direction),
        };
        each_finite(vector).map_err(|e| e.within(field))?;
        let nowhere = matches!(self.place, Place::Direction(direction) if direction == [0.0; 3]);
        refuse_if(nowhere, field, Problem::NotPositive)?;
        each_finite(&[self.intensity]).map_err(|e| e.within("intensity"))?;
        refuse_if(self.intensity < 0.0, "intensity", Problem::Negative)?;
        check_attenuation(&self.attenuation)
    }
}

/// Whether `1 / (c + l d + q d^2)` is positive at every distance.
pub(crate) fn check_attenuation(factors: &[f32; 3]) -> Checked {
    each_finite(factors).map_err(|e| e.within("attenuation"))?;
    refuse_if(factors.iter().any(|factor| *factor < 0.0), "attenuation", Problem::Negative)?;
    refuse_if(*factors == [0.0; 3], "attenuation", Problem::NotPositive)
}
