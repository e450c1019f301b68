//! Whole objects against the frustum: a body around each, plane by plane.
//!
//! *Source:* Clark, Hierarchical Geometric Models for Visible Surface Algorithms, 1976; Assarsson and
//! Möller, Optimized View Frustum Culling Algorithms, 2000. Deviation: what rounding may move is part of
//! every test, so nothing visible is ever culled; an object that crosses a plane has its triangles tested,
//! exactly, in clip space.

mod explain;
mod picture;

pub use explain::Snapshot;
pub(super) use explain::reach_formulas;

use super::{
    frustum::triangle_outside,
    planes::{Frustum, PlaneMask, Side, Volume},
    sphere::Sphere,
};
use crate::{
    clip::polygon::Plane,
    replay::{Budget, Player},
    scene::Scene,
    trace::{NoTrace, Tracer},
    transform::{
        DepthRange, apply,
        chain::Chain,
        frustum::frustum_corners,
        matrices::{Matrix, row},
    },
};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// What stands for an object.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Body {
    /// A small sphere around it: one radius for all planes.
    #[default]
    Sphere,
    /// Its box in object space: it turns with the object.
    Box,
}

impl Body {
    /// Both, the default first.
    pub const ALL: [Self; 2] = [Self::Sphere, Self::Box];

    /// The id of the word for it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Sphere => "frustum-culling-sphere",
            Self::Box => "frustum-culling-box",
        }
    }

    /// The body around points of object space; `None` if there are none.
    pub fn around(self, points: &[[f32; 3]]) -> Option<Volume> {
        match self {
            Self::Sphere => Sphere::around(points).map(Volume::Sphere),
            Self::Box => (!points.is_empty())
                .then(|| Volume::Box(super::bvh::union(points.iter().map(|&point| [point, point])))),
        }
    }
}

/// One object of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// The draw's name.
    pub name: String,
    /// The body around it, in object space.
    pub volume: Volume,
    /// The frustum there.
    pub frustum: Frustum,
    /// Object to world space.
    pub model: Matrix,
    /// Its triangles in clip space.
    pub clip: Arc<[[[f32; 4]; 3]]>,
    /// Its triangles in world space, to be drawn.
    pub world: Arc<[[[f32; 3]; 3]]>,
}

/// The objects and the frustum of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// In drawing order; what has no triangles is left out.
    pub objects: Arc<[Object]>,
    /// What stands for them.
    pub body: Body,
    /// Which depths are visible.
    pub range: DepthRange,
    /// The frustum's corners in world space, to be drawn.
    pub corners: Option<[[f32; 3]; 8]>,
}

impl Input {
    /// All objects of a resolved scene.
    pub fn of(scene: &Scene, body: Body) -> Self {
        let range = scene.depth_range;
        let objects = scene.draws.iter().enumerate().filter_map(|(index, draw)| {
            let mesh = draw.geometry.mesh()?;
            let volume = body.around(&mesh.positions)?;
            let chain = Chain::of(scene, draw);
            let world: Vec<_> =
                mesh.positions.iter().map(|&[x, y, z]| apply(&chain.model, [x, y, z, 1.0])).collect();
            let clip: Vec<_> =
                world.iter().map(|&p| apply(&chain.projection, apply(&chain.view, p))).collect();
            let corners = |triangle: &[u32; 3]| triangle.map(|i| i as usize);
            Some(Object {
                name: crate::pipeline::draw_name((index, draw)),
                volume,
                frustum: Frustum::before(&[&chain.model, &chain.view, &chain.projection], range),
                model: chain.model,
                clip: mesh.triangles.iter().map(|t| corners(t).map(|i| clip[i])).collect(),
                world: mesh
                    .triangles
                    .iter()
                    .map(|t| corners(t).map(|i| world[i]).map(|[x, y, z, _]| [x, y, z]))
                    .collect(),
            })
        });
        Self { objects: objects.collect(), body, range, corners: world_frustum(scene) }
    }
}

