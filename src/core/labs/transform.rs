//! The lab that takes one vertex through all the spaces.

use super::{Family, nothing_to_step};
use crate::{
    compare::Setting,
    message::Message,
    raster::YAxis,
    replay::{Budget, Playback},
    scene::{Checked, Problem, Scene, refuse_if},
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
        check_index("draw", self.draw, scene.draws.len())?;
        let mesh = scene.draws[self.draw].geometry.mesh();
        mesh.map_or(Ok(()), |mesh| check_index("vertex", self.vertex, mesh.positions.len()))
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let nothing = || nothing_to_step(self);
        let draw = scene.draws.get(self.draw).ok_or_else(nothing)?;
        let mesh = draw.geometry.mesh().ok_or_else(nothing)?;
        let position = *mesh.positions.get(self.vertex).ok_or_else(nothing)?;
        Ok(Box::new(chain::play(vec![position], Chain::of(scene, draw), budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        Setting::of_transform().into_iter().chain(YAxis::ALL.map(Setting::YAxis)).collect()
    }
}

/// Refuses an index that is not below a count.
#[expect(clippy::cast_precision_loss, reason = "a limit to be shown")]
pub(super) fn check_index(field: &str, index: usize, count: usize) -> Checked {
    let problem = match count {
        0 => Problem::NoneThere,
        _ => Problem::Range { min: 0.0, max: (count - 1) as f64 },
    };
    refuse_if(index >= count, field, problem)
}
