//! Culling: which triangles need no further work, decided exactly and once.

pub mod back_face;
pub mod bvh;
pub mod camera_normal;
pub mod degenerate;
pub mod facing;
pub mod frustum;
pub mod ndc_normal;
pub mod number;
pub mod object_eye;
pub mod object_frustum;
pub mod plane_equation;
pub mod planes;
pub mod screen_area;
pub mod sphere;
pub mod xyw_determinant;

pub use facing::{Facing, facing};

use serde::{Deserialize, Serialize};

/// Which facing a draw throws away. State of the scene, not a skip: it changes the image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum CullMode {
    /// Draw both sides.
    None,
    /// Throw away what faces away from the eye.
    #[default]
    Back,
    /// Throw away what faces the eye.
    Front,
}

impl CullMode {
    /// All modes.
    pub const ALL: [Self; 3] = [Self::None, Self::Back, Self::Front];

    /// The name in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Back => "back",
            Self::Front => "front",
        }
    }

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::None => "word-cull-none",
            Self::Back => "word-cull-back",
            Self::Front => "word-cull-front",
        }
    }
}

/// Which turning sense, seen from outside with y up, is the front.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FrontFace {
    /// Counter-clockwise.
    #[default]
    Ccw,
    /// Clockwise.
    Cw,
}

impl FrontFace {
    /// Both, the default first.
    pub const ALL: [Self; 2] = [Self::Ccw, Self::Cw];

    /// The name in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ccw => "ccw",
            Self::Cw => "cw",
        }
    }

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::Ccw => "word-front-ccw",
            Self::Cw => "word-front-cw",
        }
    }
}
