//! The lab that asks six back-face tests about one triangle.

use super::{Family, nothing_to_step, transform::check_index};
use crate::{
    cull::back_face::{self, EdgeOn, Input, Settings},
    math::Arithmetic,
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Problem, Scene, refuse_if},
};
use serde::{Deserialize, Serialize};

/// A triangle of the scene. Its front face and cull mode are the draw's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BackFace {
    /// Which draw.
    #[serde(default)]
    pub draw: usize,
    /// Which of its triangles.
    #[serde(default)]
    pub triangle: usize,
    /// What a triangle is that is seen exactly edge-on.
    #[serde(default)]
    pub edge_on: EdgeOn,
    /// What the tests compute in.
    #[serde(default)]
    pub arithmetic: Arithmetic,
}

impl Family for BackFace {
    fn first() -> Self {
        Self::default()
    }

    fn name(&self) -> &'static str {
        "back-face"
    }

    fn is_of_scene(&self) -> bool {
        true
    }

    fn check(&self, scene: &Scene) -> Checked {
        check_index("draw", self.draw, scene.draws.len())?;
        let mesh = scene.draws[self.draw].geometry.mesh();
        mesh.map_or(Ok(()), |mesh| check_index("triangle", self.triangle, mesh.triangles.len()))?;
        let known = vec!["exact", "f32", "f64"];
        let problem = Problem::UnknownName { name: self.arithmetic.name().into(), known };
        refuse_if(self.arithmetic == Arithmetic::Fixed8, "arithmetic", problem)
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let Self { draw, triangle, edge_on, arithmetic } = *self;
        let settings = Settings { edge_on, arithmetic, ..Settings::default() };
        let input = Input::of(scene, draw, triangle, settings).ok_or_else(|| nothing_to_step(self))?;
        Ok(Box::new(back_face::play(input, budget)))
    }
}
