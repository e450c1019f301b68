//! The labs that fill one triangle: row by row, or by edge functions on one way or another.

use super::{Family, nothing_to_step, scan_settings};
use crate::{
    compare::Setting,
    math::Arithmetic,
    message::Message,
    pipeline::screen_triangles,
    raster::{
        self, Algorithm, aabb::Aabb, backtracking::Backtracking, scanline, tiled::Tiled, traversal,
        zigzag::Zigzag,
    },
    replay::{Budget, Playback},
    scene::{Checked, Scene, each_row_finite},
};
use serde::{Deserialize, Serialize};

/// One triangle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FillTriangle {
    /// The lab's own algorithm; all have the same inputs.
    #[serde(skip)]
    pub algorithm: Algorithm,
    /// In pixels, y growing as the scene says; `None` takes a triangle of the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vertices: Option<[[f32; 2]; 3]>,
    /// Which of the pipeline's screen triangles, when there are no vertices.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub triangle: usize,
    /// What edges and crossings are computed in.
    #[serde(default, skip_serializing_if = "is_default")]
    pub arithmetic: Arithmetic,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands it over so")]
fn is_zero(index: &usize) -> bool {
    *index == 0
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands it over so")]
pub(super) fn is_default(arithmetic: &Arithmetic) -> bool {
    *arithmetic == Arithmetic::default()
}

impl FillTriangle {
    /// Of these vertices, exactly.
    pub fn of(algorithm: Algorithm, vertices: [[f32; 2]; 3]) -> Self {
        Self { vertices: Some(vertices), ..Self::first() }.with(algorithm)
    }

    fn with(self, algorithm: Algorithm) -> Self {
        Self { algorithm, ..self }
    }
}

impl Family for FillTriangle {
    fn first() -> Self {
        Self { algorithm: Algorithm::Scanline, vertices: None, triangle: 0, arithmetic: Arithmetic::Exact }
    }

    fn named(self, name: &'static str) -> Self {
        let algorithm = Algorithm::from_name(name).unwrap_or(self.algorithm);
        self.with(algorithm)
    }

    fn name(&self) -> &'static str {
        self.algorithm.name()
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
        let settings = raster::Settings { arithmetic: self.arithmetic, ..scan_settings(scene) };
        Ok(match self.algorithm {
            Algorithm::Scanline => Box::new(scanline::play(vertices, settings, budget)),
            // With every w = 1 homogeneous edges are these edge functions; their lab has inputs of its own.
            Algorithm::Aabb | Algorithm::Homogeneous => {
                Box::new(traversal::play::<Aabb>(vertices, settings, budget))
            }
            Algorithm::Backtracking => Box::new(traversal::play::<Backtracking>(vertices, settings, budget)),
            Algorithm::Zigzag => Box::new(traversal::play::<Zigzag>(vertices, settings, budget)),
            Algorithm::Tiled => Box::new(traversal::play::<Tiled>(vertices, settings, budget)),
        })
    }

    fn settings(&self, scene: &Scene) -> Vec<Setting> {
        let arithmetics = Arithmetic::ALL.map(Setting::Arithmetic).to_vec();
        let facing = if self.vertices.is_some() { Vec::new() } else { Setting::of_facing(scene) };
        [arithmetics, Setting::of_scan(), facing].concat()
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
