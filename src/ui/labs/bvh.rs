//! The tree of boxes: how it is built, and what the frustum leaves of it.

use super::{Handle, Lab, Outcome, placing, transform::depth_range};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    cull::bvh::Split,
    explain::Marker,
    labs::{LabInput, Over},
};

/// The lab.
#[derive(Debug)]
pub(crate) struct Bvh;

impl Lab for Bvh {
    fn name(&self) -> &'static str {
        "bvh"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, _: &mut ViewState) {
        heading(ui, face, &face.say("ui-conventions"));
        if let LabInput::Bvh(input) = document.input_mut() {
            let all = Split::ALL.map(|split| (split, face.say(split.word())));
            choices::choose(ui, face, "bvh-split-rule", &mut input.split, &all);
            let all = Over::ALL.map(|over| (over, face.say(over.word())));
            choices::choose(ui, face, "bvh-over", &mut input.over, &all);
        }
        depth_range(ui, face, document);
        placing::camera(ui, face, &mut document.scene);
    }

    fn handles(&self, _: &Document) -> Vec<Handle> {
        Vec::new()
    }

    fn outcome(&self, _: &Document, _: &[(usize, Marker)]) -> Option<Outcome> {
        None // a mark of the timeline stands for many boxes
    }

    fn drag(&self, _: &mut Document, _: usize, _: [f32; 2]) {}
}
