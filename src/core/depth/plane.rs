//! The depth of a triangle at any pixel: it is a plane over the screen.
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 15.4. Deviation:
//! in exact arithmetic nothing is added from pixel to pixel; the value is the exact quotient.

use super::{DepthFormat, DepthPlacement, bias::Offset};
use crate::{
    interpolate::barycentric::determinant,
    math::{Approx, Arithmetic, Dyadic, Real, Tally, edge_value, orient2d, rounded_code, rounded_ratio},
    raster::edge::centre,
};

/// A triangle's depth, set up once for all its pixels.
#[derive(Clone, Copy, Debug)]
pub struct DepthPlane {
    form: Form,
    /// The least and the greatest depth of the vertices.
    range: [f32; 2],
    /// What is added, unless depths are those of the plane.
    offset: Option<Offset>,
}

#[derive(Clone, Copy, Debug)]
enum Form {
    /// All depths are equal, or there is no area and nothing to cover.
    Constant(f32),
    Exact(Plane),
    F32(Slopes<f32>),
    F64(Slopes<f64>),
}

impl DepthPlane {
    /// From vertices (x, y, z): x and y in pixels, z in the depth range; any finite numbers,
    /// either winding. `F32` and `F64` use the slopes dz/dx and dz/dy as taught; fixed point
    /// snaps x and y and is exact then. A zero area has the depth of its first vertex.
    pub fn new(mut vertices: [[f32; 3]; 3], arithmetic: Arithmetic, tally: &mut Tally) -> Self {
        vertices = vertices.map(|[x, y, z]| [arithmetic.snap(x), arithmetic.snap(y), z]);
        let [a, b, c] = vertices.map(|[_, _, z]| z);
        let form = if a.to_bits() == b.to_bits() && b.to_bits() == c.to_bits() || !has_area(vertices, tally) {
            Form::Constant(a)
        } else {
            match arithmetic {
                Arithmetic::F32 => Form::F32(Slopes::new(vertices)),
                Arithmetic::F64 => Form::F64(Slopes::new(vertices)),
                _ => Form::Exact(Plane::new(vertices)),
            }
        };
        Self { form, range: [a.min(b).min(c), a.max(b).max(c)], offset: None }
    }

    /// The same with a bias, for codes in that format; depths are kept in 0..=1 then.
    #[must_use]
    pub fn placed(self, placement: &DepthPlacement, format: DepthFormat) -> Self {
        if placement.is_plain() {
            return self;
        }
        let steepest = self.nearly_steepest();
        Self { offset: Some(Offset::new(placement.bias, format, self.greatest(), steepest)), ..self }
    }

    /// The greater magnitude of dz/dx and dz/dy; in binary64, to be shown.
    pub fn steepest(&self) -> f64 {
        self.nearly_steepest().value
    }

    /// The greatest magnitude of the vertices' depths.
    pub fn greatest(&self) -> f32 {
        self.range[0].abs().max(self.range[1].abs())
    }

    fn nearly_steepest(&self) -> Approx {
        match &self.form {
            Form::Constant(_) => Approx::exact(0.0),
            Form::Exact(plane) => plane.steepest(),
            // To be shown only: the sum is made in their own arithmetic.
            Form::F32(slopes) => Approx::exact(slopes.steepest().into()),
            Form::F64(slopes) => Approx::exact(slopes.steepest()),
        }
    }

    /// What is added to the plane's depths; in binary64, to be shown.
    pub fn bias(&self) -> f64 {
        self.offset.map_or(0.0, |offset| offset.shown())
    }

    /// The depth at the centre of a pixel: correctly rounded, and within the vertices' range also
    /// where rounded coverage strays outside the triangle.
    #[inline]
    pub fn depth(&self, [x, y]: [u32; 2], tally: &mut Tally) -> f32 {
        self.depth_at(centre(x, y), tally)
    }

    /// [`depth`](Self::depth) at any point, such as a sample of a pixel.
    #[inline]
    pub fn depth_at(&self, point: [f32; 2], tally: &mut Tally) -> f32 {
        match (&self.form, &self.offset) {
            (Form::Constant(z), None) => *z,
            (Form::Constant(_) | Form::Exact(_), _) => {
                rounded_ratio(self.nearly(point), || self.exactly(point), tally)
            }
            (Form::F32(slopes), offset) => slopes.within(point, self.range, offset.as_ref()),
            (Form::F64(slopes), offset) => slopes.within(point, self.range, offset.as_ref()),
        }
    }

    /// The depth of a form without a rounding, with its bias; nearly.
    #[inline]
    fn nearly(&self, point: [f32; 2]) -> Approx {
        let depth = match &self.form {
            Form::Constant(z) => Approx::from(*z),
            Form::Exact(plane) => plane.at(point, self.range),
            Form::F32(_) | Form::F64(_) => Approx::UNKNOWN,
        };
        self.offset.map_or(depth, |offset| offset.at(depth))
    }

    /// The same as a quotient.
    #[cold]
    fn exactly(&self, point: [f32; 2]) -> (Dyadic, Dyadic) {
        let (depth, steepest) = match &self.form {
            Form::Exact(plane) => (plane.exact(point, self.range), plane.exact_steepest()),
            // The taught forms round by themselves and never come here.
            Form::Constant(_) | Form::F32(_) | Form::F64(_) => {
                ((Dyadic::from(self.range[0]), Dyadic::one()), Dyadic::zero())
            }
        };
        match self.offset {
            Some(offset) => offset.exact(depth, steepest),
            None => depth,
        }
    }

