//! What the labs share that interpolate an attribute over one triangle.

use super::{Handle, Kind, Lab, Outcome, count};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    explain::{Marker, Role},
    interpolate::Mode,
    labs::{AreaRatios, Interpolation, LabInput, PlaneEquation},
    math::Arithmetic,
};

/// One of the labs: the vertices and the point are dragged.
#[derive(Debug)]
pub(crate) struct Interpolate(pub(crate) &'static str);

impl Lab for Interpolate {
    fn name(&self) -> &'static str {
        self.0
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        let Some(input) = input_mut(document) else { return };
        heading(ui, face, &face.say("ui-conventions"));
        mode(ui, face, &mut input.mode);
        let all = Arithmetic::ALL.map(|each| (each, face.say(each.word())));
        choices::choose(ui, face, "ui-arithmetic", &mut input.arithmetic, &all);
        choices::snapping(ui, face, view);
        heading(ui, face, &face.say("ui-vertices-w"));
        for (i, [x, y, w]) in input.vertices.iter_mut().enumerate() {
            choices::fields(ui, face, &format!("V{i}"), [x, y, w]);
        }
        let [a0, a1, a2] = &mut input.attribute;
        choices::fields(ui, face, "a", [a0, a1, a2]);
        let [x, y] = &mut input.at;
        choices::fields(ui, face, "P", [x, y]);
    }

    /// The vertices, then the point.
    fn handles(&self, document: &Document) -> Vec<Handle> {
        let Some(input) = input(document) else { return Vec::new() };
        let vertices =
            input.vertices.iter().zip(["V0", "V1", "V2"]).map(|([x, y, _], name)| ([*x, *y], name));
        let all = vertices.chain([(input.at, "P")]);
        all.map(|(at, name)| Handle { name: name.to_owned(), at, kind: Kind::Point }).collect()
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        Some(Outcome {
            came: None,
            went: count(markers, Role::Accepted),
            unit: Some("pipeline-unit-values"),
            given: (1, "pipeline-unit-triangles"),
        })
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        let Some(input) = input_mut(document) else { return };
        match input.vertices.get_mut(handle) {
            Some([x, y, _]) => [*x, *y] = to,
            None => input.at = to,
        }
    }
}

/// The input of either lab.
fn input(document: &Document) -> Option<&Interpolation> {
    match document.input() {
        LabInput::AreaRatios(AreaRatios(input)) | LabInput::PlaneEquation(PlaneEquation(input)) => {
            Some(input)
        }
        _ => None,
    }
}

/// The same, to be edited.
fn input_mut(document: &mut Document) -> Option<&mut Interpolation> {
    match document.input_mut() {
        LabInput::AreaRatios(AreaRatios(input)) | LabInput::PlaneEquation(PlaneEquation(input)) => {
            Some(input)
        }
        _ => None,
    }
}

/// Along which line values change evenly.
pub(super) fn mode(ui: &mut Ui, face: &Face<'_>, mode: &mut Mode) {
    let all = [(Mode::Perspective, face.say("word-perspective")), (Mode::Affine, face.say("word-affine"))];
    choices::choose(ui, face, "ui-mode", mode, &all);
}
