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

/// The part of the image that the model fills, across or upright.
const FILLED: f64 = 0.9;

/// From where the model is seen: from the front, a little from the right and above.
const DIRECTION: [f64; 3] = [0.35, 0.35, 1.0];

/// A scene that shows the whole of `mesh`, which was read from `file`, on `size` pixels.
///
/// The camera is as near as it can be with some margin; near and far enclose the sphere about the
/// bounding box, so that the model can be turned. A model without colours is shaded
/// flat, to be readable; one near the ends of binary32 is scaled. Back faces are culled only if the mesh is closed and turns one way
/// throughout: only then culling cannot change the image. Cost: linear.
pub fn scene_from_obj(file: &str, mesh: Mesh, size: [u32; 2]) -> Scene {
    let plain = mesh.colors.iter().all(|color| *color == DEFAULT_COLOR);
    let bounds = Bounds::of(&mesh.positions);
    let scale = bounds.scale();
    let camera = bounds.scaled(scale).camera(&mesh.positions, scale, size);
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

    /// A camera that sees all `positions` times `scale`, for an image of `size` pixels.
    fn camera(&self, positions: &[[f32; 3]], scale: f32, size: [u32; 2]) -> Camera {
        // A point still has a size; and eye and target stay apart when rounded to binary32, so
        // far from the origin the model may be.
        let radius = match (self.radius, self.reach()) {
            (0.0, 0.0) => 1.0,
            (radius, reach) => radius.max(reach * 1e-5),
        };
        let toward_eye = DIRECTION.map(|x| x / length(DIRECTION));
        let right = cross([0.0, 1.0, 0.0], toward_eye);
        let right = right.map(|x| x / length(right));
        let up = cross(toward_eye, right);
        let half_height = FILLED * libm::tan(f64::from(FOVY_DEGREES).to_radians() / 2.0);
        let half_width = half_height * f64::from(size[0].max(1)) / f64::from(size[1].max(1));
        // From this far, the vertex stands at the margin of the image.
        let needed = |p: &[f32; 3]| {
            let from_center = [0, 1, 2].map(|i| f64::from(p[i]) * f64::from(scale) - self.center[i]);
            let across = (dot(from_center, right) / half_width).abs();
            across.max((dot(from_center, up) / half_height).abs()) + dot(from_center, toward_eye)
        };
        let distance = positions.iter().map(needed).fold(1.1 * radius, f64::max);
        #[expect(clippy::cast_possible_truncation, reason = "rounded once, well within binary32")]
        let round = |x: f64| x as f32;
        Camera {
            eye: [0, 1, 2].map(|i| round(self.center[i] + distance * toward_eye[i])),
            target: self.center.map(round),
            up: [0.0, 1.0, 0.0],
            near: round((distance - radius) * 0.99),
            far: round((distance + radius) * 1.01),
            projection: Projection::Perspective { fovy_degrees: FOVY_DEGREES },
        }
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(v: [f64; 3]) -> f64 {
    libm::sqrt(dot(v, v))
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
        volume += dot(u, cross(v, w));
        for (from, to) in [(a, b), (b, c), (c, a)] {
            if !edges.insert((from.map(f32::to_bits), to.map(f32::to_bits))) {
                return false;
            }
        }
    }
    volume > 0.0 && edges.iter().all(|&(from, to)| edges.contains(&(to, from)))
}
