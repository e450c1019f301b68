//! Cyrus-Beck: drag the ends of a line and the corners of a convex window.

use super::{
    Handle, Kind, Lab, Outcome,
    clip_line::{conventions, kept},
};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    theme::Text,
    widgets::heading,
};
use egui::{Button, Ui};
use rasterscope_core::{
    clip::line::{ConvexWindow, Point},
    explain::Marker,
    labs::{self, LabInput},
};

/// The lab.
#[derive(Debug)]
pub(crate) struct CyrusBeck;

fn input(document: &Document) -> Option<&labs::ClipConvex> {
    match document.input() {
        LabInput::ClipConvex(input) => Some(input),
        _ => None,
    }
}

/// Takes the corners if they are a window; a corner that would bend inward stays where it was.
fn set_corners(document: &mut Document, corners: Vec<Point>) {
    if let (LabInput::ClipConvex(input), Ok(_)) = (document.input_mut(), ConvexWindow::new(&corners)) {
        input.polygon = corners;
    }
}

impl Lab for CyrusBeck {
    fn name(&self) -> &'static str {
        "cyrus-beck"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        let LabInput::ClipConvex(input) = document.input_mut() else { return };
        conventions(ui, face, &mut input.arithmetic, view);
        heading(ui, face, &face.say("ui-ends-and-corners"));
        let [x1, y1, x2, y2] = &mut input.segment;
        choices::fields(ui, face, "P1", [x1, y1]);
        choices::fields(ui, face, "P2", [x2, y2]);
        let mut corners = input.polygon.clone();
        for (i, [x, y]) in corners.iter_mut().enumerate() {
            choices::fields(ui, face, &format!("C{}", i + 1), [x, y]);
        }
        ui.horizontal_wrapped(|ui| {
            let room = corners.len() < ConvexWindow::MOST_CORNERS;
            if ui.add_enabled(room, Button::new(face.say("ui-add-corner"))).clicked() {
                // Between the last and the first, on their edge: so it bends nothing inward.
                let (a, b) = (corners[0], corners[corners.len() - 1]);
                corners.push([0, 1].map(|axis| a[axis] / 2.0 + b[axis] / 2.0));
            }
            let spare = corners.len() > 3;
            if ui.add_enabled(spare, Button::new(face.say("ui-remove-corner"))).clicked() {
                corners.pop();
            }
        });
        ui.label(face.dim(face.say("ui-stays-convex"), Text::Label));
        set_corners(document, corners);
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let Some(labs::ClipConvex { polygon, segment: [x1, y1, x2, y2], .. }) = input(document) else {
            return Vec::new();
        };
        let corner =
            |(i, at): (usize, &Point)| Handle { name: format!("C{}", i + 1), at: *at, kind: Kind::Corner };
        let end = |name: &str, at| Handle { name: name.to_owned(), at, kind: Kind::Point };
        let ends = [end("P1", [*x1, *y1]), end("P2", [*x2, *y2])];
        // The ends last: where a corner lies on an end, the end is on top.
        polygon.iter().enumerate().map(corner).chain(ends).collect()
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        Some(kept(markers, "ui-unit-line"))
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        let Some(labs::ClipConvex { polygon, .. }) = input(document) else { return };
        let mut corners = polygon.clone();
        if let Some(corner) = corners.get_mut(handle) {
            *corner = to;
            set_corners(document, corners);
        } else if let LabInput::ClipConvex(input) = document.input_mut() {
            let end = 2 * (handle - corners.len());
            input.segment[end..end + 2].copy_from_slice(&to);
        }
    }
}
