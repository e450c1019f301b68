//! The labs that clip a polygon against a rectangular window.

use super::Family;
use crate::{
    clip::{
        line::{Point, Window},
        polygon::{
            Algorithm,
            sutherland_hodgman::{self, Mistake, Settings, SideOrder},
            weiler_atherton,
        },
    },
    compare::{Choice, Setting},
    math::Arithmetic,
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, FieldError, Problem, Scene, each_finite, refuse_if},
};
use serde::{Deserialize, Serialize};

/// A polygon against a window.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClipPolygon {
    /// The lab's own algorithm; all have the same inputs.
    #[serde(skip)]
    pub algorithm: Algorithm,
    /// xmin, ymin, xmax, ymax; y up; closed.
    pub window: [f32; 4],
    /// The corners in order, at least three; the last one joins the first.
    pub polygon: Vec<Point>,
    /// More contours: neighbours for Sutherland-Hodgman, which clips each by itself; holes and islands for
    /// Weiler-Atherton, by the even-odd rule.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub contours: Vec<Vec<Point>>,
    /// In which order the sides cut, side by side.
    #[serde(default)]
    pub order: SideOrder,
    /// What the cuts are computed in.
    #[serde(default)]
    pub arithmetic: Arithmetic,
    /// What is done wrong on purpose.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mistake: Option<Mistake>,
}

impl ClipPolygon {
    /// The polygon and what comes with it.
    pub fn all(&self) -> Vec<Vec<Point>> {
        std::iter::once(&self.polygon).chain(&self.contours).cloned().collect()
    }
}

impl Family for ClipPolygon {
    fn first() -> Self {
        Self {
            algorithm: Algorithm::default(),
            window: [3.0, 2.0, 9.0, 6.5],
            polygon: vec![[1.5, 3.0], [10.5, 1.0], [6.0, 8.0]],
            contours: Vec::new(),
            order: SideOrder::default(),
            arithmetic: Arithmetic::Exact,
            mistake: None,
        }
    }

    fn named(self, name: &'static str) -> Self {
        let algorithm = Algorithm::ALL.into_iter().find(|algorithm| algorithm.name() == name);
        let algorithm = algorithm.unwrap_or_default();
        // Not every algorithm rounds: compared with one that does, the other stays exact.
        let known = algorithm.arithmetics().contains(&self.arithmetic);
        let arithmetic = if known { self.arithmetic } else { Arithmetic::default() };
        Self { algorithm, arithmetic, ..self }
    }

    fn name(&self) -> &'static str {
        self.algorithm.name()
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        each_finite(&self.window).map_err(|e| e.within("window"))?;
        let [xmin, ymin, xmax, ymax] = self.window;
        refuse_if(xmin > xmax || ymin > ymax, "window", Problem::WindowReversed)?;
        corners(&self.polygon).map_err(|e| e.within("polygon"))?;
        for (i, contour) in self.contours.iter().enumerate() {
            corners(contour).map_err(|e| e.within(i).within("contours"))?;
        }
        let known = self.algorithm.arithmetics();
        let problem = Problem::UnknownName {
            name: self.arithmetic.name().into(),
            known: known.iter().copied().map(Arithmetic::name).collect(),
        };
        refuse_if(!known.contains(&self.arithmetic), "arithmetic", problem)
    }

    fn play(&self, _: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let window = Window::new(self.window).ok_or_else(|| Message::new("error-window"))?;
        let Self { order, arithmetic, mistake, .. } = *self;
        Ok(match self.algorithm {
            Algorithm::SutherlandHodgman => {
                let settings = Settings { arithmetic, order, mistake };
                Box::new(sutherland_hodgman::play(&self.all(), window, settings, budget))
            }
            Algorithm::WeilerAtherton => Box::new(weiler_atherton::play(&self.all(), window, budget)),
        })
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        self.algorithm.arithmetics().iter().copied().map(Setting::Arithmetic).collect()
    }

    fn choices(&self) -> Vec<Choice> {
        let mistakes = [
            ("null", "mistake-none"),
            ("\"two-sides\"", "mistake-two-sides"),
            ("\"either-end\"", "mistake-either-end"),
        ];
        let orders = [
            ("\"left-right-bottom-top\"", "word-side-order-left-right-bottom-top"),
            ("\"bottom-top-left-right\"", "word-side-order-bottom-top-left-right"),
            ("\"top-right-bottom-left\"", "word-side-order-top-right-bottom-left"),
            ("\"left-bottom-right-top\"", "word-side-order-left-bottom-right-top"),
        ];
        let mut all = Choice::all("mistake", "compare-mistake", mistakes).to_vec();
        all.extend(Choice::all("order", "compare-order", orders));
        all
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

/// At least three, all finite.
fn corners(polygon: &[Point]) -> Checked {
    if polygon.len() < 3 {
        return Err(FieldError::here(Problem::TooShort { least: 3, found: polygon.len() }));
    }
    polygon.iter().enumerate().try_for_each(|(i, corner)| each_finite(corner).map_err(|e| e.within(i)))
}
