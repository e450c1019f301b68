//! A scene around one model.

use super::document::{DEFAULT_COLOR, Draw, Geometry, Mesh, Scene, Shade, Transform};
use crate::{
    cull::CullMode,
    transform::{Camera, Projection},
};
use std::{collections::HashSet, sync::Arc};

/// The size in pixels of a scene made from a model.
pub const MODEL_SIZE: [u32; 2] = [1280, 720];

/// Vertical field of view in degrees.
const FOVY_DEGREES: f32 = 45.0;

/// From where the model is seen: from the front, a little from the right and above.
const DIRECTION: [f64; 3] = [0.35, 0.35, 1.0];

/// A scene that shows the whole of `mesh`, which was read from `file`, on `size` pixels.
///
/// The camera's distance is such that the sphere about the bounding box touches the nearer pair
/// of side planes; near and far are tight about that sphere. A model without colours is shaded
/// flat, to be readable; one near the ends of binary32 is scaled. Back faces are culled only if the mesh is closed and turns one way
/// throughout: only then culling cannot change the image. Cost: linear.
pub fn scene_from_obj(file: &str, mesh: Mesh, size: [u32; 2]) -> Scene {
    let plain = mesh.colors.iter().all(|color| *color == DEFAULT_COLOR);
    let bounds = Bounds::of(&mesh.positions);
    let scale = bounds.scale();
    let camera = bounds.scaled(scale).camera(size);
    let cull = if is_closed(&mesh) { CullMode::Back } else { CullMode::None };
    let model = Geometry::Model { file: file.into(), color: None, mesh: Some(Arc::new(mesh)) };
    let draw = Draw {
        transform: Transform::Parts { translate: [0.0; 3], rotate_degrees: [0.0; 3], scale: [scale; 3] },
        cull,
        shade: if plain { Shade::Flat } else { Shade::None },
        ..Draw::new(file, model)
    };
    Scene { name: file.into(), camera, draws: vec![draw], ..Scene::empty(size) }
}

/// The sphere about the bounding box, in binary64.
#[derive(Clone, Copy)]
struct Bounds {
    center: [f64; 3],
    radius: f64,
}

impl Bounds {
    fn of(positions: &[[f32; 3]]) -> Self {
        let range = |i: usize| {
            let values = positions.iter().map(|p| f64::from(p[i]));
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
        };
        let sides = if positions.is_empty() { [(0.0, 0.0); 3] } else { [0, 1, 2].map(range) };
        let half = sides.map(|(low, high)| (high - low) / 2.0);
        Self { center: sides.map(|(low, high)| (low + high) / 2.0), radius: length(half) }
    }

    /// The farthest coordinate of the centre from the origin.
    fn reach(&self) -> f64 {
        self.center.iter().fold(0.0, |most, x| most.max(x.abs()))
    }

    /// A power of two that brings sizes near the ends of binary32 to where a camera has room.
    fn scale(&self) -> f32 {
        const FAR_OUT: f64 = 1e18;
        match self.reach() + self.radius {
            size if size > FAR_OUT => libm::ldexpf(1.0, -100),
            size if size > 0.0 && size < 1.0 / FAR_OUT => libm::ldexpf(1.0, 100),
            _ => 1.0,
        }
    }

    fn scaled(&self, scale: f32) -> Self {
        let scale = f64::from(scale);
        Self { center: self.center.map(|x| x * scale), radius: self.radius * scale }
    }

    /// A camera that sees the whole sphere, for an image of `size` pixels.
    fn camera(&self, size: [u32; 2]) -> Camera {
        // A point still has a size; and eye and target stay apart when rounded to binary32, so
        // far from the origin the model may be.
        let radius = match (self.radius, self.reach()) {
            (0.0, 0.0) => 1.0,
            (radius, reach) => radius.max(reach * 1e-5),
        };
        let half_fovy = f64::from(FOVY_DEGREES).to_radians() / 2.0;
        let aspect = f64::from(size[0].max(1)) / f64::from(size[1].max(1));
        let half_fovx = libm::atan(libm::tan(half_fovy) * aspect);
        let distance = radius / libm::sin(half_fovy.min(half_fovx));
        let step = distance / length(DIRECTION);
        #[expect(clippy::cast_possible_truncation, reason = "rounded once, well within binary32")]
        let round = |x: f64| x as f32;
        Camera {
            eye: [0, 1, 2].map(|i| round(self.center[i] + step * DIRECTION[i])),
            target: self.center.map(round),
            up: [0.0, 1.0, 0.0],
            near: round((distance - radius) * 0.99),
            far: round((distance + radius) * 1.01),
            projection: Projection::Perspective { fovy_degrees: FOVY_DEGREES },
        }
    }
}

fn length(v: [f64; 3]) -> f64 {
    libm::sqrt(v.iter().map(|x| x * x).sum())
}

/// Whether every edge is passed once in each direction, vertices being the same where their
/// positions are, and the volume enclosed is positive: front faces turn counter-clockwise
/// outside, and no back face can be seen from there.
fn is_closed(mesh: &Mesh) -> bool {
    let position = |index: u32| {
        // Adding zero makes -0 and 0 the same point.
        usize::try_from(index).ok().and_then(|i| mesh.positions.get(i)).map(|p| p.map(|x| x + 0.0))
    };
    let mut edges = HashSet::with_capacity(3 * mesh.triangles.len());
    let mut volume = 0.0;
    for &[a, b, c] in &mesh.triangles {
        let (Some(a), Some(b), Some(c)) = (position(a), position(b), position(c)) else { return false };
        if a == b || b == c || c == a {
            continue; // drawn nowhere, and its edges cancel out
        }
        let [u, v, w] = [a, b, c].map(|p| p.map(f64::from));
        volume += u[0] * (v[1] * w[2] - v[2] * w[1])
            + u[1] * (v[2] * w[0] - v[0] * w[2])
            + u[2] * (v[0] * w[1] - v[1] * w[0]);
        for (from, to) in [(a, b), (b, c), (c, a)] {
            if !edges.insert((from.map(f32::to_bits), to.map(f32::to_bits))) {
                return false;
            }
        }
    }
    volume > 0.0 && edges.iter().all(|&(from, to)| edges.contains(&(to, from)))
}
