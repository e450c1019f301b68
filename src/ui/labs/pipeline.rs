//! The overview: the whole scene, its conventions, and vertices to drag in the image.

use super::{
    Handle, Kind, Lab, Outcome, light, scanline::fill_rule, transform::depth_range, z_buffer::depth_format,
};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use glam::{DMat4, DVec4};
use rasterscope_core::{
    cull::{CullMode, FrontFace},
    explain::Marker,
    pipeline::Skip,
    raster::YAxis,
    scene::{Geometry, Scene},
    transform::{Viewport, chain::model_matrix, matrices},
};
use std::sync::Arc;

/// Scenes with more vertices than this have no handles: they would hide the image.
const MOST_HANDLES: usize = 12;

/// The lab.
#[derive(Debug)]
pub(crate) struct Pipeline;

impl Lab for Pipeline {
    fn name(&self) -> &'static str {
        "pipeline"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        heading(ui, face, &face.say("ui-conventions"));
        fill_rule(ui, face, document);
        depth_format(ui, face, document);
        depth_range(ui, face, document);
        let all = YAxis::ALL.map(|axis| (axis, face.say(axis.word())));
        choices::choose(ui, face, "ui-y-axis", &mut document.scene.y_axis, &all);
        facing(ui, face, document);
        choices::snapping(ui, face, view);
        light::shade(ui, face, &mut document.scene);
        super::objects::show(ui, face, &mut document.scene);
        super::fragment_state::of_draws(ui, face, &mut document.scene);
        super::placing::camera(ui, face, &mut document.scene);
        light::show(ui, face, &mut document.scene);
        heading(ui, face, &face.say("ui-skips"));
        for (skip, name) in SKIPS {
            let mut on = view.skips.has(skip);
            choices::check(ui, face, name, &mut on);
            view.skips = view.skips.with(skip, on);
        }
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let scene = &document.scene;
        let mut handles = Vec::new();
        for (draw, vertex) in vertices(scene) {
            let clip = to_clip(scene, draw) * position(scene, draw, vertex);
            if clip.w > 0.0 {
                let ndc = clip / clip.w;
                let [x, y, ..] = viewport(scene).to_screen([ndc.x as f32, ndc.y as f32, ndc.z as f32, 1.0]);
                handles.push(Handle {
                    name: format!("{}{vertex}", scene.draws[draw].name),
                    at: [x, y],
                    kind: Kind::Point,
                });
            }
        }
        handles
    }

    fn outcome(&self, _: &Document, _: &[(usize, Marker)]) -> Option<Outcome> {
        None // the chips are the pipeline's own
    }

    /// Moves a vertex in the plane that is parallel to the screen.
    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        let scene = &document.scene;
        let in_front =
            |&(draw, vertex): &(usize, usize)| (to_clip(scene, draw) * position(scene, draw, vertex)).w > 0.0;
        let Some((draw, vertex)) = vertices(scene).filter(in_front).nth(handle) else { return };
        let matrix = to_clip(scene, draw);
        let clip = matrix * position(scene, draw, vertex);
        let [w, h] = scene.size.map(f64::from);
        let x = 2.0 * f64::from(to[0]) / w - 1.0;
        let y = 2.0 * f64::from(to[1]) / h - 1.0;
        let y = if scene.y_axis == YAxis::Down { -y } else { y };
        let moved = matrix.inverse() * DVec4::new(x * clip.w, y * clip.w, clip.z, clip.w);
        // Shown numbers have at most four decimals: a drag gives no more.
        let moved =
            [moved.x, moved.y, moved.z].map(|c| ((c / moved.w * 4096.0).round() / 4096.0) as f32 + 0.0);
        if let (true, Geometry::Mesh(mesh)) =
            (moved.iter().all(|c| c.is_finite()), &mut document.scene.draws[draw].geometry)
        {
            Arc::make_mut(mesh).positions[vertex] = moved;
        }
    }
}

/// Skips of this pipeline, with the messages that name them.
const SKIPS: [(Skip, &str); 11] = [
    (Skip::ObjectFrustum, "ui-skip-object-frustum"),
    (Skip::Frustum, "ui-skip-frustum"),
    (Skip::BackFace, "ui-skip-back-face"),
    (Skip::Degenerate, "ui-skip-degenerate"),
    (Skip::Tile, "ui-skip-tile"),
    (Skip::Row, "ui-skip-row"),
    (Skip::EarlyZ, "ui-skip-early-z"),
    (Skip::HierarchicalZ, "ui-skip-hierarchical-z"),
    (Skip::Deferred, "ui-skip-deferred"),
    (Skip::Clear, "ui-skip-clear"),
    (Skip::Memo, "ui-skip-memo"),
];

/// Cull mode and front of all draws.
pub(super) fn facing(ui: &mut Ui, face: &Face<'_>, document: &mut Document) {
    let draws = &mut document.scene.draws;
    let Some(first) = draws.first() else { return };
    let (mut cull, mut front) = (first.cull, first.front);
    let (old_cull, old_front) = (cull, front);
    let fronts = FrontFace::ALL.map(|front| (front, face.say(front.word())));
    choices::choose(ui, face, "ui-front", &mut front, &fronts);
    let culls = CullMode::ALL.map(|cull| (cull, face.say(cull.word())));
    choices::choose(ui, face, "ui-cull", &mut cull, &culls);
    for draw in draws {
        if cull != old_cull {
            draw.cull = cull;
        }
        if front != old_front {
            draw.front = front;
        }
    }
}

/// The vertices that can be dragged: those of meshes that stand in the scene file.
fn vertices(scene: &Scene) -> impl Iterator<Item = (usize, usize)> + '_ {
    let count = |geometry: &Geometry| match geometry {
        Geometry::Mesh(mesh) => mesh.positions.len(),
        Geometry::Model { .. } => 0,
    };
    let few = scene.draws.iter().map(|draw| count(&draw.geometry)).sum::<usize>() <= MOST_HANDLES;
    let draws = scene.draws.iter().enumerate().filter(move |_| few);
    draws.flat_map(move |(draw, of)| (0..count(&of.geometry)).map(move |vertex| (draw, vertex)))
}

fn position(scene: &Scene, draw: usize, vertex: usize) -> DVec4 {
    let mesh = scene.draws[draw].geometry.mesh();
    let [x, y, z] = mesh.map_or([0.0; 3], |mesh| mesh.positions[vertex]).map(f64::from);
    DVec4::new(x, y, z, 1.0)
}

fn viewport(scene: &Scene) -> Viewport {
    Viewport { size: scene.size, depth_range: scene.depth_range, y_axis: scene.y_axis }
}

/// Object space to clip space; in f64, as a handle needs no more than to be under the pointer.
fn to_clip(scene: &Scene, draw: usize) -> DMat4 {
    let aspect = viewport(scene).aspect();
    let projection = matrices::projection(&scene.camera, aspect, scene.depth_range, scene.reversed);
    let all = [projection, matrices::view(&scene.camera), model_matrix(&scene.draws[draw].transform)];
    all.iter().map(|matrix| DMat4::from_cols_array(&matrix.map(f64::from))).product()
}
