//! The whole scene, stage by stage; stepped, it is the depth test of all its triangles.

use super::{
    Family,
    z_buffer::{play_depth_of, settings_of_depth},
};
use crate::{
    compare::Setting,
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Scene},
};
use serde::{Deserialize, Serialize};

/// Most pixels of a scene whose pipeline is stepped as a whole; of larger ones only a lab's own
/// triangles are.
const MOST_PIXELS: u64 = 256 * 256;

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
        let [width, height] = scene.size.map(u64::from);
        let plain = scene.draws.iter().all(|draw| draw.stencil.is_none() && draw.blend.is_none());
        if !plain {
            return Err(Message::new("error-steps-without-stencil"));
        }
        if width * height > MOST_PIXELS {
            return Err(Message::new("error-too-large-to-step").with("most", 256));
        }
        play_depth_of(scene, budget)
    }

    fn settings(&self, scene: &Scene) -> Vec<Setting> {
        settings_of_depth(scene)
    }
}
