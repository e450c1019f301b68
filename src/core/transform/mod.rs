//! Vertex transforms: model, view, projection, divide, viewport.
//!
//! Matrices are built in binary64 with portable functions and rounded once; every product
//! component is summed in binary64 in a fixed order and rounded once to binary32: the same bits
//! on every machine.

pub mod chain;
pub mod frustum;
pub mod matrices;
pub(crate) mod screen;

pub use chain::{Chain, Space};
pub use matrices::{Matrix, apply};
pub use screen::{Viewport, divide};

use serde::{Deserialize, Serialize};

/// Which depths in NDC are visible.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DepthRange {
    /// `0 <= z <= w`, as in WebGPU and Direct3D.
    #[default]
    ZeroToOne,
    /// `-w <= z <= w`, as in OpenGL.
    MinusOneToOne,
}

impl DepthRange {
    /// Both ranges, the default first.
    pub const ALL: [Self; 2] = [Self::ZeroToOne, Self::MinusOneToOne];

    /// The name on the command line and in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::ZeroToOne => "zero-to-one",
            Self::MinusOneToOne => "minus-one-to-one",
        }
    }

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::ZeroToOne => "word-depth-zero-to-one",
            Self::MinusOneToOne => "word-depth-minus-one-to-one",
        }
    }
}

/// How camera space becomes clip space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Projection {
    /// Lines of sight meet in the eye.
    Perspective {
        /// Angle between the top and bottom plane, in degrees, `0 < fovy < 180`.
        fovy_degrees: f32,
    },
    /// Lines of sight are parallel.
    Orthographic {
        /// Height of the visible box, in world units, positive.
        height: f32,
    },
}

/// Where the scene is seen from. Right-handed, looking along -z of camera space, y up.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Camera {
    /// Position of the eye, in world space.
    pub eye: [f32; 3],
    /// The point looked at, in world space; not the eye.
    pub target: [f32; 3],
    /// Roughly up; not parallel to the line of sight.
    pub up: [f32; 3],
    /// Distance of the near plane; positive for a perspective, less than `far`.
    pub near: f32,
    /// Distance of the far plane.
    pub far: f32,
    /// Perspective or orthographic.
    pub projection: Projection,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            eye: [0.0, 0.0, 5.0],
            target: [0.0; 3],
            up: [0.0, 1.0, 0.0],
            near: 1.0,
            far: 10.0,
            projection: Projection::Perspective { fovy_degrees: 60.0 },
        }
    }
}
