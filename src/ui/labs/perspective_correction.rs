//! Perspective correction: tilt the checkered square, drag the line along which the curves are drawn.

use super::{Handle, Kind, Lab, Outcome, count, interpolation};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    explain::{Marker, Role},
    labs::LabInput,
};

/// The lab.
#[derive(Debug)]
pub(crate) struct PerspectiveCorrection;

impl Lab for PerspectiveCorrection {
    fn name(&self) -> &'static str {
        "perspective-correction"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        let line = line(document);
        let LabInput::PerspectiveCorrection(input) = document.input_mut() else { return };
        heading(ui, face, &face.say("ui-conventions"));
        interpolation::mode(ui, face, &mut input.mode);
        let mut squares = input.squares as usize;
        choices::index(ui, face, "ui-squares", &mut squares);
        input.squares = squares.clamp(1, 64) as u32;
        choices::snapping(ui, face, view);
        heading(ui, face, &face.say("ui-corners-camera"));
        for (name, [x, y, z]) in ["00", "10", "01"].into_iter().zip(&mut input.corners) {
            choices::fields(ui, face, name, [x, y, z]);
        }
        let Some(mut ends) = line else { return };
        heading(ui, face, &face.say("ui-line-pixels"));
        for (name, [x, y]) in ["L0", "L1"].into_iter().zip(&mut ends) {
            choices::fields(ui, face, name, [x, y]);
        }
        if Some(ends) != line {
            input.line = Some(ends);
        }
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let ends = line(document).into_iter().flatten().zip(["L0", "L1"]);
        ends.map(|(at, name)| Handle { name: name.to_owned(), at, kind: Kind::Point }).collect()
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        Some(Outcome {
            came: None,
            went: count(markers, Role::Accepted),
            unit: Some("pipeline-unit-pixels"),
            given: (2, "pipeline-unit-triangles"),
        })
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        let Some(mut ends) = line(document) else { return };
        ends[handle] = to;
        if let LabInput::PerspectiveCorrection(input) = document.input_mut() {
            input.line = Some(ends);
        }
    }
}

/// Both ends of the line, chosen or not; none if the square reaches behind the eye.
fn line(document: &Document) -> Option<[[f32; 2]; 2]> {
    let LabInput::PerspectiveCorrection(input) = document.input() else { return None };
    Some(input.subject(&document.scene)?.line)
}
