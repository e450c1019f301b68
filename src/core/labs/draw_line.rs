//! The labs that draw a line of one pixel's width.

use super::Family;
use crate::{
    compare::Setting,
    math::Arithmetic,
    message::Message,
    raster::line::{Algorithm, FARTHEST, bresenham, dda, diamond_exit},
    replay::{Budget, Playback},
    scene::{Checked, FieldError, Problem, Scene, each_finite, refuse_if},
};
use serde::{Deserialize, Serialize};

/// A line between two points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DrawLine {
    /// The lab's own algorithm; all have the same inputs.
    #[serde(skip)]
    pub algorithm: Algorithm,
    /// x and y of the first end, x and y of the second, in pixels, y down.
    pub segment: [f32; 4],
    /// What positions are computed in; the DDA alone rounds.
    #[serde(default)]
    pub arithmetic: Arithmetic,
}

impl Family for DrawLine {
    fn first() -> Self {
        let segment = [1.5, 1.75, 11.25, 6.5];
        Self { algorithm: Algorithm::default(), segment, arithmetic: Arithmetic::default() }
    }

    fn named(self, name: &'static str) -> Self {
        let algorithm = Algorithm::ALL.into_iter().find(|algorithm| algorithm.name() == name);
        let algorithm = algorithm.unwrap_or_default();
        // Compared with an algorithm that rounds, the others stay exact.
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
        each_finite(&self.segment).map_err(|e| e.within("segment"))?;
        let farthest = FARTHEST as f32;
        for (i, coordinate) in self.segment.iter().enumerate() {
            let range = Problem::Range { min: (-farthest).into(), max: farthest.into() };
            if coordinate.abs() > farthest {
                return Err(FieldError::at(i, range).within("segment"));
            }
        }
        let known = self.algorithm.arithmetics();
        let problem = Problem::UnknownName {
            name: self.arithmetic.name().into(),
            known: known.iter().copied().map(Arithmetic::name).collect(),
        };
        refuse_if(!known.contains(&self.arithmetic), "arithmetic", problem)
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let Self { algorithm, segment: [x1, y1, x2, y2], arithmetic } = *self;
        let ends = [[x1, y1], [x2, y2]];
        Ok(match algorithm {
            Algorithm::Dda => Box::new(dda::play(ends, scene.size, arithmetic, budget)),
            Algorithm::Bresenham => Box::new(bresenham::play(ends, scene.size, budget)),
            Algorithm::DiamondExit => Box::new(diamond_exit::play(ends, scene.size, budget)),
        })
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        self.algorithm.arithmetics().iter().copied().map(Setting::Arithmetic).collect()
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
