//! Pictures that the engine itself draws: meshes in object colours, seen by a camera of the tour.

use rasterscope_core::{
    cull::CullMode,
    explain::Mark,
    pipeline::{Frame, Skips, render},
    scene::{Clear, Draw, Geometry, Mesh, Scene, Shade},
    transform::{Camera, Projection},
};
use rasterscope_figure::{
    orbit::Orbit,
    theme::{Color, Theme},
};
use std::sync::Arc;

/// Pixels of a painted picture; shown at half this size, so that edges are smooth.
pub(super) const PAINTED: [u32; 2] = [1440, 960];

/// Triangles in one colour each.
#[derive(Debug, Default)]
pub(super) struct Paint {
    mesh: Mesh,
}

impl Paint {
    /// Adds a triangle; what is not finite is left out.
    pub(super) fn triangle(&mut self, corners: [[f32; 3]; 3], color: Color) {
        if corners.as_flattened().iter().any(|c| !c.is_finite()) {
            return;
        }
        let first = self.mesh.positions.len() as u32;
        self.mesh.positions.extend(corners);
        self.mesh.colors.extend([color.0.map(|code| f32::from(code) / 255.0); 3]);
        self.mesh.triangles.push([first, first + 1, first + 2]);
    }

    /// The picture, on the colour of the canvas.
    pub(super) fn seen(self, camera: Camera, shade: Shade, theme: &Theme) -> Mark {
        let draw = Draw { cull: CullMode::None, shade, ..Draw::new("", Geometry::Mesh(Arc::new(self.mesh))) };
        let color = theme.canvas.0.map(|code| f32::from(code) / 255.0);
        let clear = Clear { color, ..Clear::default() };
        image(&render(&Scene { clear, camera, draws: vec![draw], ..Scene::empty(PAINTED) }, &Skips::ALL))
    }
}

/// An image as a mark, opaque.
pub(crate) fn image(frame: &Frame) -> Mark {
    Mark::Image { size: frame.size.map(|side| side as usize), rgba: opaque(frame) }
}

/// The colours of an image, opaque.
pub(crate) fn opaque(frame: &Frame) -> Arc<Vec<u8>> {
    Arc::new(frame.color.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2], 255]).collect())
}

/// The camera that sees what an [`Orbit`] sees.
pub(super) fn orbit_camera(orbit: &Orbit) -> Camera {
    Camera {
        eye: orbit.eye(),
        target: orbit.target,
        near: orbit.distance * 0.02,
        far: orbit.distance * 20.0,
        projection: Projection::Perspective { fovy_degrees: 45.0 },
        ..Camera::default()
    }
}

/// From the plane of an [`Orbit`], half as high as 1, to the pixels of the picture.
pub(super) fn to_picture([x, y]: [f32; 2]) -> [f32; 2] {
    let [width, height] = PAINTED.map(|side| side as f32);
    [width / 2.0 + x * height / 2.0, height / 2.0 - y * height / 2.0]
}

/// A flat drawing, looked at straight: what part of a plane fills the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    center: [f32; 2],
    /// Height of the picture in units of the plane.
    height: f32,
    /// How far the geometry reaches in front of the plane and behind it.
    reach: f32,
}

impl Plane {
    /// Shows `min..=max` with some room around it.
    pub(super) fn around(min: [f32; 2], max: [f32; 2], reach: f32) -> Self {
        let [width, height] = PAINTED.map(|side| side as f32);
        let span = [max[0] - min[0], max[1] - min[1]];
        let fitting = span[1].max(span[0] * height / width) * 1.12;
        Self {
            center: [(min[0] + max[0]) / 2.0, (min[1] + max[1]) / 2.0],
            height: if fitting > 0.0 && fitting.is_finite() { fitting } else { 1.0 },
            reach: reach.clamp(1e-3, 1e18),
        }
    }

    /// Looks along -z.
    pub(super) fn camera(&self) -> Camera {
        let [x, y] = self.center;
        Camera {
            eye: [x, y, 2.0 * self.reach],
            target: [x, y, 0.0],
            near: 0.5 * self.reach,
            far: 4.0 * self.reach,
            projection: Projection::Orthographic { height: self.height },
            ..Camera::default()
        }
    }

    /// From the plane to the pixels of the picture.
    pub(super) fn to_picture(self, [x, y]: [f32; 2]) -> [f32; 2] {
        let [width, height] = PAINTED.map(|side| side as f32);
        let scale = height / self.height;
        [width / 2.0 + (x - self.center[0]) * scale, height / 2.0 - (y - self.center[1]) * scale]
    }
}
