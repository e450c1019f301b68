//! A camera that looks at a scene from outside: world-space geometry as marks of a plane.
//!
//! The 3D stages show the frustum and the triangles in it from a point of their own. Coordinates of
//! the world are right-handed with y up; those of the picture have y up, the target at (0, 0) and
//! a half height of 1 at the edge of a 45 degree field of view, so a
//! [`View::SPACE`](rasterscope_core::explain::View::SPACE) frames what is around the target.

use glam::{DMat3, DVec3};
use rasterscope_core::explain::Vantage;
pub use rasterscope_core::transform::frustum::{FRUSTUM_EDGES, FRUSTUM_FACES, frustum_corners};

/// What is nearer to the eye than this share of the distance to the target is cut off.
const NEAR: f64 = 0.02;
/// Tangent of half the field of view, 22.5 degrees.
const TANGENT: f64 = std::f64::consts::SQRT_2 - 1.0;
/// How much of the picture's half height is filled at first.
const FILLED: f32 = 0.92;
/// How much wider than high a canvas is at least.
const WIDE: f32 = 1.05;
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

    /// [`framing`](Self::framing), and then as near as shows all of `points` in a picture that is `wide`
    /// times as wide as high: the sphere round them leaves room.
    pub fn filling(points: &[[f32; 3]], yaw: f32, pitch: f32, wide: f32) -> Self {
        let mut orbit = Self::framing(points, yaw, pitch);
        let farthest = orbit.distance * 1.5;
        for _ in 0..3 {
            let seen = points.iter().filter_map(|&point| orbit.project(point));
            let bounds = seen.fold(None, |bounds: Option<[[f32; 2]; 2]>, [x, y]| {
                let [low, high] = bounds.unwrap_or([[x, y]; 2]);
                Some([[low[0].min(x), low[1].min(y)], [high[0].max(x), high[1].max(y)]])
            });
            let [low, high] = bounds.unwrap_or_default();
            orbit = orbit.moved([0, 1].map(|axis| (low[axis] + high[axis]) / 2.0));
            // The nearest distance from which all is seen, by halving.
            let [mut too_near, mut far] = [0.0, farthest];
            for _ in 0..16 {
                let middle = (too_near + far) / 2.0;
                let at = Self { distance: middle, ..orbit };
                let all = points.iter().filter(|p| p.iter().all(|c| c.is_finite())).all(|&point| {
                    at.project(point).is_some_and(|[x, y]| (x.abs() / wide).max(y.abs()) <= FILLED)
                });
                if all { far = middle } else { too_near = middle }
            }
            orbit.distance = far;
        }
        orbit
    }

    /// The camera with which a drawing in space is seen first.
    pub fn first(vantage: &Vantage) -> Self {
        Self::filling(&vantage.points, vantage.yaw, vantage.pitch, WIDE)
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

    /// A point of the picture as a point in space, at that [`depth`](Self::depth): what a pointer means
    /// in the plane that is parallel to the picture there.
    pub fn unproject(&self, [x, y]: [f32; 2], depth: f32) -> [f32; 3] {
        let [right, up, back] = self.axes();
        let size = f64::from(depth) * TANGENT;
        let middle = wide(self.target) + back * f64::from(self.distance - depth);
        (middle + (right * f64::from(x) + up * f64::from(y)) * size).as_vec3().to_array()
    }

    /// Right, up and backwards of the camera.
    pub(crate) fn axes(&self) -> [DVec3; 3] {
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

pub(crate) fn wide(p: [f32; 3]) -> DVec3 {
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
    fn a_pointer_leads_back_to_the_point_under_it() {
        let orbit = Orbit::framing(&CUBE, 0.7, 0.4);
        let p = [0.3, -0.8, 0.5];
        let back = orbit.unproject(orbit.project(p).unwrap(), orbit.depth(p));
        assert!((0..3).all(|axis| (back[axis] - p[axis]).abs() < 1e-5), "{back:?}");
    }

    #[test]
    fn filling_shows_all_points_and_leaves_little_room() {
        for points in [&CUBE[..], &[[0.0; 3], [9.0, 0.1, 0.0], [0.0, 0.0, 0.2]]] {
            let orbit = Orbit::filling(points, 0.9, 0.3, 1.0);
            let most =
                points.iter().flat_map(|&p| orbit.project(p).unwrap()).map(f32::abs).fold(0.0, f32::max);
            assert!((0.75..=1.0).contains(&most), "{most}");
        }
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
