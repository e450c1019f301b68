//! Homogeneous edges: drag the corners of a triangle that may reach behind the eye.

use super::{
    Handle, Kind, Lab, Outcome,
    fill_triangle::{fill_rule, is_small, mistakes, rows},
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
    math::Arithmetic,
    raster::Mistake,
};

/// The lab.
#[derive(Debug)]
pub(crate) struct Homogeneous;

impl Lab for Homogeneous {
    fn name(&self) -> &'static str {
        "homogeneous"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        heading(ui, face, &face.say("ui-conventions"));
        fill_rule(ui, face, document);
        let LabInput::Homogeneous(mut input) = document.input().clone() else { return };
        let all =
            [Arithmetic::Exact, Arithmetic::F64, Arithmetic::F32].map(|each| (each, face.say(each.word())));
        choices::choose(ui, face, "ui-arithmetic", &mut input.arithmetic, &all);
        choices::snapping(ui, face, view);
        near(ui, face, &mut input, document);
        if input.vertices.is_none() {
            heading(ui, face, &face.say("ui-triangle-of-scene"));
            choices::index(ui, face, "ui-triangle", &mut input.triangle);
        }
        if let Some(mut corners) = corners(document) {
            let before = corners;
            heading(ui, face, &face.say("ui-vertices-homogeneous"));
            for (i, [x, y, w]) in corners.iter_mut().enumerate() {
                choices::fields(ui, face, &format!("V{i}"), [x, y, w]);
            }
            if corners != before {
                input.vertices = Some(corners);
            }
        }
        mistakes(ui, face, &Mistake::OF_HOMOGENEOUS, &mut input.mistake);
        if document.input() != &LabInput::Homogeneous(input.clone()) {
            *document.input_mut() = input.into();
        }
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let corners = corners(document).into_iter().flatten().enumerate();
        let handle = |(i, [x, y, w]): (usize, [f32; 3])| {
            let at = [x / w, y / w];
            let seen = at.iter().all(|value| value.is_finite());
            seen.then(|| Handle { name: format!("V{i}"), at, kind: Kind::Point })
        };
        // A corner without an image has no handle; the others keep their places in the list.
        let handles: Option<Vec<Handle>> = corners.map(handle).collect();
        handles.unwrap_or_default()
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        Some(rows(markers))
    }

    fn drag(&self, document: &mut Document, handle: usize, [x, y]: [f32; 2]) {
        let Some(mut corners) = corners(document) else { return };
        let LabInput::Homogeneous(input) = document.input_mut() else { return };
        let [_, _, w] = corners[handle];
        corners[handle] = [x * w, y * w, w];
        input.vertices = Some(corners);
    }
}

/// The lab's own triangle, or the one of the scene that it shows.
fn corners(document: &Document) -> Option<[[f32; 3]; 3]> {
    let LabInput::Homogeneous(input) = document.input() else { return None };
    if input.vertices.is_none() && !is_small(&document.scene) {
        return None;
    }
    input.corners(&document.scene)
}

/// The near plane: whether there is one, and where.
fn near(ui: &mut Ui, face: &Face<'_>, input: &mut labs::Homogeneous, document: &Document) {
    let of_scene = input.vertices.is_none();
    let mut there = input.near(&document.scene).is_some();
    if !of_scene {
        choices::check(ui, face, "ui-near-plane", &mut there);
        input.near = if there { input.near.or(Some(1.0)) } else { None };
    }
    if let Some(mut near) = input.near(&document.scene) {
        let (before, text) = (near, face.say("ui-near"));
        choices::labelled(ui, face, &text, |ui, width| choices::number(ui, face, width, &text, &mut near));
        if near != before && near > 0.0 {
            input.near = Some(near);
        }
    }
}
