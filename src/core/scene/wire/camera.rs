//! The camera of a scene file: the kind of projection says which of its numbers there must be.

use super::super::{error::Problem, path::FieldError};
use crate::transform::{Camera, Projection};
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct CameraWire {
    eye: [f32; 3],
    target: [f32; 3],
    up: [f32; 3],
    near: f32,
    far: f32,
    projection: ProjectionWire,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct ProjectionWire {
    kind: ProjectionKind,
    #[serde(skip_serializing_if = "Option::is_none")]
    fovy_degrees: Option<f32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    height: Option<f32>,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum ProjectionKind {
    Perspective,
    Orthographic,
}

impl Default for CameraWire {
    fn default() -> Self {
        Self::from(&Camera::default())
    }
}

impl CameraWire {
    pub(super) fn into_camera(self) -> Result<Camera, FieldError> {
        let Self { eye, target, up, near, far, projection } = self;
        let projection = projection.into_projection().map_err(|e| e.within("projection"))?;
        Ok(Camera { eye, target, up, near, far, projection })
    }
}

impl From<&Camera> for CameraWire {
    fn from(camera: &Camera) -> Self {
        let Camera { eye, target, up, near, far, projection } = *camera;
        let projection = match projection {
            Projection::Perspective { fovy_degrees } => ProjectionWire {
                kind: ProjectionKind::Perspective,
                fovy_degrees: Some(fovy_degrees),
                height: None,
            },
            Projection::Orthographic { height } => ProjectionWire {
                kind: ProjectionKind::Orthographic,
                fovy_degrees: None,
                height: Some(height),
            },
        };
        Self { eye, target, up, near, far, projection }
    }
}

impl ProjectionWire {
    fn into_projection(self) -> Result<Projection, FieldError> {
        let missing = |field| FieldError::at(field, Problem::Missing);
        let foreign = |field, known| FieldError::at(field, Problem::UnknownField { known });
        match (self.kind, self.fovy_degrees, self.height) {
            (ProjectionKind::Perspective, Some(fovy_degrees), None) => {
                Ok(Projection::Perspective { fovy_degrees })
            }
            (ProjectionKind::Orthographic, None, Some(height)) => Ok(Projection::Orthographic { height }),
            (ProjectionKind::Perspective, _, Some(_)) => Err(foreign("height", vec!["kind", "fovy_degrees"])),
            (ProjectionKind::Orthographic, Some(_), _) => {
                Err(foreign("fovy_degrees", vec!["kind", "height"]))
            }
            (ProjectionKind::Perspective, None, None) => Err(missing("fovy_degrees")),
            (ProjectionKind::Orthographic, None, None) => Err(missing("height")),
        }
    }
}
