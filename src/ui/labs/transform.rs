//! The transform chain: one vertex from object space to the screen.

use super::{Handle, Lab, Outcome, count};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    explain::{Marker, Role},
    labs::{self, LabInput},
    scene::Geometry,
    transform::DepthRange,
};
use std::sync::Arc;

/// The lab.
#[derive(Debug)]
pub(crate) struct Transform;

impl Lab for Transform {
    fn name(&self) -> &'static str {
        "transform"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, _: &mut ViewState) {
        heading(ui, face, &face.say("ui-conventions"));
        depth_range(ui, face, document);
        let LabInput::Transform(labs::Transform { mut draw, mut vertex }) = *document.input() else { return };
        let names: Vec<(usize, String)> =
            document.scene.draws.iter().enumerate().map(|(i, draw)| (i, draw.name.clone())).collect();
        heading(ui, face, &face.say("ui-vertex"));
        choices::choose(ui, face, "ui-object", &mut draw, &names);
        choices::index(ui, face, "ui-vertex", &mut vertex);
        if let Some(Geometry::Mesh(mesh)) = document.scene.draws.get_mut(draw).map(|draw| &mut draw.geometry)
        {
            vertex = vertex.min(mesh.positions.len().saturating_sub(1));
            if let Some(position) = mesh.positions.get(vertex) {
                let mut moved = *position;
                let [x, y, z] = &mut moved;
                choices::fields(ui, face, &format!("v{vertex}"), [x, y, z]);
                if moved != *position {
                    Arc::make_mut(mesh).positions[vertex] = moved;
                }
            }
        }
        *document.input_mut() = labs::Transform { draw, vertex }.into();
        super::placing::transform(ui, face, &mut document.scene, draw);
        super::placing::camera(ui, face, &mut document.scene);
    }

    fn handles(&self, _: &Document) -> Vec<Handle> {
        Vec::new()
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        Some(Outcome {
            came: None,
            went: count(markers, Role::Accepted),
            unit: Some("pipeline-unit-vertices"),
            given: (1, "pipeline-unit-vertices"),
        })
    }

    fn drag(&self, _: &mut Document, _: usize, _: [f32; 2]) {}
}

/// Which depths in NDC are visible.
pub(super) fn depth_range(ui: &mut Ui, face: &Face<'_>, document: &mut Document) {
    let all = DepthRange::ALL.map(|range| (range, face.say(range.word())));
    choices::choose(ui, face, "ui-depth-range", &mut document.scene.depth_range, &all);
}
