//! The transform chain: a vertex on its way from object space to the screen, one number at a time.
//!
//! *Source:* Shirley, Marschner, Fundamentals of Computer Graphics, 4th ed. 2015, sections 7.1 to 7.3.

mod curve;
mod explain;
mod formulas;
mod picture;

pub use explain::Snapshot;

use super::{
    matrices::{self, Matrix, row_times},
    screen::{Viewport, divide},
};
use crate::{
    replay::{Budget, Player},
    scene::{Draw, Scene, Transform},
    trace::{NoTrace, Tracer},
};
use serde::Serialize;

/// Where a vertex has coordinates, in the order of the pipeline.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Space {
    /// As modelled; w = 1.
    Object,
    /// Where the object stands in the scene.
    World,
    /// Seen from the camera: the eye at the origin, looking along -z.
    View,
    /// Visible is `-w <= x, y <= w` and the depth range.
    Clip,
    /// Divided by w; the fourth component is 1/w.
    Ndc,
    /// Pixels and depth 0..=1; the fourth component is 1/w.
    Screen,
}

impl Space {
    /// All spaces in order.
    pub const ALL: [Self; 6] = [Self::Object, Self::World, Self::View, Self::Clip, Self::Ndc, Self::Screen];
}

/// Everything between object space and the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chain {
    /// Object to world space.
    pub model: Matrix,
    /// World to camera space.
    pub view: Matrix,
    /// Camera to clip space.
    pub projection: Matrix,
    /// NDC to the screen.
    pub viewport: Viewport,
}

/// The matrix that a draw's transform stands for.
pub fn model_matrix(transform: &Transform) -> Matrix {
    match *transform {
        Transform::Parts { translate, rotate_degrees, scale } => {
            matrices::model(translate, rotate_degrees, scale)
        }
        Transform::Matrix(matrix) => matrix,
    }
}

impl Chain {
    /// What takes a draw of a scene to the screen.
    pub fn of(scene: &Scene, draw: &Draw) -> Self {
        let viewport = Viewport { size: scene.size, depth_range: scene.depth_range, y_axis: scene.y_axis };
        let Scene { camera, depth_range, reversed, .. } = scene;
        Self {
            model: model_matrix(&draw.transform),
            view: matrices::view(camera),
            projection: matrices::projection(camera, viewport.aspect(), *depth_range, *reversed),
            viewport,
        }
    }

    /// The matrix that leads to a space, if one does.
    pub fn matrix(&self, to: Space) -> Option<&Matrix> {
        match to {
            Space::World => Some(&self.model),
            Space::View => Some(&self.view),
            Space::Clip => Some(&self.projection),
            Space::Object | Space::Ndc | Space::Screen => None,
        }
    }
}

/// One vertex in each of [`Space::ALL`].
pub type Path = [[f32; 4]; 6];

/// What the chain did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The next vertex enters, with w = 1.
    Vertex {
        /// Its number, from 0.
        vertex: u16,
    },
    /// The next matrix is taken.
    Matrix {
        /// The vertex.
        vertex: u16,
        /// Where the matrix leads to.
        to: Space,
    },
    /// One component in a new space is known.
    Component {
        /// The vertex.
        vertex: u16,
        /// The new space.
        to: Space,
        /// 0 to 3: x, y, z, and w or 1/w.
        row: u8,
        /// The component.
        value: f32,
    },
    /// All four components in a new space are known.
    Reached {
        /// The vertex.
        vertex: u16,
        /// The new space.
        space: Space,
    },
    /// w was compared with 0: only `w > 0` lies in front of the eye. What is divided by another w is
    /// no image of the vertex; for w = 0 it is set to zero.
    Sight {
        /// The vertex.
        vertex: u16,
        /// Its w in clip space.
        w: f32,
    },
    /// No vertex is left.
    Done,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Takes vertices through all spaces: `v' = P C^-1 W v`, `v'' = v' / w`, `v''' = D v''`.
///
/// Input in object space, finite. Each component is rounded once in each space. A vertex behind the eye
/// or beside the picture goes through as well; [`divide`] says what it becomes. Costs three matrix
/// products and four divisions a vertex. At most 2^16 vertices; further ones are left out.
pub fn run(vertices: &[[f32; 3]], chain: &Chain) -> Vec<Path> {
    run_traced(vertices, chain, &mut NoTrace)
}

/// [`run`] as a run that can be scrubbed.
pub fn play(vertices: Vec<[f32; 3]>, chain: Chain, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(&vertices, chain), budget, move |t| {
        run_traced(&vertices, &chain, t);
    })
}

/// The algorithm: [`run`] and [`play`] are this with two tracers.
pub fn run_traced<T: Tracer<Event>>(vertices: &[[f32; 3]], chain: &Chain, t: &mut T) -> Vec<Path> {
    let mut paths = Vec::with_capacity(vertices.len());
    for (&[x, y, z], vertex) in vertices.iter().zip(0..=u16::MAX) {
        t.emit(|| Event::Vertex { vertex });
        let object = [x, y, z, 1.0];
        let world = product(chain, Space::World, object, vertex, t);
        let view = product(chain, Space::View, world, vertex, t);
        let clip = product(chain, Space::Clip, view, vertex, t);
        t.emit(|| Event::Sight { vertex, w: clip[3] });
        let ndc = divide(clip);
        report(Space::Ndc, ndc, vertex, t);
        let screen = chain.viewport.to_screen(ndc);
        report(Space::Screen, screen, vertex, t);
        paths.push([object, world, view, clip, ndc, screen]);
    }
    t.emit(|| Event::Done);
    paths
}

/// One matrix product, row by row.
fn product<T: Tracer<Event>>(chain: &Chain, to: Space, v: [f32; 4], vertex: u16, t: &mut T) -> [f32; 4] {
    t.emit(|| Event::Matrix { vertex, to });
    let matrix = chain.matrix(to).unwrap_or(&matrices::IDENTITY);
    let mut out = [0.0; 4];
    for (row, value) in (0..4_u8).zip(&mut out) {
        *value = row_times(matrix, usize::from(row), v);
        t.emit(|| Event::Component { vertex, to, row, value: *value });
    }
    t.emit(|| Event::Reached { vertex, space: to });
    out
}

/// Reports a vertex in the space it has come to.
fn report<T: Tracer<Event>>(to: Space, v: [f32; 4], vertex: u16, t: &mut T) {
    if T::ENABLED {
        for (row, value) in (0..4_u8).zip(v) {
            t.emit(|| Event::Component { vertex, to, row, value });
        }
        t.emit(|| Event::Reached { vertex, space: to });
    }
}
