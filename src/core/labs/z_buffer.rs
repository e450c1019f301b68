//! The lab that tests the depth of every fragment.

use super::{Family, scan_settings};
use crate::{
    compare::{Choice, Setting},
    depth::{CompareFunction, DepthFormat, DepthState, z_buffer},
    message::Message,
    pipeline::{screen_names, screen_triangles},
    raster,
    replay::{Budget, Playback},
    scene::{Checked, Scene, each_row_finite},
};
use serde::{Deserialize, Serialize};

/// Triangles, fragment by fragment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ZBuffer {
    /// In pixels with depth, y growing as the scene says; `None` takes the scene's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub triangles: Option<Vec<[[f32; 3]; 3]>>,
    /// How its own triangles are tested; the scene's draws have their own states.
    #[serde(default, skip_serializing_if = "is_default")]
    pub test: CompareFunction,
    /// Whether a passing fragment of its own triangles stores its depth.
    #[serde(default = "yes", skip_serializing_if = "Clone::clone")]
    pub write: bool,
}

fn yes() -> bool {
    true
}

fn is_default(compare: &CompareFunction) -> bool {
    *compare == CompareFunction::default()
}

impl ZBuffer {
    /// With triangles of its own, which are tested and stored as most are.
    pub fn of(triangles: Vec<[[f32; 3]; 3]>) -> Self {
        Self { triangles: Some(triangles), ..Self::first() }
    }

    /// What is run of its own triangles.
    ///
    /// Reversed, near is 1: the depths given count from the other end, 1 - z rounded once, and so do
    /// the clear value and the compare function.
    fn own(
        &self,
        triangles: &[[[f32; 3]; 3]],
        scene: &Scene,
    ) -> (Vec<z_buffer::Triangle>, z_buffer::Settings) {
        let state = DepthState { test: true, compare: self.test, write: self.write };
        let settings = depth_settings(scene, state);
        if !scene.reversed {
            return (triangles.to_vec(), settings);
        }
        let turned = |triangle: &[[f32; 3]; 3]| triangle.map(|[x, y, z]| [x, y, 1.0 - z]);
        let state = DepthState { compare: self.test.mirrored(), ..state };
        let settings = z_buffer::Settings { clear: 1.0 - scene.clear.depth, state, ..settings };
        (triangles.iter().map(turned).collect(), settings)
    }
}

impl Family for ZBuffer {
    fn first() -> Self {
        Self { triangles: None, test: CompareFunction::default(), write: true }
    }

    fn name(&self) -> &'static str {
        "z-buffer"
    }

    fn is_of_scene(&self) -> bool {
        self.triangles.is_none()
    }

    fn check(&self, _: &Scene) -> Checked {
        let triangles = self.triangles.iter().flatten();
        triangles
            .enumerate()
            .try_for_each(|(i, triangle)| each_row_finite(i, triangle).map_err(|e| e.within("triangles")))
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        match &self.triangles {
            Some(triangles) => {
                let (triangles, settings) = self.own(triangles, scene);
                Ok(Box::new(z_buffer::play(triangles, Vec::new(), settings, budget)))
            }
            None => play_depth_of(scene, budget),
        }
    }

    fn settings(&self, scene: &Scene) -> Vec<Setting> {
        match &self.triangles {
            Some(_) => {
                let formats = DepthFormat::ALL.map(Setting::DepthFormat);
                let ends = [false, true].map(Setting::Reversed);
                Setting::of_scan().into_iter().chain(formats).chain(ends).collect()
            }
            None => settings_of_depth(scene),
        }
    }

    fn choices(&self) -> Vec<Choice> {
        if self.triangles.is_none() {
            return Vec::new();
        }
        let tests = [
            ("\"less\"", "word-compare-less"),
            ("\"less-equal\"", "word-compare-less-equal"),
            ("\"equal\"", "word-compare-equal"),
            ("\"not-equal\"", "word-compare-not-equal"),
            ("\"greater-equal\"", "word-compare-greater-equal"),
            ("\"greater\"", "word-compare-greater"),
            ("\"always\"", "word-compare-always"),
            ("\"never\"", "word-compare-never"),
        ];
        let writes = [("true", "word-depth-written"), ("false", "word-depth-not-written")];
        let mut all = Choice::all("test", "compare-depth-compare", tests).to_vec();
        all.extend(Choice::all("write", "compare-depth-write", writes));
        all
    }
}

/// The depth test of all of the scene's triangles, which must agree on its state.
pub(super) fn play_depth_of(scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
    let mut states = scene.draws.iter().map(|draw| draw.depth);
    let state = states.next().unwrap_or_default();
    if states.any(|other| other != state) {
        return Err(Message::new("error-mixed-depth-states"));
    }
    let triangles = screen_triangles(scene);
    let names = screen_names(scene, &triangles)
        .zip(&triangles)
        .map(|(text, piece)| z_buffer::Name { text, object: piece.draw as usize })
        .collect();
    let triangles = triangles.iter().map(|triangle| triangle.vertices).collect();
    Ok(Box::new(z_buffer::play(triangles, names, depth_settings(scene, state), budget)))
}

/// What the depth test of all of the scene's triangles reads.
pub(super) fn settings_of_depth(scene: &Scene) -> Vec<Setting> {
    let parts =
        [Setting::of_scan(), Setting::of_depth(scene), Setting::of_transform(), Setting::of_facing(scene)];
    parts.concat()
}

/// The scene's conventions of the depth test.
fn depth_settings(scene: &Scene, state: DepthState) -> z_buffer::Settings {
    z_buffer::Settings {
        algorithm: raster::Algorithm::Scanline,
        raster: scan_settings(scene),
        format: scene.depth_format,
        clear: scene.clear.depth,
        state,
    }
}
