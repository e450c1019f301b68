//! The bodies that a triangle is clipped against: what distance a vertex has from each plane.

use super::super::{Plane, distance_is_negative, distance_terms};
use crate::{
    math::Real,
    transform::{Camera, DepthRange, Matrix, Projection},
};

/// A body bounded by the six planes.
pub trait Region: Copy {
    /// The distance of a vertex from a plane as a sum of two terms; inside is `>= 0`, and the unit is
    /// that of the space, not a length. In binary64 the terms of binary32 vertices are exact.
    fn terms<R: Real>(&self, plane: Plane, vertex: [R; 4]) -> [R; 2];

    /// Whether a vertex lies strictly outside a plane; exact.
    #[inline]
    fn excludes(&self, plane: Plane, vertex: [f32; 4]) -> bool {
        let [a, b] = self.terms(plane, vertex.map(f64::from));
        a < -b
    }

    /// The distance in rounded arithmetic.
    #[inline]
    fn distance<R: Real>(&self, plane: Plane, vertex: [R; 4]) -> R {
        let [a, b] = self.terms(plane, vertex);
        a + b
    }
}

/// The visible part of clip space, or of NDC with w = 1; the sides may stand farther apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClipSpace {
    /// Which depths are visible.
    pub range: DepthRange,
    /// The sides are `-guard w <= x, y <= guard w`: a power of two, 1 for the visible part itself.
    pub guard: f32,
}

impl Region for ClipSpace {
    #[inline]
    fn terms<R: Real>(&self, plane: Plane, vertex: [R; 4]) -> [R; 2] {
        let [a, b] = distance_terms(plane, vertex, self.range);
        match plane {
            Plane::Near | Plane::Far => [a, b],
            _ => [a * R::from_f32(self.guard), b],
        }
    }

    #[inline]
    fn excludes(&self, plane: Plane, vertex: [f32; 4]) -> bool {
        if self.guard == 1.0 {
            return distance_is_negative(plane, vertex, self.range);
        }
        let [a, b] = self.terms(plane, vertex.map(f64::from));
        a < -b
    }
}

/// The visible part of camera space: the eye at the origin, looking along -z, y up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraSpace {
    /// What x and y are multiplied by on the way to clip space.
    pub scale: [f32; 2],
    /// Whether lines of sight meet in the eye.
    pub perspective: bool,
    /// Distance of the near plane.
    pub near: f32,
    /// Distance of the far plane.
    pub far: f32,
    /// As in [`ClipSpace`].
    pub guard: f32,
}

impl CameraSpace {
    /// What a camera with that projection matrix sees.
    pub fn new(camera: &Camera, projection: &Matrix, guard: f32) -> Self {
        Self {
            scale: [projection[0], projection[5]],
            perspective: matches!(camera.projection, Projection::Perspective { .. }),
            near: camera.near,
            far: camera.far,
            guard,
        }
    }
}

impl Region for CameraSpace {
    /// `(v - p) · n` with normals that are not of unit length: those of the sides are
    /// `(±scale, 0, -1)` and `(0, ±scale, -1)`, so that this is the distance in clip space.
    #[inline]
    fn terms<R: Real>(&self, plane: Plane, [x, y, z, _]: [R; 4]) -> [R; 2] {
        let [x, y] = [x * R::from_f32(self.scale[0]), y * R::from_f32(self.scale[1])];
        let w = if self.perspective { -z } else { R::ONE };
        let side = w * R::from_f32(self.guard);
        match plane {
            Plane::Left => [side, x],
            Plane::Right => [side, -x],
            Plane::Bottom => [side, y],
            Plane::Top => [side, -y],
            Plane::Near => [-z, -R::from_f32(self.near)],
            Plane::Far => [R::from_f32(self.far), z],
        }
    }
}
