//! The lab that tests whole objects against the frustum.

use super::Family;
use crate::{
    compare::Setting,
    cull::object_frustum::{self, Body, Input},
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Scene},
    transform::DepthRange,
};
use serde::{Deserialize, Serialize};

/// All objects of the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FrustumCulling {
    /// What stands for an object.
    #[serde(default)]
    pub body: Body,
}

impl Family for FrustumCulling {
    fn first() -> Self {
        Self::default()
    }

    fn name(&self) -> &'static str {
        "frustum-culling"
    }

    fn is_of_scene(&self) -> bool {
        true
    }

    fn check(&self, _: &Scene) -> Checked {
        Ok(())
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        Ok(Box::new(object_frustum::play(Input::of(scene, self.body), budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        DepthRange::ALL.map(Setting::DepthRange).to_vec()
    }
}