    /// The code of the depth at the centre of a pixel: the exact value rounded once to the
    /// format, clamped to 0..1 if it is a unorm format.
    #[inline]
    pub fn code(&self, [x, y]: [u32; 2], format: DepthFormat, tally: &mut Tally) -> u32 {
        self.code_at(centre(x, y), format, tally)
    }

    /// [`code`](Self::code) at any point, such as a sample of a pixel.
    #[inline]
    pub fn code_at(&self, point: [f32; 2], format: DepthFormat, tally: &mut Tally) -> u32 {
        match (&self.form, &self.offset, format.max_code()) {
            (Form::Exact(_), _, Some(max)) | (Form::Constant(_), Some(_), Some(max)) => {
                rounded_code(self.nearly(point), max, || self.exactly(point), tally)
            }
            _ => format.encode(self.depth_at(point, tally)),
        }
    }
}

fn has_area(vertices: [[f32; 3]; 3], tally: &mut Tally) -> bool {
    let [a, b, c] = vertices.map(|[x, y, _]| [x, y]);
    !orient2d(a, b, c, tally).is_zero()
}

/// The plane through three vertices, with proven errors: its normal's components are the
/// determinants of the vertices seen along each axis.
#[derive(Clone, Copy, Debug)]
struct Plane {
    vertices: [[f32; 3]; 3],
    dz_dx: Approx,
    dz_dy: Approx,
}

impl Plane {
    fn new(vertices: [[f32; 3]; 3]) -> Self {
        let [xy, zy, xz] = Self::along_axes(vertices).map(|[a, b, c]| edge_value(a, b, c));
        Self { vertices, dz_dx: zy / xy, dz_dy: xz / xy }
    }

    /// The triangle in the planes xy, zy and xz.
    fn along_axes(vertices: [[f32; 3]; 3]) -> [[[f32; 2]; 3]; 3] {
        [vertices.map(|[x, y, _]| [x, y]), vertices.map(|[_, y, z]| [z, y]), vertices.map(|[x, _, z]| [x, z])]
    }

    /// The depth at a point, kept within a range: that leaves no error beyond it, either.
    #[inline]
    fn at(&self, [x, y]: [f32; 2], [least, greatest]: [f32; 2]) -> Approx {
        /// Both offsets, products and sums round once each: 4u, and some for the bound itself.
        const ROUNDINGS: f64 = 3.0 * f64::EPSILON;
        let [x0, y0, z0] = self.vertices[0].map(f64::from);
        let (dx, dy) = (f64::from(x) - x0, f64::from(y) - y0);
        let (along_x, along_y) = (self.dz_dx.value * dx, self.dz_dy.value * dy);
        let size = z0.abs() + along_x.abs() + along_y.abs();
        // The slopes' errors are doubled for the roundings of their own products.
        let inherited = self.dz_dx.error * dx.abs() + self.dz_dy.error * dy.abs();
        Approx {
            value: (z0 + along_x + along_y).max(least.into()).min(greatest.into()),
            error: 2.0 * inherited + ROUNDINGS * size + f64::MIN_POSITIVE,
        }
    }

    /// The greater magnitude of both slopes.
    fn steepest(&self) -> Approx {
        let [x, y] = [self.dz_dx, self.dz_dy];
        Approx { value: x.value.abs().max(y.value.abs()), error: x.error.max(y.error) }
    }

    /// The same over the denominator of [`exact`](Self::exact).
    #[cold]
    fn exact_steepest(&self) -> Dyadic {
        let [_, zy, xz] = Self::along_axes(self.vertices).map(|[a, b, c]| determinant(a, b, c));
        zy.abs().max(xz.abs())
    }

    /// The same as a quotient, without a rounding.
    #[cold]
    fn exact(&self, [x, y]: [f32; 2], range: [f32; 2]) -> (Dyadic, Dyadic) {
        let [xy, zy, xz] = Self::along_axes(self.vertices).map(|[a, b, c]| determinant(a, b, c));
        let [x0, y0, z0] = self.vertices[0].map(Dyadic::from);
        let above = z0 * &xy + zy * (Dyadic::from(x) - x0) + xz * (Dyadic::from(y) - y0);
        let [least, greatest] = range.map(Dyadic::from);
        // With a positive denominator, the quotient compares like the numerator.
        let (above, below) = if xy.sign().is_negative() { (-above, -xy) } else { (above, xy) };
        let kept = above.max(least * &below).min(greatest * &below);
        (kept, below)
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

    /// The depth at a point, kept within the vertices' range, with its bias.
    fn within(&self, [x, y]: [f32; 2], [least, greatest]: [f32; 2], offset: Option<&Offset>) -> f32 {
        let [x0, y0, z0] = self.start;
        let depth = z0 + self.dz_dx * (R::from_f32(x) - x0) + self.dz_dy * (R::from_f32(y) - y0);
        // Not `clamp`, which leaves NaN: the taught slopes of a sliver can be.
        let kept = depth.to_f32().max(least).min(greatest);
        offset.map_or(kept, |offset| offset.taught(R::from_f32(kept), self.steepest()).to_f32())
    }

    /// The greater magnitude of both slopes.
    fn steepest(&self) -> R {
        let [x, y] = [self.dz_dx, self.dz_dy].map(|slope| if slope < R::ZERO { -slope } else { slope });
        if x < y { y } else { x }
    }
}
