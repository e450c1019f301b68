//! The lab that tests the depth of every fragment.

use super::{Family, scan_settings};
use crate::{
    blend::AlphaTest,
    compare::{Choice, Setting},
    depth::{CompareFunction, Cutout, DepthBias, DepthFormat, DepthPlacement, DepthState, Rules, z_buffer},
    message::Message,
    pipeline::{screen_names, screen_triangles},
    raster::{self, Scissor},
    replay::{Budget, Playback},
    scene::{Checked, FieldError, Scene, check_bias, check_cut, each_in_unit, each_row_finite},
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
    /// More state of its own triangles, in their order; those beyond the last have none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub states: Vec<TriangleState>,
    /// Whether the biases of those states count: off, to be compared with.
    #[serde(default = "yes", skip_serializing_if = "Clone::clone")]
    pub bias: bool,
    /// Whether the depth test comes before the alpha test where it may.
    #[serde(default = "yes", skip_serializing_if = "Clone::clone")]
    pub early_z: bool,
}

/// What one of the lab's own triangles has beyond the depth test.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct TriangleState {
    /// What is added to its depths.
    pub bias: DepthBias,
    /// Whether depths outside 0..=1 are kept at the ends of that range.
    pub unclipped: bool,
    /// The pixels that it may draw to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scissor: Option<Scissor>,
    /// Which fragments are kept.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alpha_test: Option<AlphaTest>,
    /// Alpha at its vertices, in 0..=1; opaque if it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alpha: Option<[f32; 3]>,
}

impl TriangleState {
    fn rules(&self) -> Rules {
        let Self { bias, unclipped, scissor, alpha_test, alpha } = *self;
        let cutout = alpha_test.map(|test| Cutout { test, alpha: alpha.unwrap_or([1.0; 3]), r: [1.0; 3] });
        Rules { placement: DepthPlacement { bias, unclipped }, scissor, cutout }
    }
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
        let settings = z_buffer::Settings { early_z: self.early_z, ..depth_settings(scene, state) };
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
        Self {
            triangles: None,
            test: CompareFunction::default(),
            write: true,
            states: Vec::new(),
            bias: true,
            early_z: true,
        }
    }

    fn name(&self) -> &'static str {
        "z-buffer"
    }

    fn is_of_scene(&self) -> bool {
        self.triangles.is_none()
    }

    fn check(&self, _: &Scene) -> Checked {
        for (i, triangle) in self.triangles.iter().flatten().enumerate() {
            each_row_finite(i, triangle).map_err(|e| e.within("triangles"))?;
        }
        for (i, state) in self.states.iter().enumerate() {
            let within = |e: FieldError| e.within(i).within("states");
            check_bias(state.bias).map_err(|e| within(e.within("bias")))?;
            check_cut(state.scissor, state.alpha_test).map_err(within)?;
            let alpha = state.alpha.unwrap_or_default();
            each_in_unit(&alpha).map_err(|e| within(e.within("alpha")))?;
        }
        Ok(())
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        match &self.triangles {
            Some(triangles) => {
                let (triangles, settings) = self.own(triangles, scene);
                let mut rules: Vec<_> = self.states.iter().map(TriangleState::rules).collect();
                if !self.bias {
                    rules.iter_mut().for_each(|rules| rules.placement.bias = DepthBias::default());
                }
                Ok(Box::new(z_buffer::play_ruled(triangles, rules, Vec::new(), settings, budget)))
            }
            None => play_depth_of(scene, self.early_z, budget),
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
        // Only where they make a difference.
        if self.states.iter().any(|state| !state.bias.is_none()) {
            let biases = [("true", "word-biased"), ("false", "word-not-biased")];
            all.extend(Choice::all("bias", "compare-bias", biases));
        }
        if self.states.iter().any(|state| state.alpha_test.is_some()) {
            let early = [("true", "word-early-z"), ("false", "word-late-z")];
            all.extend(Choice::all("early_z", "compare-early-z", early));
        }
        all
    }
}

/// The depth test of all of the scene's triangles, which must agree on its state.
pub(super) fn play_depth_of(
    scene: &Scene,
    early_z: bool,
    budget: Budget,
) -> Result<Box<dyn Playback>, Message> {
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
    let rules = triangles.iter().map(|triangle| triangle.rules(scene)).collect();
    let triangles = triangles.iter().map(|triangle| triangle.vertices).collect();
    let settings = z_buffer::Settings { early_z, ..depth_settings(scene, state) };
    Ok(Box::new(z_buffer::play_ruled(triangles, rules, names, settings, budget)))
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
        early_z: true,
    }
}
