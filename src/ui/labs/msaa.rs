//! Multisampling: drag the triangles over the samples, choose how many there are and where is shaded.

use super::{Handle, Kind, Lab, Outcome, count, scanline::fill_rule};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    explain::{Marker, Role, letter},
    labs::LabInput,
    raster::{Samples, msaa::Shading},
};

/// The lab.
#[derive(Debug)]
pub(crate) struct Msaa;

impl Lab for Msaa {
    fn name(&self) -> &'static str {
        "msaa"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        heading(ui, face, &face.say("ui-conventions"));
        if let LabInput::Msaa(input) = document.input_mut() {
            let counts = Samples::ALL.map(|samples| (samples, samples.count().to_string()));
            choices::choose(ui, face, "ui-samples", &mut input.samples, &counts);
            let shadings = Shading::ALL.map(|shading| (shading, face.say(shading.word())));
            choices::choose(ui, face, "ui-shading", &mut input.shading, &shadings);
        }
        fill_rule(ui, face, document);
        choices::snapping(ui, face, view);
        let LabInput::Msaa(input) = document.input_mut() else { return };
        heading(ui, face, &face.say("ui-vertices-shade"));
        for (i, triangle) in input.triangles.iter_mut().enumerate() {
            for (corner, [x, y, shade]) in triangle.iter_mut().enumerate() {
                choices::fields(ui, face, &name(i, corner), [x, y, shade]);
            }
        }
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let LabInput::Msaa(input) = document.input() else { return Vec::new() };
        let corners = input.triangles.iter().enumerate().flat_map(|(i, triangle)| {
            triangle.iter().enumerate().map(move |(corner, [x, y, _])| (name(i, corner), [*x, *y]))
        });
        corners.map(|(name, at)| Handle { name, at, kind: Kind::Point }).collect()
    }

    fn outcome(&self, document: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let LabInput::Msaa(input) = document.input() else { return None };
        Some(Outcome {
            came: None,
            went: count(markers, Role::Accepted),
            unit: Some("pipeline-unit-shades"),
            given: (input.triangles.len(), "pipeline-unit-triangles"),
        })
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        let LabInput::Msaa(input) = document.input_mut() else { return };
        if let Some(triangle) = input.triangles.get_mut(handle / 3) {
            let [x, y, _] = &mut triangle[handle % 3];
            [*x, *y] = to;
        }
    }
}

/// The corner of a triangle: `A0`, `A1`, `A2`, `B0`, ...
fn name(triangle: usize, corner: usize) -> String {
    format!("{}{corner}", letter(triangle))
}
