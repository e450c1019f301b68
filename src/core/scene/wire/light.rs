//! A light of a scene file: at a position, or in a direction.

use super::super::{error::Problem, path::FieldError};
use crate::shade::{Light, Place};
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct LightWire {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    position: Option<[f32; 3]>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    direction: Option<[f32; 3]>,
    #[serde(default = "one", skip_serializing_if = "is_one")]
    intensity: f32,
    #[serde(default = "steady", skip_serializing_if = "is_steady")]
    attenuation: [f32; 3],
}

fn one() -> f32 {
    1.0
}

fn is_one(value: &f32) -> bool {
    *value == 1.0
}

fn steady() -> [f32; 3] {
    [1.0, 0.0, 0.0]
}

fn is_steady(value: &[f32; 3]) -> bool {
    *value == steady()
}

impl LightWire {
    pub(super) fn into_light(self) -> Result<Light, FieldError> {
        let place = match (self.position, self.direction) {
            (Some(position), None) => Place::Position(position),
            (None, Some(direction)) => Place::Direction(direction),
            (Some(_), Some(_)) => {
                return Err(FieldError::at("direction", Problem::Both { other: "position" }));
            }
            (None, None) => return Err(FieldError::at("position", Problem::Missing)),
        };
        Ok(Light { place, intensity: self.intensity, attenuation: self.attenuation })
    }
}

impl From<&Light> for LightWire {
    fn from(light: &Light) -> Self {
        let Light { place, intensity, attenuation } = *light;
        let (position, direction) = match place {
            Place::Position(position) => (Some(position), None),
            Place::Direction(direction) => (None, Some(direction)),
        };
        Self { position, direction, intensity, attenuation }
    }
}
