//! A triangle against the planes of the frustum: drag its vertices in space, choose where it is clipped.

use super::{Handle, Lab, Outcome, SolidHandle, count, placing, transform::depth_range};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    clip::polygon::{
        PlaneSet,
        clip_triangle::{Mistake, Pieces, Space},
    },
    explain::{Marker, Role},
    labs::{self, LabInput},
    math::Arithmetic,
};

/// The lab.
#[derive(Debug)]
pub(crate) struct ClipTriangle;

impl Lab for ClipTriangle {
    fn name(&self) -> &'static str {
        "clip-triangle"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        let LabInput::ClipTriangle(mut input) = *document.input() else { return };
        heading(ui, face, &face.say("ui-conventions"));
        let spaces =
            [(Space::Clip, face.say("word-space-clip")), (Space::Camera, face.say("word-space-camera"))];
        choices::choose(ui, face, "ui-space", &mut input.space, &spaces);
        depth_range(ui, face, document);
        planes(ui, face, &mut input.planes);
        let pieces = [
            (Pieces::Polygon, face.say("word-pieces-polygon")),
            (Pieces::Triangles, face.say("word-pieces-triangles")),
        ];
        choices::choose(ui, face, "ui-pieces", &mut input.pieces, &pieces);
        let all =
            [Arithmetic::Exact, Arithmetic::F64, Arithmetic::F32].map(|each| (each, face.say(each.word())));
        choices::choose(ui, face, "ui-arithmetic", &mut input.arithmetic, &all);
        choices::snapping(ui, face, view);
        heading(ui, face, &face.say("ui-mistakes"));
        for (mistake, name) in [
            (Mistake::DivideFirst, "mistake-divide-first"),
            (Mistake::NoNearPlane, "mistake-no-near-plane"),
            (Mistake::NoAttributes, "mistake-no-attributes"),
            (Mistake::WalkOrder, "mistake-walk-order"),
        ] {
            let mut on = input.mistake == mistake;
            choices::check(ui, face, name, &mut on);
            match (on, input.mistake == mistake) {
                (true, false) => input.mistake = mistake,
                (false, true) => input.mistake = Mistake::None,
                _ => {}
            }
        }
        heading(ui, face, &face.say("ui-vertices-camera"));
        let mut corners = input.corners(&document.scene);
        let before = corners;
        for (i, [x, y, z]) in corners.iter_mut().enumerate() {
            choices::fields(ui, face, &format!("v{i}"), [x, y, z]);
        }
        if corners != before {
            input.vertices = Some(corners);
        }
        let [u0, u1, u2] = &mut input.attribute;
        choices::fields(ui, face, "u", [u0, u1, u2]);
        if document.input() != &LabInput::ClipTriangle(input) {
            *document.input_mut() = LabInput::ClipTriangle(input);
        }
        placing::camera(ui, face, &mut document.scene);
    }

    fn handles(&self, _: &Document) -> Vec<Handle> {
        Vec::new()
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let named = |marker: &&(usize, Marker)| marker.1.label == Some("word-accept");
        Some(Outcome {
            came: Some(1),
            went: markers.iter().filter(named).count().min(count(markers, Role::Accepted)),
            unit: None,
            given: (1, "pipeline-unit-triangles"),
        })
    }

    fn drag(&self, _: &mut Document, _: usize, _: [f32; 2]) {}

    fn solid_handles(&self, document: &Document) -> Vec<SolidHandle> {
        let LabInput::ClipTriangle(input) = document.input() else { return Vec::new() };
        // After a division the picture is of another space.
        if input.mistake == Mistake::DivideFirst {
            return Vec::new();
        }
        let corners = input.corners(&document.scene).into_iter().enumerate();
        corners.map(|(i, at)| SolidHandle { name: format!("v{i}"), at }).collect()
    }

    fn drag_solid(&self, document: &mut Document, handle: usize, to: [f32; 3]) {
        let LabInput::ClipTriangle(input) = document.input() else { return };
        let mut corners = input.corners(&document.scene);
        corners[handle] = to;
        let input = labs::ClipTriangle { vertices: Some(corners), ..*input };
        *document.input_mut() = LabInput::ClipTriangle(input);
    }
}

/// Which planes clip; a guard band has a factor.
fn planes(ui: &mut Ui, face: &Face<'_>, planes: &mut PlaneSet) {
    let kept = match *planes {
        PlaneSet::Guard(power) => PlaneSet::Guard(power),
        PlaneSet::All | PlaneSet::Near => PlaneSet::Guard(2),
    };
    let all = [
        (PlaneSet::All, face.say("word-planes-all")),
        (PlaneSet::Near, face.say("word-planes-near")),
        (kept, face.say("word-planes-guard")),
    ];
    choices::choose(ui, face, "ui-planes", planes, &all);
    if let PlaneSet::Guard(power) = planes {
        let factors = [1, 2, 3, 4, 8, 16].map(|power| (power, PlaneSet::Guard(power).guard().to_string()));
        choices::choose(ui, face, "ui-guard", power, &factors);
    }
}
