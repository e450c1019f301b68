//! The lab that tests the depth of every fragment.

use super::{Family, scan_settings};
use crate::{
    compare::Setting,
    depth::{DepthFormat, DepthState, z_buffer},
    message::Message,
    pipeline::{screen_names, screen_triangles},
    raster,
    replay::{Budget, Playback},
    scene::{Checked, Scene, each_row_finite},
};
use serde::{Deserialize, Serialize};

/// Triangles, fragment by fragment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ZBuffer {
    /// In pixels with depth, y growing as the scene says; `None` takes the scene's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub triangles: Option<Vec<[[f32; 3]; 3]>>,
}

impl Family for ZBuffer {
    fn first() -> Self {
        Self { triangles: None }
    }

    fn name(&self) -> &'static str {
        "z-buffer"
    }

    fn is_of_scene(&self) -> bool {
        self.triangles.is_none()
    }

    fn check(&self, _: &Scene) -> Checked {
        let triangles = self.triangles.iter().flatten();
        triangles
            .enumerate()
            .try_for_each(|(i, triangle)| each_row_finite(i, triangle).map_err(|e| e.within("triangles")))
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        match &self.triangles {
            Some(triangles) => {
                let settings = depth_settings(scene, DepthState::default());
                Ok(Box::new(z_buffer::play(triangles.clone(), Vec::new(), settings, budget)))
            }
            None => play_depth_of(scene, budget),
        }
    }

    fn settings(&self, scene: &Scene) -> Vec<Setting> {
        match &self.triangles {
            Some(_) => {
                Setting::of_scan().into_iter().chain(DepthFormat::ALL.map(Setting::DepthFormat)).collect()
            }
            None => settings_of_depth(scene),
        }
    }
}

/// The depth test of all of the scene's triangles, which must agree on its state.
pub(super) fn play_depth_of(scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
    let mut states = scene.draws.iter().map(|draw| draw.depth);
    let state = states.next().unwrap_or_default();
    if states.any(|other| other != state) {
        return Err(Message::new("error-mixed-depth-states"));
    }
    let triangles = screen_triangles(scene);
    let names = screen_names(scene, &triangles)
        .zip(&triangles)
        .map(|(text, piece)| z_buffer::Name { text, object: piece.draw as usize })
        .collect();
    let triangles = triangles.iter().map(|triangle| triangle.vertices).collect();
    Ok(Box::new(z_buffer::play(triangles, names, depth_settings(scene, state), budget)))
}

/// What the depth test of all of the scene's triangles reads.
pub(super) fn settings_of_depth(scene: &Scene) -> Vec<Setting> {
    let parts =
        [Setting::of_scan(), Setting::of_depth(scene), Setting::of_transform(), Setting::of_facing(scene)];
    parts.concat()
}

/// The scene's conventions of the depth test.
fn depth_settings(scene: &Scene, state: DepthState) -> z_buffer::Settings {
    z_buffer::Settings {
        algorithm: raster::Algorithm::Scanline,
        raster: scan_settings(scene),
        format: scene.depth_format,
        clear: scene.clear.depth,
        state,
    }
}
