//! The lab that clips a line against any convex window.

use super::{
    Family,
    clip_line::{ARITHMETICS, check_arithmetic},
};
use crate::{
    clip::line::{ConvexWindow, Flaw, Point, cyrus_beck},
    compare::Setting,
    math::Arithmetic,
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Problem, Scene, each_finite, each_row_finite, refuse_if},
};
use serde::{Deserialize, Serialize};

/// A line against a convex polygon.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClipConvex {
    /// The window's corners in order, either way round; y up; closed.
    pub polygon: Vec<Point>,
    /// x and y of the first end, x and y of the second.
    pub segment: [f32; 4],
    /// What the cuts are computed in.
    #[serde(default)]
    pub arithmetic: Arithmetic,
}

impl Family for ClipConvex {
    fn first() -> Self {
        Self {
            polygon: vec![[3.5, 2.5], [7.0, 1.5], [9.5, 4.5], [6.5, 7.5], [3.5, 6.0]],
            segment: [1.0, 1.5, 10.5, 8.0],
            arithmetic: Arithmetic::Exact,
        }
    }

    fn name(&self) -> &'static str {
        "cyrus-beck"
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        each_row_finite("polygon", &self.polygon)?;
        let flaw = ConvexWindow::new(&self.polygon).err();
        refuse_if(flaw.is_some(), "polygon", Problem::Polygon(flaw.unwrap_or(Flaw::Corners)))?;
        each_finite(&self.segment).map_err(|e| e.within("segment"))?;
        check_arithmetic(self.arithmetic)
    }

    fn play(&self, _: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let window = ConvexWindow::new(&self.polygon).map_err(|flaw| Message::new(flaw.message()))?;
        let [x1, y1, x2, y2] = self.segment;
        Ok(Box::new(cyrus_beck::play([[x1, y1], [x2, y2]], window, self.arithmetic, budget)))
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
