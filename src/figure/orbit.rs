//! A camera that looks at a scene from outside: world-space geometry as marks of a plane.
//!
//! The 3D stages show the frustum and the triangles in it from a point of their own. Coordinates of
//! the world are right-handed with y up; those of the picture have y up, the target at (0, 0) and
//! a half height of 1 at the edge of a 45 degree field of view, so a [`View`] of (-1, -1) to (1, 1)
//! frames what is around the target.

use glam::{DMat3, DVec3};
use rasterscope_core::explain::{Grid, View};
pub use rasterscope_core::transform::frustum::{FRUSTUM_EDGES, FRUSTUM_FACES, frustum_corners};

/// What is nearer to the eye than this share of the distance to the target is cut off.
const NEAR: f64 = 0.02;
/// Tangent of half the field of view, 22.5 degrees.
const TANGENT: f64 = std::f64::consts::SQRT_2 - 1.0;
/// Sine of the same angle.
const SINE: f64 = 0.382_683_432_365_089_8;

/// A camera on a sphere around a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    /// Angle around the vertical axis in radians; 0: the eye is on the +z side, growing to +x.
    pub yaw: f32,
    /// Angle above the horizon in radians; it stays between both poles.
    pub pitch: f32,
    /// From the eye to the target, positive.
    pub distance: f32,
    /// What is looked at.
    pub target: [f32; 3],
}

impl Orbit {
    /// Sees all of `points` from the given direction; some default if there is none that is finite.
    pub fn framing(points: &[[f32; 3]], yaw: f32, pitch: f32) -> Self {
        let finite = || points.iter().filter(|p| p.iter().all(|c| c.is_finite())).map(|&p| wide(p));
        let low = finite().reduce(DVec3::min).unwrap_or(DVec3::NEG_ONE);
        let high = finite().reduce(DVec3::max).unwrap_or(DVec3::ONE);
        let radius = ((high - low).length() / 2.0).max(1e-6);
        let distance = radius / SINE * 1.05;
        let target = ((low + high) / 2.0).as_vec3().to_array();
        Self { yaw, pitch, distance: distance as f32, target }.turned(0.0, 0.0)
    }

    /// Turned by these angles; the eye never passes a pole.
    #[must_use]
    pub fn turned(self, yaw: f32, pitch: f32) -> Self {
        let pole = 1.55;
        let turn = std::f32::consts::TAU;
        Self { yaw: (self.yaw + yaw) % turn, pitch: (self.pitch + pitch).clamp(-pole, pole), ..self }
    }

    /// `factor` times nearer.
    #[must_use]
    pub fn nearer(self, factor: f32) -> Self {
        let distance = self.distance / factor.max(1e-3);
        Self { distance: distance.clamp(1e-6, 1e12), ..self }
    }

    /// The target moved in the plane of the picture, by units of the picture.
    #[must_use]
    pub fn moved(self, by: [f32; 2]) -> Self {
        let [right, up, _] = self.axes();
        let size = f64::from(self.distance) * TANGENT;
        let target = wide(self.target) + (right * f64::from(by[0]) + up * f64::from(by[1])) * size;
        Self { target: target.as_vec3().to_array(), ..self }
    }

    /// Where the eye is.
    pub fn eye(&self) -> [f32; 3] {
        (wide(self.target) + self.axes()[2] * f64::from(self.distance)).as_vec3().to_array()
    }

    /// A point of the picture; `None` if it is behind the eye or too near.
    pub fn project(&self, p: [f32; 3]) -> Option<[f32; 2]> {
        self.flat(self.seen(p)?)
    }

    /// The part of a segment in front of the eye.
    pub fn segment(&self, a: [f32; 3], b: [f32; 3]) -> Option<[[f32; 2]; 2]> {
        let [a, b] = self.in_front([self.seen(a)?, self.seen(b)?])?;
        Some([self.flat(a)?, self.flat(b)?])
    }

    /// The part of a polygon in front of the eye; empty if there is none.
    pub fn polygon(&self, points: &[[f32; 3]]) -> Vec<[f32; 2]> {
        let Some(points) = points.iter().map(|&p| self.seen(p)).collect::<Option<Vec<_>>>() else {
            return Vec::new();
        };
        let near = self.near();
        let mut kept = Vec::with_capacity(points.len() + 2);
        for (i, &to) in points.iter().enumerate() {
            let from = points[(i + points.len() - 1) % points.len()];
            if (from.z >= near) != (to.z >= near) {
                kept.push(cut(from, to, near));
            }
            if to.z >= near {
                kept.push(to);
            }
        }
        kept.into_iter().filter_map(|p| self.flat(p)).collect()
    }

    /// How far in front of the eye a point is; for sorting back to front.
    pub fn depth(&self, p: [f32; 3]) -> f32 {
        self.seen(p).map_or(f32::INFINITY, |seen| seen.z as f32)
    }