/// The corners of a scene's frustum in world space.
pub fn world_frustum(scene: &Scene) -> Option<[[f32; 3]; 8]> {
    let aspect = f64::from(scene.size[0]) / f64::from(scene.size[1]);
    let view = crate::transform::matrices::view(&scene.camera);
    let projection =
        crate::transform::matrices::projection(&scene.camera, aspect, scene.depth_range, scene.reversed);
    let mut product = [0.0; 16];
    for i in 0..4 {
        for j in 0..4 {
            let row = row(&projection, i).map(f64::from);
            let sum: f64 = (0..4).map(|k| row[k] * f64::from(view[4 * j + k])).sum();
            product[4 * j + i] = sum as f32;
        }
    }
    let near = if scene.depth_range == DepthRange::ZeroToOne { 0.0 } else { -1.0 };
    frustum_corners(&product, near)
}

/// What the run did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Event {
    /// The next object is taken.
    Object {
        /// Its place in the input.
        object: u32,
    },
    /// Its body was tested against a plane.
    Plane {
        /// The object.
        object: u32,
        /// The plane.
        plane: Plane,
        /// On which side it lies.
        side: Side,
    },
    /// The body lies outside: no vertex and no triangle of it is looked at.
    Reject {
        /// The object.
        object: u32,
        /// The plane.
        plane: Plane,
    },
    /// The body lies inside all planes: no triangle needs a test, none is clipped.
    Accept {
        /// The object.
        object: u32,
    },
    /// The body crosses a plane: its triangles are tested.
    Cross {
        /// The object.
        object: u32,
    },
    /// A triangle was tested by its vertices in clip space.
    Triangle {
        /// The object.
        object: u32,
        /// The triangle.
        triangle: u32,
        /// A plane that all its vertices lie outside of.
        outside: Option<Plane>,
    },
    /// No object is left.
    Done,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// What was found about an object.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It lies outside this plane.
    Outside(Plane),
    /// It lies inside all planes.
    Inside,
    /// It crosses a plane; these are the planes that its triangles lie outside of.
    Crosses(Vec<Option<Plane>>),
}

/// Tests every object's body, and the triangles of those that cross.
///
/// Never calls an object outside of which the pipeline would draw a pixel. At most six plane tests an
/// object, of about 5 ns.
pub fn cull(input: &Input) -> Vec<Verdict> {
    cull_traced(input, &mut NoTrace)
}

/// [`cull`] as a run that can be scrubbed.
pub fn play(input: Input, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(input.clone()), budget, move |t| {
        cull_traced(&input, t);
    })
}

/// The algorithm: [`cull`] and [`play`] are this with two tracers.
pub fn cull_traced<T: Tracer<Event>>(input: &Input, t: &mut T) -> Vec<Verdict> {
    let verdicts = (0..).zip(input.objects.iter()).map(|(object, of)| {
        t.emit(|| Event::Object { object });
        let crossed = of.frustum.test(&of.volume, PlaneMask::ALL, |plane, side| {
            t.emit(|| Event::Plane { object, plane, side });
        });
        match crossed {
            Err(plane) => {
                t.emit(|| Event::Reject { object, plane });
                Verdict::Outside(plane)
            }
            Ok(PlaneMask::NONE) => {
                t.emit(|| Event::Accept { object });
                Verdict::Inside
            }
            Ok(_) => {
                t.emit(|| Event::Cross { object });
                let triangles = (0..).zip(of.clip.iter()).map(|(triangle, &vertices)| {
                    let outside = triangle_outside(vertices, input.range);
                    t.emit(|| Event::Triangle { object, triangle, outside });
                    outside
                });
                Verdict::Crosses(triangles.collect())
            }
        }
    });
    let verdicts = verdicts.collect();
    t.emit(|| Event::Done);
    verdicts
}
