//! What the labs that fill one triangle share: all but the algorithm.

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
    math::Arithmetic,
    pipeline::screen_triangles,
    raster::{Algorithm, FillRule, Mistake, traversal::Show},
    scene::{Draw, Scene},
};

/// Larger scenes have no handles.
const MOST_TRIANGLES: usize = 64;

/// The lab of one algorithm: the corners of a triangle are dragged over the pixels it fills.
#[derive(Debug)]
pub(crate) struct FillTriangle(pub(crate) Algorithm);

impl Lab for FillTriangle {
    fn name(&self) -> &'static str {
        self.0.name()
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        heading(ui, face, &face.say("ui-conventions"));
        fill_rule(ui, face, document);
        if let LabInput::FillTriangle(input) = document.input_mut() {
            arithmetic(ui, face, &mut input.arithmetic);
        }
        choices::snapping(ui, face, view);
        if let LabInput::FillTriangle(input) = document.input_mut() {
            if self.0 != Algorithm::Scanline {
                let mut visits = input.show == Show::Visits;
                choices::check(ui, face, "ui-show-visits", &mut visits);
                input.show = if visits { Show::Visits } else { Show::Pixels };
            }
            mistakes(ui, face, labs::FillTriangle::mistakes(self.0), &mut input.mistake);
        }
        if let LabInput::FillTriangle(labs::FillTriangle { vertices: None, triangle, .. }) =
            document.input_mut()
        {
            heading(ui, face, &face.say("ui-triangle-of-scene"));
            choices::index(ui, face, "ui-triangle", triangle);
        }
        let Some(mut corners) = corners(document) else { return };
        let before = corners;
        heading(ui, face, &face.say("ui-vertices-pixels"));
        for (i, [x, y]) in corners.iter_mut().enumerate() {
            choices::fields(ui, face, &format!("V{i}"), [x, y]);
        }
        if corners != before {
            set_corners(document, corners);
        }
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let Some(corners) = corners(document) else { return Vec::new() };
        let corner =
            |(i, at): (usize, &[f32; 2])| Handle { name: format!("V{i}"), at: *at, kind: Kind::Point };
        corners.iter().enumerate().map(corner).collect()
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let unit = match self.0 {
            Algorithm::Scanline => "pipeline-unit-spans",
            Algorithm::Tiled => "pipeline-unit-tile-rows",
            _ => "pipeline-unit-rows",
        };
        Some(Outcome { unit: Some(unit), ..rows(markers) })
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        if let Some(mut corners) = corners(document) {
            corners[handle] = to;
            set_corners(document, corners);
        }
    }
}

/// How many rows or spans a run has come to.
pub(super) fn rows(markers: &[(usize, Marker)]) -> Outcome {
    Outcome {
        came: None,
        went: count_plain(markers),
        unit: Some("pipeline-unit-rows"),
        given: (1, "pipeline-unit-triangles"),
    }
}

/// The lab's own triangle, or the one of the scene that it shows.
fn corners(document: &Document) -> Option<[[f32; 2]; 3]> {
    let LabInput::FillTriangle(labs::FillTriangle { vertices, triangle, .. }) = document.input() else {
        return None;
    };
    vertices.or_else(|| {
        let of_scene = if is_small(&document.scene) { screen_triangles(&document.scene) } else { Vec::new() };
        of_scene.get(*triangle).map(|triangle| triangle.vertices.map(|[x, y, _]| [x, y]))
    })
}

/// From the first edit on the triangle is the lab's own.
fn set_corners(document: &mut Document, corners: [[f32; 2]; 3]) {
    if let LabInput::FillTriangle(input) = document.input_mut() {
        input.vertices = Some(corners);
    }
}

/// Whether a scene's triangles may be looked for in every frame.
pub(super) fn is_small(scene: &Scene) -> bool {
    let count = |draw: &Draw| draw.geometry.mesh().map_or(0, |mesh| mesh.triangles.len());
    scene.draws.iter().map(count).sum::<usize>() <= MOST_TRIANGLES
}

/// Who draws a pixel whose centre lies exactly on an edge.
pub(super) fn fill_rule(ui: &mut Ui, face: &Face<'_>, document: &mut Document) {
    let all = FillRule::ALL.map(|rule| (rule, face.say(rule.word())));
    choices::choose(ui, face, "ui-fill-rule", &mut document.scene.fill_rule, &all);
}

/// The mistakes that can be made: one at a time.
pub(super) fn mistakes(ui: &mut Ui, face: &Face<'_>, all: &[Mistake], made: &mut Option<Mistake>) {
    heading(ui, face, &face.say("ui-mistakes"));
    for &mistake in all {
        let mut this = *made == Some(mistake);
        choices::mistake(ui, face, mistake.words(), &mut this);
        if this {
            *made = Some(mistake);
        } else if *made == Some(mistake) {
            *made = None;
        }
    }
}

/// What edges are computed in.
pub(super) fn arithmetic(ui: &mut Ui, face: &Face<'_>, arithmetic: &mut Arithmetic) {
    let all = Arithmetic::ALL.map(|each| (each, face.say(each.word())));
    choices::choose(ui, face, "ui-arithmetic", arithmetic, &all);
}
