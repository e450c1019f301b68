//! The lab that draws triangles with several samples a pixel.

use super::{Family, scan_settings};
use crate::{
    compare::{Choice, Setting},
    message::{Message, Value},
    raster::{
        Samples,
        msaa::{self, Conventions, Shading},
    },
    replay::{Budget, Playback},
    scene::{Checked, Scene, each_row_finite},
};
use serde::{Deserialize, Serialize};

/// Larger images are not stepped.
const MOST_SIDE: u32 = 256;

/// Triangles, sample by sample.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Msaa {
    /// x and y in pixels, y growing as the scene says, and a shade from 0 to 1.
    pub triangles: Vec<[[f32; 3]; 3]>,
    /// Samples of a pixel: 1, 2, 4 or 8.
    #[serde(default = "four")]
    pub samples: Samples,
    /// Where the shade of a pixel is computed.
    #[serde(default)]
    pub shading: Shading,
}

fn four() -> Samples {
    Samples::Four
}

impl Family for Msaa {
    fn first() -> Self {
        Self {
            triangles: vec![[[0.75, 4.5, 1.0], [7.25, 5.25, 1.0], [2.5, 0.75, 1.0]]],
            samples: four(),
            shading: Shading::default(),
        }
    }

    fn name(&self) -> &'static str {
        "msaa"
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        let mut triangles = self.triangles.iter().enumerate();
        triangles.try_for_each(|(i, t)| each_row_finite(i, t).map_err(|e| e.within("triangles")))
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        if scene.size.iter().any(|side| *side > MOST_SIDE) {
            return Err(Message::new("error-too-large-to-step").with("most", Value::from(MOST_SIDE)));
        }
        let Self { samples, shading, .. } = *self;
        let conventions = Conventions { samples, shading, raster: scan_settings(scene) };
        Ok(Box::new(msaa::play(self.triangles.clone(), conventions, budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        Setting::of_scan()
    }

    fn choices(&self) -> Vec<Choice> {
        let samples = [
            ("4", "word-samples-4"),
            ("1", "word-samples-1"),
            ("2", "word-samples-2"),
            ("8", "word-samples-8"),
        ];
        let shadings = [
            ("\"centre\"", "word-shading-centre"),
            ("\"centroid\"", "word-shading-centroid"),
            ("\"per-sample\"", "word-shading-per-sample"),
        ];
        let mut all = Choice::all("samples", "compare-samples", samples).to_vec();
        all.extend(Choice::all("shading", "compare-shading", shadings));
        all
    }
}
