//! Frustum culling: whole objects, each by a sphere or a box.

use super::{Handle, Lab, Outcome, count, objects, placing, transform::depth_range};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    cull::object_frustum::Body,
    explain::{Marker, Role},
    labs::LabInput,
};

/// The lab.
#[derive(Debug)]
pub(crate) struct FrustumCulling;

impl Lab for FrustumCulling {
    fn name(&self) -> &'static str {
        "frustum-culling"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, _: &mut ViewState) {
        heading(ui, face, &face.say("ui-conventions"));
        if let LabInput::FrustumCulling(input) = document.input_mut() {
            let all = Body::ALL.map(|body| (body, face.say(body.word())));
            choices::choose(ui, face, "frustum-culling-body", &mut input.body, &all);
        }
        depth_range(ui, face, document);
        placing::camera(ui, face, &mut document.scene);
        objects::show(ui, face, &mut document.scene);
    }

    fn handles(&self, _: &Document) -> Vec<Handle> {
        Vec::new()
    }

    fn outcome(&self, document: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let unit = "ui-unit-objects";
        let culled = count(markers, Role::Rejected);
        let came = document.scene.draws.len();
        Some(Outcome {
            came: Some(came),
            went: came - culled.min(came),
            unit: Some(unit),
            given: (came, unit),
        })
    }

    fn drag(&self, _: &mut Document, _: usize, _: [f32; 2]) {}
}
