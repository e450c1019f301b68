//! The scene in world space with the frustum round it, seen from outside by a camera of its own.
//!
//! A few triangles are drawn as outlines that can be seen through; a model is drawn by the pipeline
//! itself, from the camera outside.

use rasterscope_core::{
    cull::CullMode,
    depth::{DepthPlacement, DepthState},
    explain::{Grid, Label, Mark, Role, View},
    pipeline::{Fate, Outputs, Pipeline, Skips},
    scene::{Clear, Draw, Scene},
    transform::{Camera, DepthRange, Matrix, Projection},
};
use rasterscope_figure::orbit::{FRUSTUM_EDGES, Orbit, frustum_corners};
use std::sync::Arc;

/// More triangles than this are drawn by the pipeline.
const MOST_OUTLINES: usize = 64;
/// The image of a model, in pixels; its height shows what [`Orbit::view`] frames.
const SIZE: [u32; 2] = [960, 640];

/// How much wider than high a canvas is at least.
const WIDE: f32 = 1.05;

/// The view from outside.
#[derive(Debug, Default)]
pub(super) struct Space {
    /// Draws models.
    pipeline: Pipeline,
}

/// A camera that sees the frustum and the scene from the side.
pub(super) fn first_orbit(outputs: &Outputs, scene: &Scene) -> Orbit {
    let mut points: Vec<[f32; 3]> = frustum(outputs, scene).map_or_else(Vec::new, |corners| corners.to_vec());
    points.push(scene.camera.eye);
    for draw in &outputs.draws {
        points.extend(draw.world().iter().map(|[x, y, z, _]| [*x, *y, *z]));
    }
    Orbit::filling(&points, 0.9, 0.3, WIDE)
}

fn frustum(outputs: &Outputs, scene: &Scene) -> Option<[[f32; 3]; 8]> {
    let product = multiply(&outputs.projection, &outputs.view);
    let near = if scene.depth_range == DepthRange::MinusOneToOne { -1.0 } else { 0.0 };
    frustum_corners(&product, near)
}

/// The product of two matrices, column by column.
fn multiply(a: &Matrix, b: &Matrix) -> Matrix {
    let [a, b] = [a, b].map(|matrix| glam::DMat4::from_cols_array(&matrix.map(f64::from)));
    (a * b).to_cols_array().map(|c| c as f32)
}

impl Space {
    /// Triangles, the frustum, the eye; in pixels of [`SIZE`].
    pub(super) fn drawing(&mut self, outputs: &Outputs, scene: &Scene, orbit: &Orbit) -> (Vec<Mark>, View) {
        let total: usize = outputs.draws.iter().map(|draw| draw.mesh().triangles.len()).sum();
        let mut marks = Vec::new();
        if total > MOST_OUTLINES {
            marks.push(self.model(scene, orbit));
        }
        frustum_marks(&mut marks, outputs, scene, orbit);
        if total <= MOST_OUTLINES {
            triangles(&mut marks, outputs, scene, orbit);
        }
        if let Some(at) = orbit.project(scene.camera.eye) {
            marks.push(Mark::Point { at: place(at), role: Role::Neutral, label: Some(Label::name("eye")) });
        }
        let side = SIZE[1] as f32;
        let left = (SIZE[0] as f32 - side) / 2.0;
        (marks, View { min: [left, 0.0], max: [left + side, side], y_up: false, grid: Grid::None })
    }

    /// The image of the scene from the camera outside.
    fn model(&mut self, scene: &Scene, orbit: &Orbit) -> Mark {
        let camera = Camera {
            eye: orbit.eye(),
            target: orbit.target,
            up: [0.0, 1.0, 0.0],
            near: orbit.distance * 0.02,
            far: orbit.distance * 50.0,
            projection: Projection::Perspective { fovy_degrees: 45.0 },
        };
        let plain = |draw: &Draw| Draw {
            cull: CullMode::None,
            depth: DepthState::default(),
            placement: DepthPlacement::default(),
            scissor: None,
            stencil: None,
            blend: None,
            ..draw.clone()
        };
        let clear = Clear { color: [0.0; 4], ..Clear::default() };
        let draws = scene.draws.iter().map(plain).collect();
        let outside = Scene { camera, clear, draws, ..Scene::empty(SIZE) };
        let frame = &self.pipeline.update(&outside, &Skips::ALL).frame;
        Mark::Image { size: frame.size.map(|side| side as usize), rgba: Arc::new(frame.color.clone()) }
    }
}

/// From units of the orbit's picture to pixels of [`SIZE`].
fn place([x, y]: [f32; 2]) -> [f32; 2] {
    let [width, height] = SIZE.map(|side| side as f32);
    [(width + x * height) / 2.0, (1.0 - y) * height / 2.0]
}

fn frustum_marks(marks: &mut Vec<Mark>, outputs: &Outputs, scene: &Scene, orbit: &Orbit) {
    let Some(corners) = frustum(outputs, scene) else { return };
    for [a, b] in FRUSTUM_EDGES {
        if let Some(ends) = orbit.segment(corners[a], corners[b]) {
            let near = a < 4 && b < 4;
            let role = if near { Role::Neutral } else { Role::Candidate };
            marks.push(Mark::Segment { ends: ends.map(place), role, label: None });
        }
    }
    for (corner, name) in [(3, "near"), (7, "far")] {
        if let Some(at) = orbit.project(corners[corner]) {
            marks.push(Mark::Text {
                at: place(at),
                label: Label::name(name),
                role: Role::Candidate,
                big: false,
            });
        }
    }
}

/// Back to front, each in the colour of its object.
fn triangles(marks: &mut Vec<Mark>, outputs: &Outputs, scene: &Scene, orbit: &Orbit) {
    let mut drawn: Vec<(f32, Mark)> = Vec::new();
    for (object, (draw, stages)) in scene.draws.iter().zip(&outputs.draws).enumerate() {
        let mut label = (!draw.name.is_empty()).then(|| Label::name(&draw.name));
        let decided = stages.mesh().triangles.iter().zip(&stages.culled().decisions);
        for (triangle, decision) in decided {
            let corners = triangle.map(|vertex| {
                let [x, y, z, _] = stages.world()[vertex as usize];
                [x, y, z]
            });
            let points: Vec<[f32; 2]> = orbit.polygon(&corners).into_iter().map(place).collect();
            if points.len() < 3 {
                continue;
            }
            let depth = corners.iter().map(|&corner| orbit.depth(corner)).sum();
            let kept = decision.fate == Fate::Drawn;
            let role = if kept { Role::Neutral } else { Role::Rejected };
            drawn.push((
                depth,
                Mark::Polygon { points, role, object: kept.then_some(object % 4), label: label.take() },
            ));
        }
    }
    drawn.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    marks.extend(drawn.into_iter().map(|(_, mark)| mark));
}
