//! The lab that draws a point.

use super::{
    Family,
    clip_line::{ARITHMETICS, check_arithmetic},
};
use crate::{
    compare::Setting,
    math::Arithmetic,
    message::Message,
    raster::point,
    replay::{Budget, Playback},
    scene::{Checked, Problem, Scene, each_finite, refuse_if},
};
use serde::{Deserialize, Serialize};

/// A point and its size.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DrawPoint {
    /// x and y in pixels, y down.
    pub point: [f32; 2],
    /// The side of its square, in pixels.
    #[serde(default = "one")]
    pub size: f32,
    /// What its sides are computed in.
    #[serde(default)]
    pub arithmetic: Arithmetic,
}

fn one() -> f32 {
    1.0
}

impl Family for DrawPoint {
    fn first() -> Self {
        Self { point: [6.25, 5.0], size: 3.0, arithmetic: Arithmetic::Exact }
    }

    fn name(&self) -> &'static str {
        "points"
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        each_finite(&self.point).map_err(|e| e.within("point"))?;
        refuse_if(!self.size.is_finite(), "size", Problem::NotFinite)?;
        refuse_if(self.size < 0.0, "size", Problem::Negative)?;
        check_arithmetic(self.arithmetic)
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let settings = point::Settings { size: scene.size, arithmetic: self.arithmetic };
        Ok(Box::new(point::play(self.point, self.size, settings, budget)))
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
