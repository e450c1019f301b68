//! The lab that clips a triangle at one plane.

use super::Family;
use crate::{
    clip::polygon::clip_plane::{self, HalfSpace},
    compare::Setting,
    math::Arithmetic,
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Problem, Scene, each_finite, refuse_if},
};
use serde::{Deserialize, Serialize};

/// Fixed point is for scan conversion.
const ARITHMETICS: [Arithmetic; 3] = [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64];

/// A triangle and a plane, in any space of three coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClipPlane {
    /// Right-handed, y up.
    pub vertices: [[f32; 3]; 3],
    /// A point on the plane.
    pub point: [f32; 3],
    /// Points inwards; of any length but zero.
    pub normal: [f32; 3],
    /// What distances and new vertices are computed in.
    #[serde(default)]
    pub arithmetic: Arithmetic,
}

impl Family for ClipPlane {
    fn first() -> Self {
        Self {
            vertices: [[-1.5, -0.5, 1.0], [2.5, -1.0, 0.0], [0.5, 2.0, -1.0]],
            point: [1.0, 0.0, 0.0],
            normal: [-1.0, 0.0, 0.0],
            arithmetic: Arithmetic::Exact,
        }
    }

    fn name(&self) -> &'static str {
        "clip-plane"
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        for (i, vertex) in self.vertices.iter().enumerate() {
            each_finite(vertex).map_err(|e| e.within(i).within("vertices"))?;
        }
        each_finite(&self.point).map_err(|e| e.within("point"))?;
        each_finite(&self.normal).map_err(|e| e.within("normal"))?;
        let problem = Problem::UnknownName {
            name: self.arithmetic.name().into(),
            known: ARITHMETICS.map(Arithmetic::name).to_vec(),
        };
        refuse_if(!ARITHMETICS.contains(&self.arithmetic), "arithmetic", problem)
    }

    fn play(&self, _: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let plane = HalfSpace { point: self.point, normal: self.normal };
        Ok(Box::new(clip_plane::play(self.vertices, plane, self.arithmetic, budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        ARITHMETICS.map(Setting::Arithmetic).to_vec()
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
