//! The lab that shades the scene, through the vertex and the fragment stage.

use super::{Family, refuse_large};
use crate::{
    compare::{Choice, Setting},
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Scene, Shade},
    shade::{
        Mistake, Model,
        shading::{self, Subject},
    },
};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// How all of the scene's draws are shaded. Their materials are their own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Shading {
    /// Where light is computed.
    pub shading: ShadeMode,
    /// What highlights are made of; left out: as each material says.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<Model>,
    /// A mistake made on purpose, by all materials.
    pub mistake: Mistake,
}

/// Where light is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ShadeMode {
    /// At each pixel.
    #[default]
    Phong,
    /// At the vertices.
    Gouraud,
    /// Once for each face.
    Flat,
    /// As each draw says.
    Scene,
}

impl ShadeMode {
    /// All of them, the default first.
    pub const ALL: [Self; 4] = [Self::Phong, Self::Gouraud, Self::Flat, Self::Scene];

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::Phong => "word-shade-phong",
            Self::Gouraud => "word-shade-gouraud",
            Self::Flat => "word-shade-flat",
            Self::Scene => "word-shade-scene",
        }
    }
}

impl Shading {
    /// The scene as it is shaded here.
    pub fn apply(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        for draw in &mut scene.draws {
            match self.shading {
                ShadeMode::Phong => draw.shade = Shade::Phong,
                ShadeMode::Gouraud => draw.shade = Shade::Gouraud,
                ShadeMode::Flat => draw.shade = Shade::Flat,
                ShadeMode::Scene => {}
            }
            if let Some(model) = self.model {
                draw.material.model = model;
            }
            if self.mistake != Mistake::None {
                draw.material.mistake = self.mistake;
            }
        }
        scene
    }
}

impl Family for Shading {
    fn first() -> Self {
        Self::default()
    }

    fn name(&self) -> &'static str {
        "shading"
    }

    fn is_of_scene(&self) -> bool {
        true
    }

    fn check(&self, _: &Scene) -> Checked {
        Ok(())
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        refuse_large(scene)?;
        Ok(Box::new(shading::play(Arc::new(Subject::new(&self.apply(scene))), budget)))
    }

    fn settings(&self, scene: &Scene) -> Vec<Setting> {
        [Setting::of_transform(), Setting::of_facing(scene)].concat()
    }

    fn choices(&self) -> Vec<Choice> {
        let modes = [
            ("\"phong\"", "word-shade-phong"),
            ("\"gouraud\"", "word-shade-gouraud"),
            ("\"flat\"", "word-shade-flat"),
            ("\"scene\"", "word-shade-scene"),
        ];
        let models = [
            ("null", "word-model-of-draw"),
            ("\"phong\"", "word-model-phong"),
            ("\"blinn-phong\"", "word-model-blinn-phong"),
        ];
        let mistakes = [
            ("\"none\"", "mistake-none"),
            ("\"model-normals\"", "mistake-model-normals"),
            ("\"not-renormalised\"", "mistake-not-renormalised"),
        ];
        let mut all = Choice::all("shading", "compare-shading", modes).to_vec();
        all.extend(Choice::all("model", "compare-model", models));
        all.extend(Choice::all("mistake", "compare-mistake", mistakes));
        all
    }
}
