//! The vertex and the fragment stage: where light is computed, and what the mistakes do to it.

use super::{Handle, Lab, Outcome, count, light, pipeline::Pipeline};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    explain::{Marker, Role},
    labs::{LabInput, ShadeMode},
    shade::{Mistake, Model},
};

/// The lab.
#[derive(Debug)]
pub(crate) struct Shading;

impl Lab for Shading {
    fn name(&self) -> &'static str {
        "shading"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        let LabInput::Shading(input) = document.input_mut() else { return };
        heading(ui, face, &face.say("ui-conventions"));
        let modes = ShadeMode::ALL.map(|mode| (mode, face.say(mode.word())));
        choices::choose(ui, face, "ui-shade-shade", &mut input.shading, &modes);
        let own = (None, face.say("word-model-of-draw"));
        let models = Model::ALL.map(|model| (Some(model), face.say(model.word())));
        let models: Vec<_> = std::iter::once(own).chain(models).collect();
        choices::choose(ui, face, "ui-shade-model-of-all", &mut input.model, &models);
        choices::snapping(ui, face, view);
        heading(ui, face, &face.say("ui-mistakes"));
        for (mistake, words) in [
            (Mistake::NotRenormalised, ["mistake-not-renormalised", "mistake-not-renormalised-effect"]),
            (Mistake::ModelNormals, ["mistake-model-normals", "mistake-model-normals-effect"]),
        ] {
            let mut on = input.mistake == mistake;
            choices::mistake(ui, face, words, &mut on);
            match (on, input.mistake == mistake) {
                (true, false) => input.mistake = mistake,
                (false, true) => input.mistake = Mistake::None,
                _ => {}
            }
        }
        light::show(ui, face, &mut document.scene);
        super::placing::camera(ui, face, &mut document.scene);
    }

    /// The vertices of the scene, as in the overview.
    fn handles(&self, document: &Document) -> Vec<Handle> {
        Pipeline.handles(document)
    }

    fn outcome(&self, document: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let triangles = document.scene.draws.iter().filter_map(|draw| draw.geometry.mesh());
        Some(Outcome {
            came: None,
            went: count(markers, Role::Accepted),
            unit: Some("pipeline-unit-fragments"),
            given: (triangles.map(|mesh| mesh.triangles.len()).sum(), "pipeline-unit-triangles"),
        })
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        Pipeline.drag(document, handle, to);
    }
}
