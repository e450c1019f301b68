//! The labs that clip a line against a rectangular window.

use super::Family;
use crate::{
    clip::line::{
        Algorithm, Mistakes, Window, cohen_sutherland, cyrus_beck, liang_barsky, midpoint,
        nicholl_lee_nicholl,
    },
    compare::{Choice, Setting},
    math::Arithmetic,
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Problem, Scene, each_finite, refuse_if},
};
use serde::{Deserialize, Serialize};

/// Fixed point is for scan conversion.
pub(super) const ARITHMETICS: [Arithmetic; 3] = [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64];

/// A line against a window.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClipLine {
    /// The lab's own algorithm; all have the same inputs.
    #[serde(skip)]
    pub algorithm: Algorithm,
    /// xmin, ymin, xmax, ymax; y up; closed.
    pub window: [f32; 4],
    /// x and y of the first end, x and y of the second.
    pub segment: [f32; 4],
    /// What the cuts are computed in.
    #[serde(default)]
    pub arithmetic: Arithmetic,
    /// What is got wrong on purpose; the algorithms other than Cohen-Sutherland have no such mistakes
    /// and stay right.
    #[serde(default, skip_serializing_if = "Mistakes::is_empty")]
    pub mistakes: Mistakes,
}

/// A window has its minima first.
pub(super) fn check_window(window: &[f32; 4]) -> Checked {
    each_finite(window).map_err(|e| e.within("window"))?;
    let [xmin, ymin, xmax, ymax] = *window;
    refuse_if(xmin > xmax || ymin > ymax, "window", Problem::WindowReversed)
}

impl Family for ClipLine {
    fn first() -> Self {
        Self {
            algorithm: Algorithm::default(),
            window: [3.5, 2.0, 9.0, 6.5],
            segment: [0.5, 0.5, 10.5, 8.5],
            arithmetic: Arithmetic::Exact,
            mistakes: Mistakes::NONE,
        }
    }

    fn named(self, name: &'static str) -> Self {
        let algorithm = Algorithm::ALL.into_iter().find(|algorithm| algorithm.name() == name);
        Self { algorithm: algorithm.unwrap_or_default(), ..self }
    }

    fn name(&self) -> &'static str {
        self.algorithm.name()
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        check_window(&self.window)?;
        each_finite(&self.segment).map_err(|e| e.within("segment"))?;
        check_arithmetic(self.arithmetic)
    }

    fn play(&self, _: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let Self { algorithm, window, segment: [x1, y1, x2, y2], arithmetic, mistakes } = *self;
        let window = Window::new(window).ok_or_else(|| Message::new("error-window"))?;
        let segment = [[x1, y1], [x2, y2]];
        Ok(match algorithm {
            Algorithm::CohenSutherland => {
                let settings = cohen_sutherland::Settings { arithmetic, mistakes };
                Box::new(cohen_sutherland::play(segment, window, settings, budget))
            }
            Algorithm::LiangBarsky => Box::new(liang_barsky::play(segment, window, arithmetic, budget)),
            Algorithm::CyrusBeck => Box::new(cyrus_beck::play(segment, window.into(), arithmetic, budget)),
            Algorithm::Midpoint => Box::new(midpoint::play(segment, window, arithmetic, budget)),
            Algorithm::NichollLeeNicholl => {
                Box::new(nicholl_lee_nicholl::play(segment, window, arithmetic, budget))
            }
        })
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        ARITHMETICS.map(Setting::Arithmetic).to_vec()
    }

    fn choices(&self) -> Vec<Choice> {
        let mistakes = [
            ("[]", "mistake-none"),
            ("[\"or-for-and\"]", "mistake-or-for-and"),
            ("[\"other-order\"]", "mistake-other-order"),
        ];
        match self.algorithm {
            Algorithm::CohenSutherland => Choice::all("mistakes", "compare-mistake", mistakes).to_vec(),
            _ => Vec::new(),
        }
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

/// Refuses an arithmetic that the lab does not compute in.
pub(super) fn check_arithmetic(arithmetic: Arithmetic) -> Checked {
    let known = ARITHMETICS.map(Arithmetic::name).to_vec();
    let problem = Problem::UnknownName { name: arithmetic.name().into(), known };
    refuse_if(!ARITHMETICS.contains(&arithmetic), "arithmetic", problem)
}
