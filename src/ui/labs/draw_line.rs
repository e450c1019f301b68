//! What the labs that draw a line share: all but the algorithm.

use super::{Handle, Kind, Lab, Outcome, count_plain};
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
    raster::line::{Algorithm, FARTHEST},
};

/// The lab of one algorithm: the ends of a line are dragged.
#[derive(Debug)]
pub(crate) struct DrawLine(pub(crate) Algorithm);

impl Lab for DrawLine {
    fn name(&self) -> &'static str {
        self.0.name()
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        let LabInput::DrawLine(labs::DrawLine { segment, arithmetic, .. }) = document.input_mut() else {
            return;
        };
        heading(ui, face, &face.say("ui-conventions"));
        let arithmetics: Vec<_> =
            self.0.arithmetics().iter().map(|&each| (each, face.say(each.word()))).collect();
        if arithmetics.len() > 1 {
            choices::choose(ui, face, "ui-arithmetic", arithmetic, &arithmetics);
        }
        choices::snapping(ui, face, view);
        heading(ui, face, &face.say("ui-ends-pixels"));
        let [x1, y1, x2, y2] = segment;
        choices::fields(ui, face, "P1", [x1, y1]);
        choices::fields(ui, face, "P2", [x2, y2]);
        keep_near(segment);
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let LabInput::DrawLine(input) = document.input() else { return Vec::new() };
        let [x1, y1, x2, y2] = input.segment;
        let end = |name: &str, at| Handle { name: name.to_owned(), at, kind: Kind::Point };
        vec![end("P1", [x1, y1]), end("P2", [x2, y2])]
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        Some(Outcome {
            came: None,
            went: count_plain(markers),
            unit: Some("ui-unit-pixels"),
            given: (1, "ui-unit-line"),
        })
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        let LabInput::DrawLine(labs::DrawLine { segment, .. }) = document.input_mut() else { return };
        segment[2 * handle..2 * handle + 2].copy_from_slice(&to);
        keep_near(segment);
    }
}

/// Ends farther away are for a clipper.
fn keep_near(segment: &mut [f32; 4]) {
    let farthest = FARTHEST as f32;
    segment.iter_mut().for_each(|coordinate| *coordinate = coordinate.clamp(-farthest, farthest));
}
