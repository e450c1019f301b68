//! The lab that fills a polygon row by row.

use super::Family;
use crate::{
    compare::{Choice, Setting},
    math::Arithmetic,
    message::Message,
    raster::{
        YAxis,
        edge_table::{self, Point, Settings, WindingRule},
    },
    replay::{Budget, Playback},
    scene::{Checked, FieldError, Problem, Scene, each_row_finite},
};
use serde::{Deserialize, Serialize};

/// A polygon of closed contours, and what is inside of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FillPolygon {
    /// The corners of each contour in order, at least three; the last one joins the first. In pixels, y
    /// growing as the scene says.
    pub contours: Vec<Vec<Point>>,
    /// What is inside.
    #[serde(default)]
    pub winding: WindingRule,
    /// What crossings are computed in.
    #[serde(default)]
    pub arithmetic: Arithmetic,
}

impl Family for FillPolygon {
    fn first() -> Self {
        let star = vec![[6.5, 0.75], [9.25, 9.0], [2.0, 3.75], [11.0, 3.75], [3.75, 9.0]];
        Self { contours: vec![star], winding: WindingRule::default(), arithmetic: Arithmetic::default() }
    }

    fn name(&self) -> &'static str {
        "edge-table"
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        if self.contours.is_empty() {
            return Err(FieldError::at("contours", Problem::TooShort { least: 1, found: 0 }));
        }
        for (i, contour) in self.contours.iter().enumerate() {
            let short = Problem::TooShort { least: 3, found: contour.len() };
            let long_enough = if contour.len() < 3 { Err(FieldError::at(i, short)) } else { Ok(()) };
            long_enough.and_then(|()| each_row_finite(i, contour)).map_err(|e| e.within("contours"))?;
        }
        Ok(())
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let Self { winding, arithmetic, .. } = *self;
        let settings = Settings { size: scene.size, winding, y_axis: scene.y_axis, arithmetic };
        Ok(Box::new(edge_table::play(&self.contours, settings, budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        let arithmetics = Arithmetic::ALL.map(Setting::Arithmetic);
        arithmetics.into_iter().chain(YAxis::ALL.map(Setting::YAxis)).collect()
    }

    fn choices(&self) -> Vec<Choice> {
        let rules = [("\"even-odd\"", "word-winding-even-odd"), ("\"non-zero\"", "word-winding-non-zero")];
        Choice::all("winding", "compare-winding", rules).to_vec()
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
