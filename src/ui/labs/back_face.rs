//! Back-face tests: one triangle, asked six times whether the eye sees its back.

use super::{Handle, Lab, Outcome, SolidHandle, placing};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use glam::{DMat4, DVec4};
use rasterscope_core::{
    cull::back_face::EdgeOn,
    explain::{Marker, Role},
    labs::{self, LabInput},
    math::Arithmetic,
    scene::{Draw, Geometry, Scene},
    transform::{apply, chain::model_matrix},
};
use std::sync::Arc;

/// The lab.
#[derive(Debug)]
pub(crate) struct BackFace;

impl Lab for BackFace {
    fn name(&self) -> &'static str {
        "back-face"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, _: &mut ViewState) {
        let LabInput::BackFace(mut input) = *document.input() else { return };
        heading(ui, face, &face.say("ui-conventions"));
        let all = EdgeOn::ALL.map(|rule| (rule, face.say(rule.word())));
        choices::choose(ui, face, "back-face-rule", &mut input.edge_on, &all);
        let all =
            [Arithmetic::Exact, Arithmetic::F64, Arithmetic::F32].map(|each| (each, face.say(each.word())));
        choices::choose(ui, face, "ui-arithmetic", &mut input.arithmetic, &all);
        super::pipeline::facing(ui, face, document);
        let names: Vec<(usize, String)> =
            document.scene.draws.iter().enumerate().map(|(i, draw)| (i, draw.name.clone())).collect();
        heading(ui, face, &face.say("ui-triangle-of-scene"));
        choices::choose(ui, face, "ui-object", &mut input.draw, &names);
        choices::index(ui, face, "ui-triangle", &mut input.triangle);
        let triangles =
            document.scene.draws.get(input.draw).and_then(|draw| Some(draw.geometry.mesh()?.triangles.len()));
        input.triangle = input.triangle.min(triangles.unwrap_or_default().saturating_sub(1));
        vertices(ui, face, &mut document.scene, &input);
        *document.input_mut() = input.into();
        placing::transform(ui, face, &mut document.scene, input.draw);
        placing::camera(ui, face, &mut document.scene);
    }

    fn handles(&self, _: &Document) -> Vec<Handle> {
        Vec::new()
    }

    fn solid_handles(&self, document: &Document) -> Vec<SolidHandle> {
        let Some((of, indices)) = triangle(&document.scene, document.input()) else { return Vec::new() };
        let Geometry::Mesh(mesh) = &of.geometry else { return Vec::new() };
        let model = model_matrix(&of.transform);
        let handle = |(i, index): (usize, &u32)| {
            let [x, y, z] = mesh.positions[*index as usize];
            let [x, y, z, _] = apply(&model, [x, y, z, 1.0]);
            SolidHandle { name: format!("p{i}"), at: [x, y, z] }
        };
        indices.iter().enumerate().map(handle).collect()
    }

    fn drag_solid(&self, document: &mut Document, handle: usize, to: [f32; 3]) {
        let LabInput::BackFace(labs::BackFace { draw, .. }) = *document.input() else { return };
        let Some((of, indices)) = triangle(&document.scene, document.input()) else { return };
        let model = DMat4::from_cols_array(&model_matrix(&of.transform).map(f64::from));
        let [x, y, z] = to.map(f64::from);
        let at = model.inverse() * DVec4::new(x, y, z, 1.0);
        // Shown numbers have at most four decimals: a drag gives no more.
        let at = (at / at.w * 4096.0).round() / 4096.0;
        if let (true, Geometry::Mesh(mesh)) = (at.is_finite(), &mut document.scene.draws[draw].geometry) {
            let [x, y, z, _] = at.as_vec4().to_array();
            Arc::make_mut(mesh).positions[indices[handle] as usize] = [x + 0.0, y + 0.0, z + 0.0];
        }
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let kept = markers.last().is_some_and(|(_, marker)| marker.role == Role::Accepted);
        let given = (1, "pipeline-unit-triangles");
        Some(Outcome { came: Some(1), went: usize::from(kept), unit: Some(given.1), given })
    }

    fn drag(&self, _: &mut Document, _: usize, _: [f32; 2]) {}
}

/// The chosen draw and the indices of the chosen triangle.
fn triangle<'s>(scene: &'s Scene, input: &LabInput) -> Option<(&'s Draw, [u32; 3])> {
    let LabInput::BackFace(labs::BackFace { draw, triangle, .. }) = *input else { return None };
    let of = scene.draws.get(draw)?;
    Some((of, *of.geometry.mesh()?.triangles.get(triangle)?))
}

/// The vertices of the chosen triangle, if they stand in the scene file.
fn vertices(ui: &mut Ui, face: &Face<'_>, scene: &mut Scene, input: &labs::BackFace) {
    let Some(Geometry::Mesh(mesh)) = scene.draws.get_mut(input.draw).map(|draw| &mut draw.geometry) else {
        return;
    };
    let Some(indices) = mesh.triangles.get(input.triangle).copied() else { return };
    for (i, index) in indices.into_iter().enumerate() {
        let before = mesh.positions[index as usize];
        let mut after = before;
        let [x, y, z] = &mut after;
        choices::fields(ui, face, &format!("p{i}"), [x, y, z]);
        if after != before {
            Arc::make_mut(mesh).positions[index as usize] = after;
        }
    }
}