    /// A view of the plane in which the target is in the middle.
    pub fn view(&self) -> View {
        View { min: [-1.0, -1.0], max: [1.0, 1.0], y_up: true, grid: Grid::None }
    }

    /// Right, up and backwards of the camera.
    fn axes(&self) -> [DVec3; 3] {
        let turn = DMat3::from_rotation_y(self.yaw.into()) * DMat3::from_rotation_x(-f64::from(self.pitch));
        [turn.x_axis, turn.y_axis, turn.z_axis]
    }

    /// In camera space: x to the right, y up, z into the picture.
    fn seen(&self, p: [f32; 3]) -> Option<DVec3> {
        let [right, up, back] = self.axes();
        let from_eye = wide(p) - wide(self.target) - back * f64::from(self.distance);
        let seen = DVec3::new(from_eye.dot(right), from_eye.dot(up), -from_eye.dot(back));
        seen.is_finite().then_some(seen)
    }

    fn near(&self) -> f64 {
        NEAR * f64::from(self.distance)
    }

    fn in_front(&self, [a, b]: [DVec3; 2]) -> Option<[DVec3; 2]> {
        let near = self.near();
        match (a.z >= near, b.z >= near) {
            (true, true) => Some([a, b]),
            (true, false) => Some([a, cut(a, b, near)]),
            (false, true) => Some([cut(a, b, near), b]),
            (false, false) => None,
        }
    }

    fn flat(&self, seen: DVec3) -> Option<[f32; 2]> {
        let size = seen.z * TANGENT;
        (seen.z >= self.near() * (1.0 - 1e-9)).then(|| [seen.x / size, seen.y / size].map(|c| c as f32))
    }
}

fn wide(p: [f32; 3]) -> DVec3 {
    DVec3::from_array(p.map(f64::from))
}

/// Where a segment crosses the plane `z = near`.
fn cut(a: DVec3, b: DVec3, near: f64) -> DVec3 {
    let mut cut = a.lerp(b, (near - a.z) / (b.z - a.z));
    cut.z = near;
    cut
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUBE: [[f32; 3]; 2] = [[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]];

    #[test]
    fn right_is_right_and_up_is_up() {
        let orbit = Orbit::framing(&CUBE, 0.0, 0.3);
        let [x, y] = orbit.project([0.0; 3]).unwrap();
        assert!(x.abs() < 1e-6 && y.abs() < 1e-6);
        assert!(orbit.project([1.0, 0.0, 0.0]).unwrap()[0] > 0.1);
        assert!(orbit.project([0.0, 1.0, 0.0]).unwrap()[1] > 0.1);
        assert!(orbit.eye()[2] > 0.0 && orbit.eye()[1] > 0.0);
        assert!(orbit.turned(1.0, 0.0).eye()[0] > 0.0);
    }

    #[test]
    fn framing_shows_every_corner_from_every_side() {
        for i in 0..40 {
            let orbit = Orbit::framing(&CUBE, i as f32 * 0.4, i as f32 * 0.1 - 2.0);
            for corner in 0..8 {
                let p = [0, 1, 2].map(|axis| if corner >> axis & 1 == 0 { -1.0 } else { 1.0 });
                let flat = orbit.project(p).unwrap();
                assert!(flat.iter().all(|c| c.abs() <= 1.0), "{flat:?}");
            }
        }
    }

    #[test]
    fn what_is_behind_the_eye_is_cut_off() {
        let orbit = Orbit { yaw: 0.0, pitch: 0.0, distance: 5.0, target: [0.0; 3] };
        assert_eq!(orbit.project([0.0, 0.0, 6.0]), None);
        let [a, b] = orbit.segment([1.0, 0.0, 0.0], [1.0, 0.0, 20.0]).unwrap();
        assert!(b[0] > a[0] && b[0].is_finite());
        assert_eq!(orbit.segment([0.0, 0.0, 6.0], [0.0, 0.0, 9.0]), None);
        let polygon = orbit.polygon(&[[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, -1.0, 20.0]]);
        assert_eq!(polygon.len(), 4);
        assert!(orbit.polygon(&[[0.0, 0.0, 6.0], [1.0, 0.0, 7.0], [0.0, 1.0, 8.0]]).is_empty());
        assert!(orbit.polygon(&[[f32::NAN; 3]; 3]).is_empty());
        assert!(orbit.depth([0.0; 3]) < orbit.depth([0.0, 0.0, -1.0]));
    }

    #[test]
    fn moving_follows_the_hand() {
        let orbit = Orbit::framing(&CUBE, 0.7, 0.4);
        let moved = orbit.moved([0.25, -0.5]);
        let [x, y] = moved.project(orbit.target).unwrap();
        assert!((x + 0.25).abs() < 1e-5 && (y - 0.5).abs() < 1e-5);
        assert!(orbit.nearer(2.0).distance < orbit.distance);
    }
}
