//! The lab that clips a point against a rectangular window.

use super::{
    Family,
    clip_line::{ARITHMETICS, check_arithmetic, check_window},
};
use crate::{
    clip::{
        line::{Point, Window},
        point,
    },
    compare::Setting,
    math::Arithmetic,
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Scene, each_finite},
};
use serde::{Deserialize, Serialize};

/// A point against a window.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClipPoint {
    /// xmin, ymin, xmax, ymax; y up; closed.
    pub window: [f32; 4],
    /// x and y.
    pub point: Point,
    /// What the comparisons are made in: all answer alike.
    #[serde(default)]
    pub arithmetic: Arithmetic,
}

impl Family for ClipPoint {
    fn first() -> Self {
        Self { window: [3.5, 2.0, 9.0, 6.5], point: [10.5, 4.5], arithmetic: Arithmetic::Exact }
    }

    fn name(&self) -> &'static str {
        "point-clipping"
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        check_window(&self.window)?;
        each_finite(&self.point).map_err(|e| e.within("point"))?;
        check_arithmetic(self.arithmetic)
    }

    fn play(&self, _: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let window = Window::new(self.window).ok_or_else(|| Message::new("error-window"))?;
        Ok(Box::new(point::play(self.point, window, self.arithmetic, budget)))
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
