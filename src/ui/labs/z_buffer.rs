//! The z-buffer: drag triangles over each other and change their depths.

use super::{Handle, Kind, Lab, scanline::fill_rule};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{depth::DepthFormat, scene::LabInput};

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
        fill_rule(ui, face, document);
        choices::snapping(ui, face, view);
        if let LabInput::ZBuffer { triangles: Some(triangles) } = document.input_mut() {
            heading(ui, face, &face.say("ui-vertices-depth"));
            for (i, triangle) in triangles.iter_mut().enumerate() {
                for (corner, [x, y, z]) in triangle.iter_mut().enumerate() {
                    choices::fields(ui, face, &name(i, corner), [x, y, z]);
                }
            }
        }
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let LabInput::ZBuffer { triangles: Some(triangles) } = document.input() else { return Vec::new() };
        let corner = |i: usize| {
            let [x, y, _] = triangles[i / 3][i % 3];
            Handle { name: name(i / 3, i % 3), at: [x, y], kind: Kind::Point }
        };
        (0..3 * triangles.len()).map(corner).collect()
    }

    fn drag(&self, document: &mut Document, handle: usize, [x, y]: [f32; 2]) {
        if let LabInput::ZBuffer { triangles: Some(triangles) } = document.input_mut() {
            let corner = &mut triangles[handle / 3][handle % 3];
            *corner = [x, y, corner[2]];
        }
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
