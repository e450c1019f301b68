//! A triangle against one plane: drag the vertices, the plane's point and the tip of its normal.

use super::{Handle, Lab, Outcome, SolidHandle};
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
};

/// The lab.
#[derive(Debug)]
pub(crate) struct ClipPlane;

impl Lab for ClipPlane {
    fn name(&self) -> &'static str {
        "clip-plane"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        let LabInput::ClipPlane(input) = document.input_mut() else { return };
        heading(ui, face, &face.say("ui-conventions"));
        let all =
            [Arithmetic::Exact, Arithmetic::F64, Arithmetic::F32].map(|each| (each, face.say(each.word())));
        choices::choose(ui, face, "ui-arithmetic", &mut input.arithmetic, &all);
        choices::snapping(ui, face, view);
        heading(ui, face, &face.say("ui-vertices-and-plane"));
        for (i, [x, y, z]) in input.vertices.iter_mut().enumerate() {
            choices::fields(ui, face, &format!("v{i}"), [x, y, z]);
        }
        for (name, [x, y, z]) in [("p", &mut input.point), ("n", &mut input.normal)] {
            choices::fields(ui, face, name, [x, y, z]);
        }
    }

    fn handles(&self, _: &Document) -> Vec<Handle> {
        Vec::new()
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let triangle = |marker: &&(usize, Marker)| marker.1.label == Some("clip-plane-marker-triangle");
        Some(Outcome {
            came: Some(1),
            went: markers.iter().filter(triangle).count(),
            unit: None,
            given: (1, "pipeline-unit-triangles"),
        })
    }

    fn drag(&self, _: &mut Document, _: usize, _: [f32; 2]) {}

    fn solid_handles(&self, document: &Document) -> Vec<SolidHandle> {
        let LabInput::ClipPlane(input) = document.input() else { return Vec::new() };
        let vertices = input.vertices.into_iter().zip(["v0", "v1", "v2"]);
        let plane = [(input.point, "p"), (tip(input), "n")];
        let all = vertices.chain(plane);
        all.map(|(at, name)| SolidHandle { name: name.to_owned(), at }).collect()
    }

    fn drag_solid(&self, document: &mut Document, handle: usize, to: [f32; 3]) {
        let LabInput::ClipPlane(input) = document.input_mut() else { return };
        match handle {
            0..3 => input.vertices[handle] = to,
            3 => input.point = to,
            _ => {
                let normal = [0, 1, 2].map(|axis| to[axis] - input.point[axis]);
                // A normal of length zero makes no plane.
                if normal.iter().any(|c| *c != 0.0) {
                    input.normal = normal;
                }
            }
        }
    }
}

/// Where the normal ends.
fn tip(input: &labs::ClipPlane) -> [f32; 3] {
    [0, 1, 2].map(|axis| input.point[axis] + input.normal[axis])
}
