//! The labs that fill one triangle: row by row, or by edge functions on one way or another.

use super::{Family, nothing_to_step, scan_settings};
use crate::{
    compare::{Choice, Setting},
    math::Arithmetic,
    message::Message,
    pipeline::screen_triangles,
    raster::{
        self, Algorithm, Mistake,
        aabb::Aabb,
        backtracking::Backtracking,
        homogeneous, scanline,
        tiled::Tiled,
        traversal::{self, Show},
        zigzag::Zigzag,
    },
    replay::{Budget, Playback},
    scene::{Checked, FieldError, Problem, Scene, each_row_finite},
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
    #[serde(default, skip_serializing_if = "is_default")]
    pub triangle: usize,
    /// What edges and crossings are computed in.
    #[serde(default, skip_serializing_if = "is_default")]
    pub arithmetic: Arithmetic,
    /// What is got wrong on purpose.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mistake: Option<Mistake>,
    /// What a traversal shows of the centres; the scan line has none to show.
    #[serde(default, skip_serializing_if = "is_default")]
    pub show: Show,
}

/// Whether a field may be left out of the file.
pub(super) fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// Refuses a mistake that cannot be made there.
pub(super) fn check_mistake(made: Option<Mistake>, known: &[Mistake]) -> Checked {
    let Some(mistake) = made.filter(|mistake| !known.contains(mistake)) else { return Ok(()) };
    let known = known.iter().map(|mistake| mistake.name()).collect();
    Err(FieldError::at("mistake", Problem::UnknownName { name: mistake.name().into(), known }))
}

impl FillTriangle {
    /// Of these vertices, exactly.
    pub fn of(algorithm: Algorithm, vertices: [[f32; 2]; 3]) -> Self {
        Self { vertices: Some(vertices), ..Self::first() }.with(algorithm)
    }

    fn with(self, algorithm: Algorithm) -> Self {
        let made = Self::mistakes(algorithm);
        Self { algorithm, mistake: self.mistake.filter(|mistake| made.contains(mistake)), ..self }
    }

    /// The mistakes that can be made in an algorithm.
    pub fn mistakes(algorithm: Algorithm) -> &'static [Mistake] {
        if algorithm == Algorithm::Scanline { &Mistake::OF_SCANLINE } else { &Mistake::OF_EDGES }
    }
}

impl Family for FillTriangle {
    fn first() -> Self {
        Self {
            algorithm: Algorithm::Scanline,
            vertices: None,
            triangle: 0,
            arithmetic: Arithmetic::Exact,
            mistake: None,
            show: Show::Pixels,
        }
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
        self.vertices.iter().try_for_each(|vertices| each_row_finite("vertices", vertices))?;
        check_mistake(self.mistake, Self::mistakes(self.algorithm))
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let of_scene =
            || screen_triangles(scene).get(self.triangle).map(|t| t.vertices.map(|[x, y, _]| [x, y]));
        let vertices = self.vertices.or_else(of_scene).ok_or_else(|| nothing_to_step(self))?;
        let settings =
            raster::Settings { arithmetic: self.arithmetic, mistake: self.mistake, ..scan_settings(scene) };
        let show = self.show;
        Ok(match self.algorithm {
            Algorithm::Scanline => Box::new(scanline::play(vertices, settings, budget)),
            Algorithm::Aabb => Box::new(traversal::play_shown::<Aabb>(vertices, settings, show, budget)),
            // It has a lab with inputs of its own; here every w is 1.
            Algorithm::Homogeneous => {
                let vertices = settings.vertices(vertices).map(|[x, y]| [x, y, 1.0]);
                Box::new(homogeneous::play(vertices, None, settings, budget))
            }
            Algorithm::Backtracking => {
                Box::new(traversal::play_shown::<Backtracking>(vertices, settings, show, budget))
            }
            Algorithm::Zigzag => Box::new(traversal::play_shown::<Zigzag>(vertices, settings, show, budget)),
            Algorithm::Tiled => Box::new(traversal::play_shown::<Tiled>(vertices, settings, show, budget)),
        })
    }

    fn settings(&self, scene: &Scene) -> Vec<Setting> {
        let arithmetics = Arithmetic::ALL.map(Setting::Arithmetic).to_vec();
        let facing = if self.vertices.is_some() { Vec::new() } else { Setting::of_facing(scene) };
        [arithmetics, Setting::of_scan(), facing].concat()
    }

    fn choices(&self) -> Vec<Choice> {
        let none = ("null", "mistake-none");
        let made = [
            ("\"epsilon-small\"", "mistake-epsilon-small"),
            ("\"epsilon-large\"", "mistake-epsilon-large"),
            ("\"whole-vertices\"", "mistake-whole-vertices"),
        ];
        let [small, large, whole] = made;
        match self.algorithm {
            Algorithm::Scanline => {
                let slopes = ("\"accumulated-slopes\"", "mistake-accumulated-slopes");
                Choice::all("mistake", "compare-mistake", [none, small, large, slopes, whole]).to_vec()
            }
            _ => Choice::all("mistake", "compare-mistake", [none, small, large, whole]).to_vec(),
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
