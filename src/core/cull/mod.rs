//! Culling: which triangles need no further work, decided exactly and once.

pub mod back_face;
pub mod camera_normal;
pub mod degenerate;
pub mod facing;
pub mod frustum;
pub mod ndc_normal;
pub mod number;
pub mod object_eye;
pub mod plane_equation;
pub mod screen_area;
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
