//! The scene in world space with the frustum round it, seen from outside by a camera of its own.

use rasterscope_core::{
    explain::{Label, Mark, Role},
    pipeline::{Fate, Outputs},
    scene::Scene,
    transform::{DepthRange, Matrix},
};
use rasterscope_figure::orbit::{FRUSTUM_EDGES, Orbit, frustum_corners};

/// Most triangles that are drawn; of larger models every n-th one.
const MOST: usize = 6000;

/// A camera that sees the frustum and the scene from the side.
pub(super) fn first_orbit(outputs: &Outputs, scene: &Scene) -> Orbit {
    let mut points: Vec<[f32; 3]> = frustum(outputs, scene).map_or_else(Vec::new, |corners| corners.to_vec());
    points.push(scene.camera.eye);
    for draw in &outputs.draws {
        points.extend(draw.world().iter().map(|[x, y, z, _]| [*x, *y, *z]));
    }
    // The sphere round everything leaves much room at the sides.
    Orbit::framing(&points, 0.9, 0.3).nearer(1.25)
}

fn frustum(outputs: &Outputs, scene: &Scene) -> Option<[[f32; 3]; 8]> {
    let product = multiply(&outputs.projection, &outputs.view);
    let near = if scene.depth_range == DepthRange::MinusOneToOne { -1.0 } else { 0.0 };
    frustum_corners(&product, near)
}

/// The product of two matrices, column by column.
fn multiply(a: &Matrix, b: &Matrix) -> Matrix {
    let a = glam::DMat4::from_cols_array(&a.map(f64::from));
    let b = glam::DMat4::from_cols_array(&b.map(f64::from));
    (a * b).to_cols_array().map(|c| c as f32)
}

/// Triangles back to front, the frustum, the eye.
pub(super) fn marks(outputs: &Outputs, scene: &Scene, orbit: &Orbit) -> Vec<Mark> {
    let mut marks = Vec::new();
    if let Some(corners) = frustum(outputs, scene) {
        for [a, b] in FRUSTUM_EDGES {
            if let Some(ends) = orbit.segment(corners[a], corners[b]) {
                let near = a < 4 && b < 4;
                let role = if near { Role::Neutral } else { Role::Candidate };
                marks.push(Mark::Segment { ends, role, label: None });
            }
        }
        for (corner, name) in [(3, "near"), (7, "far")] {
            if let Some(at) = orbit.project(corners[corner]) {
                let label = Label::name(name);
                marks.push(Mark::Text { at, label, role: Role::Candidate, big: false });
            }
        }
    }
    triangles(&mut marks, outputs, scene, orbit);
    if let Some(at) = orbit.project(scene.camera.eye) {
        marks.push(Mark::Point { at, role: Role::Neutral, label: Some(Label::name("eye")) });
    }
    marks
}

fn triangles(marks: &mut Vec<Mark>, outputs: &Outputs, scene: &Scene, orbit: &Orbit) {
    let total: usize = outputs.draws.iter().map(|draw| draw.mesh().triangles.len()).sum();
    let every = total.div_ceil(MOST).max(1);
    let mut drawn: Vec<(f32, Mark)> = Vec::new();
    for (object, (draw, stages)) in scene.draws.iter().zip(&outputs.draws).enumerate() {
        let mut label = (!draw.name.is_empty() && total <= 64).then(|| Label::name(&draw.name));
        let world = stages.world();
        if world.is_empty() {
            continue;
        }
        let decisions = &stages.culled().decisions;
        for (i, triangle) in stages.mesh().triangles.iter().enumerate().step_by(every) {
            let corners = triangle.map(|vertex| {
                let [x, y, z, _] = world[vertex as usize];
                [x, y, z]
            });
            let points = orbit.polygon(&corners);
            if points.len() < 3 {
                continue;
            }
            let depth = corners.iter().map(|&corner| orbit.depth(corner)).sum();
            let dropped = decisions.get(i).is_some_and(|decision| decision.fate != Fate::Drawn);
            let mark = if dropped {
                Mark::Polygon { points, role: Role::Rejected, object: None, label: label.take() }
            } else {
                Mark::Polygon { points, role: Role::Neutral, object: Some(object % 4), label: label.take() }
            };
            drawn.push((depth, mark));
        }
    }
    drawn.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    marks.extend(drawn.into_iter().map(|(_, mark)| mark));
}
