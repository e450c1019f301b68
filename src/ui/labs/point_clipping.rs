//! Clipping a point: drag it through the nine regions.

use super::{
    Handle, Kind, Lab, Outcome,
    clip_line::{conventions, kept},
    window as clip_window,
};
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
pub(crate) struct PointClipping;

impl Lab for PointClipping {
    fn name(&self) -> &'static str {
        "point-clipping"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        let LabInput::ClipPoint(labs::ClipPoint { window, point: [x, y], arithmetic }) = document.input_mut()
        else {
            return;
        };
        conventions(ui, face, arithmetic, view);
        heading(ui, face, &face.say("ui-point-and-window"));
        choices::fields(ui, face, "P", [x, y]);
        clip_window::fields(ui, face, window);
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let LabInput::ClipPoint(labs::ClipPoint { window, point, .. }) = document.input() else {
            return Vec::new();
        };
        let point = Handle { name: "P".to_owned(), at: *point, kind: Kind::Point };
        // The point last: where a handle of the window lies on it, the point is on top.
        clip_window::handles(window).into_iter().chain([point]).collect()
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        Some(kept(markers, "ui-unit-point"))
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        let LabInput::ClipPoint(labs::ClipPoint { window, point, .. }) = document.input_mut() else { return };
        if clip_window::drag(window, handle, to).is_some() {
            *point = to;
        }
    }
}
