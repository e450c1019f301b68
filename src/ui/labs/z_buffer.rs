//! The z-buffer: drag triangles over each other and change their depths.

use super::{
    Handle, Kind, Lab, Outcome, count,
    scanline::{fill_rule, is_small},
};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    depth::{CompareFunction, DepthFormat},
    explain::{Marker, Role},
    labs::{self, LabInput},
    pipeline::screen_triangles,
};

/// The lab.
#[derive(Debug)]
pub(crate) struct ZBuffer;

impl Lab for ZBuffer {
    fn name(&self) -> &'static str {
        "z-buffer"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        heading(ui, face, &face.say("ui-conventions"));
        depth_format(ui, face, document);
        test(ui, face, document);
        fill_rule(ui, face, document);
        choices::snapping(ui, face, view);
        let mut triangles = triangles(document);
        let before = triangles.clone();
        if !triangles.is_empty() {
            heading(ui, face, &face.say("ui-vertices-depth"));
            for (i, triangle) in triangles.iter_mut().enumerate() {
                for (corner, [x, y, z]) in triangle.iter_mut().enumerate() {
                    choices::fields(ui, face, &name(i, corner), [x, y, z]);
                }
            }
        }
        if triangles != before {
            set_triangles(document, triangles);
        }
        state(ui, face, document);
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let triangles = triangles(document);
        let corner = |i: usize| {
            let [x, y, _] = triangles[i / 3][i % 3];
            Handle { name: name(i / 3, i % 3), at: [x, y], kind: Kind::Point }
        };
        (0..3 * triangles.len()).map(corner).collect()
    }

    fn outcome(&self, document: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let passed = count(markers, Role::Accepted);
        Some(Outcome {
            came: Some(passed + count(markers, Role::Rejected)),
            went: passed,
            unit: None,
            given: (triangles(document).len(), "pipeline-unit-triangles"),
        })
    }

    fn drag(&self, document: &mut Document, handle: usize, [x, y]: [f32; 2]) {
        let mut triangles = triangles(document);
        if let Some(triangle) = triangles.get_mut(handle / 3) {
            let corner = &mut triangle[handle % 3];
            *corner = [x, y, corner[2]];
            set_triangles(document, triangles);
        }
    }
}

/// From the first edit on the triangles are the lab's own.
fn set_triangles(document: &mut Document, triangles: Vec<[[f32; 3]; 3]>) {
    if let LabInput::ZBuffer(input) = document.input_mut() {
        input.triangles = Some(triangles);
    }
}

/// What passes, what is stored then, and what the buffer is cleared to: of the lab's own triangles, or
/// of all of the scene's draws.
fn test(ui: &mut Ui, face: &Face<'_>, document: &mut Document) {
    let LabInput::ZBuffer(mut input) = document.input().clone() else { return };
    let own = input.triangles.is_some();
    let first = document.scene.draws.first().map(|draw| draw.depth).unwrap_or_default();
    let before = if own { (input.test, input.write) } else { (first.compare, first.write) };
    let (mut compare, mut write) = before;
    let all = CompareFunction::ALL.map(|compare| (compare, compare.name().to_owned()));
    choices::choose(ui, face, "ui-depth-test", &mut compare, &all);
    choices::check(ui, face, "ui-depth-write", &mut write);
    if (compare, write) != before {
        if own {
            (input.test, input.write) = (compare, write);
            *document.input_mut() = input.into();
        } else {
            let states = document.scene.draws.iter_mut().map(|draw| &mut draw.depth);
            states.for_each(|state| (state.compare, state.write) = (compare, write));
        }
    }
    let name = face.say("ui-depth-clear");
    let clear = &mut document.scene.clear.depth;
    choices::labelled(ui, face, &name, |ui, width| choices::number(ui, face, width, &name, clear));
    *clear = clear.clamp(0.0, 1.0);
    choices::check(ui, face, "ui-depth-reversed", &mut document.scene.reversed);
}

/// Bias, depth clamp, scissor and alpha test: of one of the lab's own triangles, or of one of the draws.
fn state(ui: &mut Ui, face: &Face<'_>, document: &mut Document) {
    let LabInput::ZBuffer(mut input) = document.input().clone() else { return };
    let size = document.scene.size;
    match input.triangles.as_ref().map(Vec::len) {
        Some(count) => {
            super::fragment_state::of_triangles(ui, face, (&mut input.states, count), size);
            choices::check(ui, face, "ui-bias-counts", &mut input.bias);
        }
        None => super::fragment_state::of_draws(ui, face, &mut document.scene),
    }
    choices::check(ui, face, "ui-early-z", &mut input.early_z);
    if document.input() != &LabInput::ZBuffer(input.clone()) {
        *document.input_mut() = input.into();
    }
}

/// The lab's own triangles, or those of the scene if they are few.
fn triangles(document: &Document) -> Vec<[[f32; 3]; 3]> {
    match document.input() {
        LabInput::ZBuffer(labs::ZBuffer { triangles: Some(triangles), .. }) => triangles.clone(),
        LabInput::ZBuffer(labs::ZBuffer { triangles: None, .. }) if is_small(&document.scene) => {
            screen_triangles(&document.scene).iter().map(|triangle| triangle.vertices).collect()
        }
        _ => Vec::new(),
    }
}

/// The corner of a triangle: `A0`, `A1`, `A2`, `B0`, ...
fn name(triangle: usize, corner: usize) -> String {
    let letter = char::from(b'A' + (triangle % 26) as u8);
    format!("{letter}{corner}")
}

/// How depths are stored.
pub(super) fn depth_format(ui: &mut Ui, face: &Face<'_>, document: &mut Document) {
    let all = DepthFormat::ALL.map(|format| (format, format.name().to_owned()));
    choices::choose(ui, face, "ui-depth-format", &mut document.scene.depth_format, &all);
}
