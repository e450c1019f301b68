//! Points: drag one over the pixels that its square covers.

use super::{Handle, Kind, Lab, Outcome, clip_line::conventions, count_plain};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    explain::Marker,
    labs::{self, LabInput},
};

/// The lab.
#[derive(Debug)]
pub(crate) struct Points;

impl Lab for Points {
    fn name(&self) -> &'static str {
        "points"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        let LabInput::DrawPoint(labs::DrawPoint { point: [x, y], size, arithmetic }) = document.input_mut()
        else {
            return;
        };
        conventions(ui, face, arithmetic, view);
        heading(ui, face, &face.say("ui-point-pixels"));
        choices::fields(ui, face, "P", [x, y]);
        let name = face.say("ui-point-size");
        choices::labelled(ui, face, &name, |ui, width| choices::number(ui, face, width, &name, size));
        *size = size.max(0.0);
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let LabInput::DrawPoint(input) = document.input() else { return Vec::new() };
        vec![Handle { name: "P".to_owned(), at: input.point, kind: Kind::Point }]
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        Some(Outcome {
            came: None,
            went: count_plain(markers),
            unit: Some("pipeline-unit-spans"),
            given: (1, "ui-unit-point"),
        })
    }

    fn drag(&self, document: &mut Document, _: usize, to: [f32; 2]) {
        if let LabInput::DrawPoint(input) = document.input_mut() {
            input.point = to;
        }
    }
}
