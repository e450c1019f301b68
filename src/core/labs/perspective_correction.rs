//! The lab that draws a checkered parallelogram with and without perspective correction.

use super::{Family, scan_settings};
use crate::{
    compare::{Choice, Setting},
    interpolate::{
        Mode,
        perspective_correction::{self, Subject},
    },
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Problem, Scene, each_row_finite, refuse_if},
    transform::{Viewport, matrices, screen},
};
use serde::{Deserialize, Serialize};

/// More squares along a side than these cannot be told apart.
const MOST_SQUARES: u32 = 64;

/// A checkered parallelogram before the scene's camera.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PerspectiveCorrection {
    /// Three corners in camera space: where (u, v) is (0, 0), (1, 0) and (0, 1). The eye is at the origin
    /// and looks along -z.
    pub corners: [[f32; 3]; 3],
    /// Squares of the checker along each side.
    #[serde(default = "squares")]
    pub squares: u32,
    /// Both ends of the line on the screen, in pixels; left out: up the middle of the parallelogram.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub line: Option<[[f32; 2]; 2]>,
    /// How texture coordinates are interpolated.
    #[serde(default)]
    pub mode: Mode,
}

fn squares() -> u32 {
    8
}

impl PerspectiveCorrection {
    /// The parallelogram on the screen; `None` if it reaches behind the eye.
    pub fn subject(&self, scene: &Scene) -> Option<Subject> {
        let viewport = Viewport { size: scene.size, depth_range: scene.depth_range, y_axis: scene.y_axis };
        let projection =
            matrices::projection(&scene.camera, viewport.aspect(), scene.depth_range, scene.reversed);
        let [origin, right, up] = self.corners.map(|corner| corner.map(f64::from));
        // Where (u, v) is.
        let place = |u: f64, v: f64| {
            let at = |i: usize| (origin[i] + u * (right[i] - origin[i]) + v * (up[i] - origin[i])) as f32;
            let clip = matrices::apply(&projection, [at(0), at(1), at(2), 1.0]);
            let point = viewport.to_screen(screen::divide(clip));
            (clip[3] > 0.0 && point.iter().all(|c| c.is_finite())).then_some(point)
        };
        let corners = [place(0.0, 0.0)?, place(1.0, 0.0)?, place(1.0, 1.0)?, place(0.0, 1.0)?];
        let [foot, head] = [place(0.5, 0.0)?, place(0.5, 1.0)?].map(|[x, y, ..]| [x, y]);
        Some(Subject { corners, squares: self.squares, line: self.line.unwrap_or([foot, head]) })
    }
}

impl Family for PerspectiveCorrection {
    fn first() -> Self {
        Self {
            corners: [[-1.5, -1.0, -2.0], [1.5, -1.0, -2.0], [-1.5, 1.25, -6.0]],
            squares: squares(),
            line: None,
            mode: Mode::default(),
        }
    }

    fn name(&self) -> &'static str {
        "perspective-correction"
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        each_row_finite("corners", &self.corners)?;
        self.line.iter().try_for_each(|line| each_row_finite("line", line))?;
        let range = Problem::Range { min: 1.0, max: f64::from(MOST_SQUARES) };
        refuse_if(!(1..=MOST_SQUARES).contains(&self.squares), "squares", range)
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let subject = self.subject(scene).ok_or_else(|| Message::new("error-behind-the-eye"))?;
        Ok(Box::new(perspective_correction::play(self.mode, subject, scan_settings(scene), budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        Setting::of_scan()
    }

    fn choices(&self) -> Vec<Choice> {
        super::interpolation::modes()
    }
}
