//! The lab that fills one triangle row by row.

use super::{Family, nothing_to_step, scan_settings};
use crate::{
    compare::Setting,
    message::Message,
    pipeline::screen_triangles,
    raster::scanline,
    replay::{Budget, Playback},
    scene::{Checked, Scene, each_row_finite},
};
use serde::{Deserialize, Serialize};

/// One triangle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scanline {
    /// In pixels, y growing as the scene says; `None` takes a triangle of the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vertices: Option<[[f32; 2]; 3]>,
    /// Which of the pipeline's screen triangles, when there are no vertices.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub triangle: usize,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands it over so")]
fn is_zero(index: &usize) -> bool {
    *index == 0
}

impl Family for Scanline {
    fn first() -> Self {
        Self { vertices: None, triangle: 0 }
    }

    fn name(&self) -> &'static str {
        "scanline"
    }

    fn is_of_scene(&self) -> bool {
        self.vertices.is_none()
    }

    fn check(&self, _: &Scene) -> Checked {
        self.vertices.iter().try_for_each(|vertices| each_row_finite("vertices", vertices))
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let of_scene =
            || screen_triangles(scene).get(self.triangle).map(|t| t.vertices.map(|[x, y, _]| [x, y]));
        let vertices = self.vertices.or_else(of_scene).ok_or_else(|| nothing_to_step(self))?;
        Ok(Box::new(scanline::play(vertices, scan_settings(scene), budget)))
    }

    fn settings(&self, scene: &Scene) -> Vec<Setting> {
        let facing = if self.vertices.is_some() { Vec::new() } else { Setting::of_facing(scene) };
        [Setting::of_scan(), facing].concat()
    }
}
