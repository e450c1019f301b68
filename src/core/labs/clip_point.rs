//! The lab that clips a point against a rectangular window.

use super::{Family, clip_line::check_window};
use crate::{
    clip::{
        line::{Point, Window},
        point,
    },
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Scene, each_finite},
};
use serde::{Deserialize, Serialize};

/// A point against a window. It has no arithmetic: a comparison is exact in each.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClipPoint {
    /// xmin, ymin, xmax, ymax; y up; closed.
    pub window: [f32; 4],
    /// x and y.
    pub point: Point,
}

impl Family for ClipPoint {
    fn first() -> Self {
        Self { window: [3.5, 2.0, 9.0, 6.5], point: [10.5, 4.5] }
    }

    fn name(&self) -> &'static str {
        "point-clipping"
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        check_window(&self.window)?;
        each_finite(&self.point).map_err(|e| e.within("point"))
    }

    fn play(&self, _: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let window = Window::new(self.window).ok_or_else(|| Message::new("error-window"))?;
        Ok(Box::new(point::play(self.point, window, budget)))
    }
}
