//! The triangles of a draw that was enlarged for its outline.

use super::{
    ScreenTriangle, Skips,
    evaluate::Pipeline,
    stages::{self, CullKey},
};
use crate::{
    scene::{Geometry, Scene},
    stencil::Enlarge,
    transform::{Matrix, apply, divide},
};
use std::sync::Arc;

/// The triangles of one draw that are scan converted, after its vertices were moved outwards.
///
/// Empty for a model that is not loaded. Culled, clipped and placed as any other draw.
pub fn enlarged_triangles(scene: &Scene, index: usize, enlarge: Enlarge) -> Vec<ScreenTriangle> {
    let mut draw = scene.draws[index].clone();
    let Some(mesh) = draw.geometry.mesh().map(Arc::clone) else { return Vec::new() };
    let mut moved = (*mesh).clone();
    moved.positions = enlarge.positions(&mesh);
    draw.geometry = Geometry::Mesh(Arc::new(moved));
    let alone = Scene { draws: vec![draw], ..scene.clone() };
    let mut pipeline = Pipeline::default();
    pipeline.update_geometry(&alone, Skips::NONE);
    let outputs = pipeline.outputs();
    let [stages] = &outputs.draws[..] else { return Vec::new() };
    let mut clip = stages.clip().to_vec();
    let matrix = product(&outputs.projection, &product(&outputs.view, stages.model()));
    enlarge.clip(&mesh, &matrix, scene.size, &mut clip);
    let key = CullKey::new(&alone.draws[0], scene.depth_range, Skips::ALL);
    let clipped = stages::clip(&stages::cull(&key, &clip, &mesh), &clip, &stages.varyings(), key.visible);
    let place = |corner: &stages::Point| outputs.viewport.to_screen(divide(*corner));
    let screen: Vec<_> = clipped.corners.iter().map(place).collect();
    let triangle = |piece| ScreenTriangle::new(index as u32, &screen, &clipped.colors, piece);
    clipped.pieces.iter().map(triangle).collect()
}

/// Two matrices, column by column, each product component rounded once.
fn product(left: &Matrix, right: &Matrix) -> Matrix {
    let (columns, _) = right.as_chunks();
    let mut all = columns.iter().flat_map(|column: &[f32; 4]| apply(left, *column));
    std::array::from_fn(|_| all.next().unwrap_or(0.0))
}
