//! The whole scene, stage by stage; stepped, it is the depth test of all its triangles, or, where the
//! draws have different states, the stencil and depth test of all its draws.

use super::{
    Family, refuse_large,
    stencil::play_stencil_of,
    z_buffer::{play_depth_of, settings_of_depth},
};
use crate::{
    compare::Setting,
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Draw, Scene},
};
use serde::{Deserialize, Serialize};

/// The scene is all there is to say.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pipeline {}

impl Family for Pipeline {
    fn first() -> Self {
        Self {}
    }

    fn name(&self) -> &'static str {
        "pipeline"
    }

    fn is_of_scene(&self) -> bool {
        true
    }

    fn check(&self, _: &Scene) -> Checked {
        Ok(())
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        refuse_large(scene)?;
        if scene.samples != 1 {
            return Err(Message::new("error-steps-one-sample"));
        }
        let plain = |draw: &Draw| draw.stencil.is_none() && draw.depth == scene.draws[0].depth;
        if scene.draws.iter().all(plain) {
            play_depth_of(scene, true, budget)
        } else {
            Ok(play_stencil_of(scene, budget))
        }
    }

    fn settings(&self, scene: &Scene) -> Vec<Setting> {
        settings_of_depth(scene)
    }
}
