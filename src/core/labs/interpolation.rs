//! The labs that interpolate an attribute over one triangle.

use super::{Family, scan_settings};
use crate::{
    compare::{Choice, Setting},
    interpolate::{Mode, Subject, area_ratios, plane_equation},
    math::Arithmetic,
    message::Message,
    raster::view::view_of,
    replay::{Budget, Playback},
    scene::{Checked, Scene, each_finite, each_row_finite},
};
use serde::{Deserialize, Serialize};

/// A triangle with an attribute, and a point.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Interpolation {
    /// x and y in pixels, y growing as the scene says; w of clip space.
    pub vertices: [[f32; 3]; 3],
    /// What the attribute is at each vertex.
    pub attribute: [f32; 3],
    /// The point, in pixels; the plane equation fills the row that it lies in.
    pub at: [f32; 2],
    /// Along which line values change evenly.
    #[serde(default)]
    pub mode: Mode,
    /// What is computed in; fixed point snaps the vertices to 1/256 pixel.
    #[serde(default)]
    pub arithmetic: Arithmetic,
}

/// One point, by what each vertex weighs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct AreaRatios(pub Interpolation);

/// A row of pixels, by planes over the screen.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct PlaneEquation(pub Interpolation);

impl Interpolation {
    const FIRST: Self = Self {
        vertices: [[1.0, 10.0, 2.0], [14.0, 7.0, 6.0], [5.0, 1.0, 3.0]],
        attribute: [0.0, 1.0, 0.5],
        at: [6.5, 6.5],
        mode: Mode::Perspective,
        arithmetic: Arithmetic::Exact,
    };

    fn subject(&self) -> Subject {
        Subject { vertices: self.vertices, attribute: self.attribute, at: self.at }
    }

    fn check(&self) -> Checked {
        each_row_finite("vertices", &self.vertices)?;
        each_finite(&self.attribute).map_err(|e| e.within("attribute"))?;
        each_finite(&self.at).map_err(|e| e.within("at"))
    }

    fn arithmetic(&self, like: Setting) -> Option<Setting> {
        matches!(like, Setting::Arithmetic(_)).then_some(Setting::Arithmetic(self.arithmetic))
    }

    fn set(&mut self, setting: Setting) {
        if let Setting::Arithmetic(arithmetic) = setting {
            self.arithmetic = arithmetic;
        }
    }
}

pub(super) fn modes() -> Vec<Choice> {
    let modes = [("\"perspective\"", "word-perspective"), ("\"affine\"", "word-affine")];
    Choice::all("mode", "compare-mode", modes).to_vec()
}

impl Family for AreaRatios {
    fn first() -> Self {
        Self(Interpolation::FIRST)
    }

    fn name(&self) -> &'static str {
        "area-ratios"
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        self.0.check()
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let Interpolation { vertices, mode, arithmetic, .. } = self.0;
        let view = view_of(&[vertices.map(|[x, y, _]| [x, y])], &scan_settings(scene));
        Ok(Box::new(area_ratios::play(mode, self.0.subject(), arithmetic, view, budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        Arithmetic::ALL.map(Setting::Arithmetic).to_vec()
    }

    fn choices(&self) -> Vec<Choice> {
        modes()
    }

    fn setting(&self, like: Setting) -> Option<Setting> {
        self.0.arithmetic(like)
    }

    fn set(&mut self, setting: Setting) {
        self.0.set(setting);
    }
}

impl Family for PlaneEquation {
    fn first() -> Self {
        Self(Interpolation::FIRST)
    }

    fn name(&self) -> &'static str {
        "plane-equation"
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        self.0.check()
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let Interpolation { mode, arithmetic, .. } = self.0;
        let settings = scan_settings(scene);
        Ok(Box::new(plane_equation::play(mode, self.0.subject(), arithmetic, settings, budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        Arithmetic::ALL.map(Setting::Arithmetic).into_iter().chain(Setting::of_scan()).collect()
    }

    fn choices(&self) -> Vec<Choice> {
        modes()
    }

    fn setting(&self, like: Setting) -> Option<Setting> {
        self.0.arithmetic(like)
    }

    fn set(&mut self, setting: Setting) {
        self.0.set(setting);
    }
}
