//! The slope scan line: drag the corners of a triangle over the pixels it fills.

use super::{Handle, Kind, Lab};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{raster::FillRule, scene::LabInput};

/// The lab.
#[derive(Debug)]
pub(crate) struct Scanline;

impl Lab for Scanline {
    fn name(&self) -> &'static str {
        "scanline"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        heading(ui, face, &face.say("ui-conventions"));
        fill_rule(ui, face, document);
        choices::snapping(ui, face, view);
        match document.input_mut() {
            LabInput::Scanline { vertices: Some(vertices), .. } => {
                heading(ui, face, &face.say("ui-vertices-pixels"));
                for (i, [x, y]) in vertices.iter_mut().enumerate() {
                    choices::fields(ui, face, &format!("V{i}"), [x, y]);
                }
            }
            LabInput::Scanline { vertices: None, triangle } => {
                heading(ui, face, &face.say("ui-triangle-of-scene"));
                choices::index(ui, face, "ui-triangle", triangle);
            }
            _ => {}
        }
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let LabInput::Scanline { vertices: Some(vertices), .. } = document.input() else { return Vec::new() };
        let corner =
            |(i, at): (usize, &[f32; 2])| Handle { name: format!("V{i}"), at: *at, kind: Kind::Point };
        vertices.iter().enumerate().map(corner).collect()
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        if let LabInput::Scanline { vertices: Some(vertices), .. } = document.input_mut() {
            vertices[handle] = to;
        }
    }
}

/// Who draws a pixel whose centre lies exactly on an edge.
pub(super) fn fill_rule(ui: &mut Ui, face: &Face<'_>, document: &mut Document) {
    let all = FillRule::ALL.map(|rule| {
        let name = match rule {
            FillRule::TopLeft => "ui-fill-top-left",
            FillRule::RightOfPoint => "ui-fill-right-of-point",
            FillRule::Inclusive => "ui-fill-inclusive",
            FillRule::Strict => "ui-fill-strict",
        };
        (rule, face.say(name))
    });
    choices::choose(ui, face, "ui-fill-rule", &mut document.scene.fill_rule, &all);
}
