//! The edge table: drag the corners of a polygon over the pixels that it fills.

use super::{Handle, Lab, Outcome, corners, count_plain};
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
    math::Arithmetic,
    raster::edge_table::WindingRule,
};

/// The lab.
#[derive(Debug)]
pub(crate) struct EdgeTable;

impl Lab for EdgeTable {
    fn name(&self) -> &'static str {
        "edge-table"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        let LabInput::FillPolygon(labs::FillPolygon { contours, winding, arithmetic }) = document.input_mut()
        else {
            return;
        };
        heading(ui, face, &face.say("ui-conventions"));
        let rules = WindingRule::ALL.map(|rule| (rule, face.say(rule.word())));
        choices::choose(ui, face, "ui-winding", winding, &rules);
        let all = Arithmetic::ALL.map(|each| (each, face.say(each.word())));
        choices::choose(ui, face, "ui-arithmetic", arithmetic, &all);
        choices::snapping(ui, face, view);
        heading(ui, face, &face.say("ui-corners"));
        corners::fields(ui, face, contours.iter_mut());
        if let Some(first) = contours.first_mut() {
            corners::buttons(ui, face, first);
        }
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let LabInput::FillPolygon(input) = document.input() else { return Vec::new() };
        corners::handles(input.contours.iter().cloned())
    }

    fn outcome(&self, document: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let LabInput::FillPolygon(_) = document.input() else { return None };
        Some(Outcome {
            came: None,
            went: count_plain(markers),
            unit: Some("pipeline-unit-spans"),
            given: (1, "ui-unit-polygon"),
        })
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        let LabInput::FillPolygon(input) = document.input_mut() else { return };
        corners::drag(input.contours.iter_mut(), handle, to);
    }
}
