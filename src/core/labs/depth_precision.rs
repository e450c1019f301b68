//! The lab that measures the step of depth along the camera's line of sight.

use super::Family;
use crate::{
    compare::Setting,
    depth::{
        DepthFormat,
        precision::{self, Line},
    },
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, FieldError, Problem, Scene, each_finite},
};
use serde::{Deserialize, Serialize};

/// Two planes across the line of sight of the scene's camera.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct DepthPrecision {
    /// How far apart they are, in world units; more than 0.
    pub gap: f32,
}

impl Default for DepthPrecision {
    fn default() -> Self {
        Self { gap: 0.01 }
    }
}

impl Family for DepthPrecision {
    fn first() -> Self {
        Self::default()
    }

    fn name(&self) -> &'static str {
        "depth-precision"
    }

    fn is_of_scene(&self) -> bool {
        true
    }

    fn check(&self, _: &Scene) -> Checked {
        each_finite(&[self.gap]).map_err(|e| e.within("gap"))?;
        if self.gap > 0.0 { Ok(()) } else { Err(FieldError::at("gap", Problem::NotPositive)) }
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let line = Line::new(&scene.camera, scene.depth_format, scene.reversed);
        Ok(Box::new(precision::play(line, self.gap, budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        let ends = [false, true].map(Setting::Reversed);
        DepthFormat::ALL.map(Setting::DepthFormat).into_iter().chain(ends).collect()
    }
}
