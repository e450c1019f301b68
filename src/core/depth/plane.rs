//! The depth of a triangle at any pixel: it is a plane over the screen.
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 15.4. Deviation:
//! in exact arithmetic nothing is added from pixel to pixel; the value is the exact quotient.

use super::DepthFormat;
use crate::{
    interpolate::Barycentric,
    math::{Arithmetic, Real, Tally},
    raster::{edge::centre, snap},
};

/// A triangle's depth, set up once for all its pixels.
#[derive(Clone, Copy, Debug)]
pub struct DepthPlane {
    z: [f32; 3],
    form: Form,
}

#[derive(Clone, Copy, Debug)]
enum Form {
    /// Zero area, which covers nothing.
    None,
    Exact(Barycentric),
    F32(Slopes<f32>),
    F64(Slopes<f64>),
}

impl DepthPlane {
    /// From vertices (x, y, z): x and y in pixels, z in the depth range; any finite numbers,
    /// either winding. `F32` and `F64` use the slopes dz/dx and dz/dy as taught; `Fixed8` snaps x
    /// and y to 1/256 pixel and is exact then. A zero area has the depth of its first vertex.
    pub fn new(vertices: [[f32; 3]; 3], arithmetic: Arithmetic, tally: &mut Tally) -> Self {
        let mut points = vertices.map(|[x, y, _]| [x, y]);
        if arithmetic == Arithmetic::Fixed8 {
            points = points.map(|point| point.map(snap));
        }
        let form = match (Barycentric::new(points, tally), arithmetic) {
            (None, _) => Form::None,
            (Some(triangle), Arithmetic::Exact | Arithmetic::Fixed8) => Form::Exact(triangle),
            (Some(_), Arithmetic::F32) => Form::F32(Slopes::new(vertices)),
            (Some(_), Arithmetic::F64) => Form::F64(Slopes::new(vertices)),
        };
        Self { z: vertices.map(|[_, _, z]| z), form }
    }

    /// The depth at the centre of a pixel: correctly rounded, within the vertices' range.
    #[inline]
    pub fn depth(&self, [x, y]: [u32; 2], tally: &mut Tally) -> f32 {
        let [a, b, c] = self.z;
        if a.to_bits() == b.to_bits() && b.to_bits() == c.to_bits() {
            return a;
        }
        let point = centre(x, y);
        let rounded = match &self.form {
            Form::None => return a,
            Form::Exact(triangle) => return triangle.at(point, tally).value(self.z, tally),
            Form::F32(slopes) => slopes.depth(point),
            Form::F64(slopes) => slopes.depth(point),
        };
        // Not `clamp`, which would panic on NaN: the taught slopes of a sliver can be.
        rounded.max(a.min(b).min(c)).min(a.max(b).max(c))
    }

    /// The code of the depth at the centre of a pixel: the exact value rounded once to the
    /// format, clamped to 0..1 if it is a unorm format.
    #[inline]
    pub fn code(&self, [x, y]: [u32; 2], format: DepthFormat, tally: &mut Tally) -> u32 {
        match (&self.form, format.max_code()) {
            (Form::Exact(triangle), Some(max)) => triangle.at(centre(x, y), tally).code(self.z, max, tally),
            _ => format.encode(self.depth([x, y], tally)),
        }
    }
}

/// The plane as taught: `z = z0 + dz/dx (x - x0) + dz/dy (y - y0)`.
#[derive(Clone, Copy, Debug)]
struct Slopes<R> {
    start: [R; 3],
    dz_dx: R,
    dz_dy: R,
}

impl<R: Real> Slopes<R> {
    fn new(vertices: [[f32; 3]; 3]) -> Self {
        let [[x0, y0, z0], [x1, y1, z1], [x2, y2, z2]] = vertices.map(|vertex| vertex.map(R::from_f32));
        let [[ax, ay, az], [bx, by, bz]] = [[x1 - x0, y1 - y0, z1 - z0], [x2 - x0, y2 - y0, z2 - z0]];
        // The plane's normal (A, B, C) is the cross product; z' = -A / C for the next pixel.
        let area = ax * by - bx * ay;
        Self { start: [x0, y0, z0], dz_dx: (az * by - bz * ay) / area, dz_dy: (bz * ax - az * bx) / area }
    }

    fn depth(&self, [x, y]: [f32; 2]) -> f32 {
        let [x0, y0, z0] = self.start;
        (z0 + self.dz_dx * (R::from_f32(x) - x0) + self.dz_dy * (R::from_f32(y) - y0)).to_f32()
    }
}
