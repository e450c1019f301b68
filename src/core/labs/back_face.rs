//! The lab that asks six back-face tests about one triangle.

use super::{
    Family,
    clip_line::{ARITHMETICS, check_arithmetic},
    nothing_to_step,
    transform::check_index,
};
use crate::{
    compare::{Choice, Setting},
    cull::back_face::{self, EdgeOn, Input, Settings},
    math::Arithmetic,
    message::Message,
    raster::YAxis,
    replay::{Budget, Playback},
    scene::{Checked, Scene},
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
        check_arithmetic(self.arithmetic)
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let Self { draw, triangle, edge_on, arithmetic } = *self;
        let settings = Settings { edge_on, arithmetic, ..Settings::default() };
        let input = Input::of(scene, draw, triangle, settings).ok_or_else(|| nothing_to_step(self))?;
        Ok(Box::new(back_face::play(input, budget)))
    }

    fn settings(&self, scene: &Scene) -> Vec<Setting> {
        let arithmetics = ARITHMETICS.map(Setting::Arithmetic).into_iter();
        arithmetics.chain(Setting::of_facing(scene)).chain(YAxis::ALL.map(Setting::YAxis)).collect()
    }

    fn choices(&self) -> Vec<Choice> {
        let rules = [
            ("\"neither\"", "back-face-rule-neither"),
            ("\"back\"", "back-face-rule-back"),
            ("\"front\"", "back-face-rule-front"),
            ("\"as-taught\"", "back-face-rule-as-taught"),
        ];
        Choice::all("edge_on", "compare-edge-on", rules).to_vec()
    }

    fn setting(&self, like: Setting) -> Option<Setting> {
        matches!(like, Setting::Arithmetic(_)).then_some(Setting::Arithmetic(self.arithmetic))
    }

    fn set(&mut self, setting: Setting) {
        if let Setting::Arithmetic(arithmetic) = setting {
            self.arithmetic = arithmetic;
        }
    }
}
