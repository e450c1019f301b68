//! The lab that takes one vertex through all the spaces.

use super::{Family, nothing_to_step};
use crate::{
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, FieldError, Problem, Scene, refuse_if},
    transform::chain::{self, Chain},
};
use serde::{Deserialize, Serialize};

/// A vertex of the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Transform {
    /// Which draw.
    #[serde(default)]
    pub draw: usize,
    /// Which of its vertices.
    #[serde(default)]
    pub vertex: usize,
}

impl Family for Transform {
    fn first() -> Self {
        Self { draw: 0, vertex: 0 }
    }

    fn name(&self) -> &'static str {
        "transform"
    }

    fn is_of_scene(&self) -> bool {
        true
    }

    fn check(&self, scene: &Scene) -> Checked {
        #[expect(clippy::cast_precision_loss, reason = "a limit to be shown")]
        let range = |count: usize| match count {
            0 => Problem::NoneThere,
            _ => Problem::Range { min: 0.0, max: (count - 1) as f64 },
        };
        let Some(chosen) = scene.draws.get(self.draw) else {
            return Err(FieldError::at("draw", range(scene.draws.len())));
        };
        let vertices = chosen.geometry.mesh().map(|mesh| mesh.positions.len());
        match vertices {
            Some(count) => refuse_if(self.vertex >= count, "vertex", range(count)),
            None => Ok(()),
        }
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let nothing = || nothing_to_step(self);
        let draw = scene.draws.get(self.draw).ok_or_else(nothing)?;
        let mesh = draw.geometry.mesh().ok_or_else(nothing)?;
        let position = *mesh.positions.get(self.vertex).ok_or_else(nothing)?;
        Ok(Box::new(chain::play(vec![position], Chain::of(scene, draw), budget)))
    }
}
