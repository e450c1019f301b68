//! The matrices of the vertex transform, and the one way to multiply by them.
//!
//! A matrix is built in binary64 with portable functions and rounded to binary32 once. A product
//! component is summed in binary64 in a fixed order and rounded once. No multiplication is fused with
//! an addition. So every machine gives the same bits.
//!
//! *Source:* Shirley, Marschner, Fundamentals of Computer Graphics, 4th ed. 2015, sections 6.2, 7.1 to
//! 7.3; OpenGL 4.6 core, section 13.8 (perspective); Reed, Depth Precision Visualized, 2015 (reversed
//! depth). Deviation: quarter turns are exact.

use glam::{DMat4, DVec3, DVec4, dvec4};

use super::{Camera, DepthRange, Projection};

/// 4 x 4 numbers, column by column: row `i` of column `j` is at `4 * j + i`. Vectors are columns.
pub type Matrix = [f32; 16];

/// Leaves every vector as it is.
pub const IDENTITY: Matrix = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

/// Rounds to the nearest binary32; what is too large becomes the largest number with its sign.
///
/// So a chain of products of finite numbers stays finite, and rounding stays monotone. Whether it
/// happened, [`pipeline::out_of_range`](crate::pipeline::out_of_range) tells.
#[inline]
pub fn round_once(value: f64) -> f32 {
    value.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) as f32
}

/// Row `i` of `matrix` times the column `v`: `((m0 x + m1 y) + m2 z) + m3 w` in binary64, rounded once.
///
/// The four products are exact in binary64; three additions and the end are rounded.
#[inline]
pub fn row_times(matrix: &Matrix, i: usize, v: [f32; 4]) -> f32 {
    round_once(row_sum(matrix, i, v))
}

#[inline]
fn row_sum(matrix: &Matrix, i: usize, v: [f32; 4]) -> f64 {
    let product = |j: usize| f64::from(matrix[4 * j + i]) * f64::from(v[j]);
    product(0) + product(1) + product(2) + product(3)
}

/// Whether a component of [`apply`] is too large for binary32.
pub fn product_leaves_range(matrix: &Matrix, v: [f32; 4]) -> bool {
    (0..4).any(|i| leaves_range(row_sum(matrix, i, v)))
}

fn leaves_range(value: f64) -> bool {
    (value as f32).is_infinite()
}

/// Whether [`view`], [`projection`] or the 1/w of a point on the near plane is too large for binary32.
///
/// Arguments as for [`projection`].
pub fn camera_leaves_range(camera: &Camera, aspect: f64, range: DepthRange, reversed: bool) -> bool {
    let matrices = [wide_view(camera), wide_projection(camera, aspect, range, reversed)];
    let perspective = matches!(camera.projection, Projection::Perspective { .. });
    matrices.iter().flat_map(DMat4::to_cols_array).any(leaves_range)
        || perspective && leaves_range(1.0 / f64::from(camera.near))
}

/// `matrix` times the column `v`. Finite for finite input.
#[inline]
pub fn apply(matrix: &Matrix, v: [f32; 4]) -> [f32; 4] {
    let mut product = [0.0; 4];
    // A plain loop becomes one vector instruction for all rows.
    for (i, component) in product.iter_mut().enumerate() {
        *component = row_times(matrix, i, v);
    }
    product
}

/// One row of a matrix.
#[inline]
pub fn row(matrix: &Matrix, i: usize) -> [f32; 4] {
    [0, 1, 2, 3].map(|j| matrix[4 * j + i])
}

/// Object to world space: scale, then turn about x, then y, then z, then move (`T Rz Ry Rx S`).
///
/// Angles are in degrees, positive turns counter-clockwise for an eye on the axis' positive side.
/// A scale of zero gives a flat object, a negative one mirrors it.
pub fn model(translate: [f32; 3], rotate_degrees: [f32; 3], scale: [f32; 3]) -> Matrix {
    let [x, y, z] = rotate_degrees.map(sin_cos_degrees);
    let turn_x = from_rows([1.0, 0.0, 0.0], [0.0, x.1, -x.0], [0.0, x.0, x.1]);
    let turn_y = from_rows([y.1, 0.0, y.0], [0.0, 1.0, 0.0], [-y.0, 0.0, y.1]);
    let turn_z = from_rows([z.1, -z.0, 0.0], [z.0, z.1, 0.0], [0.0, 0.0, 1.0]);
    let mut matrix = turn_z * turn_y * turn_x * DMat4::from_scale(wide(scale));
    matrix.w_axis = wide(translate).extend(1.0);
    rounded(&matrix)
}

/// World to camera space: the inverse of the matrix that carries the camera from the origin, where it
/// looks along -z with y up, to its place.
///
/// If the target is the eye the camera looks along -z of the world; if `up` is parallel to the line of
/// sight, the world axis that is farthest from it takes its place.
pub fn view(camera: &Camera) -> Matrix {
    rounded(&wide_view(camera))
}

fn wide_view(camera: &Camera) -> DMat4 {
    let (eye, target, up) = (wide(camera.eye), wide(camera.target), wide(camera.up));
    let forward = unit(target - eye).unwrap_or(DVec3::NEG_Z);
    let side = forward.cross(unit(up).unwrap_or(forward));
    let right =
        if side.length() > PARALLEL { side } else { forward.cross(farthest_axis(forward)) }.normalize();
    let up = right.cross(forward);
    DMat4::from_cols(
        dvec4(right.x, up.x, -forward.x, 0.0),
        dvec4(right.y, up.y, -forward.y, 0.0),
        dvec4(right.z, up.z, -forward.z, 0.0),
        dvec4(-right.dot(eye), -up.dot(eye), forward.dot(eye), 1.0),
    )
}

/// Camera to clip space. `aspect` is width by height of the image; `reversed` swaps the depths of the
/// near and far plane.
///
/// A perspective has `w = -z`; with `a`, `b` from `near`, `far` the depth is `(a z + b) / w`. An
/// orthographic projection has `w = 1`. Valid for a camera as its fields describe.
pub fn projection(camera: &Camera, aspect: f64, range: DepthRange, reversed: bool) -> Matrix {
    rounded(&wide_projection(camera, aspect, range, reversed))
}

fn wide_projection(camera: &Camera, aspect: f64, range: DepthRange, reversed: bool) -> DMat4 {
    let (near, far) = (f64::from(camera.near), f64::from(camera.far));
    // Depth in 0..=1 is (a z + b) / w; the other ranges are a stretch or a flip of it.
    let (scale, a, b, w) = match camera.projection {
        Projection::Perspective { fovy_degrees } => {
            let gamma = 1.0 / libm::tan(f64::from(fovy_degrees).to_radians() / 2.0);
            let (a, b) = match range {
                DepthRange::ZeroToOne => (far / (near - far), far * near / (near - far)),
                DepthRange::MinusOneToOne => ((far + near) / (near - far), 2.0 * far * near / (near - far)),
            };
            (gamma, a, b, dvec4(0.0, 0.0, -1.0, 0.0))
        }
        Projection::Orthographic { height } => {
            let (a, b) = match range {
                DepthRange::ZeroToOne => (1.0 / (near - far), near / (near - far)),
                DepthRange::MinusOneToOne => (2.0 / (near - far), (far + near) / (near - far)),
            };
            (2.0 / f64::from(height), a, b, dvec4(0.0, 0.0, 0.0, 1.0))
        }
    };
    let depth = dvec4(0.0, 0.0, a, b);
    let depth = match (reversed, range) {
        (false, _) => depth,
        (true, DepthRange::ZeroToOne) => w - depth,
        (true, DepthRange::MinusOneToOne) => -depth,
    };
    let rows = DMat4::from_cols(dvec4(scale / aspect, 0.0, 0.0, 0.0), dvec4(0.0, scale, 0.0, 0.0), depth, w);
    rows.transpose()
}

/// The same vector in binary64.
fn wide(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}

/// Sine and cosine of an angle in degrees, exact at quarter turns.
fn sin_cos_degrees(degrees: f32) -> (f64, f64) {
    let degrees = f64::from(degrees) % 360.0;
    match degrees {
        0.0 => (0.0, 1.0),
        90.0 | -270.0 => (1.0, 0.0),
        180.0 | -180.0 => (0.0, -1.0),
        270.0 | -90.0 => (-1.0, 0.0),
        _ => libm::sincos(degrees.to_radians()),
    }
}

/// The linear map with these rows.
fn from_rows(x: [f64; 3], y: [f64; 3], z: [f64; 3]) -> DMat4 {
    let row = |r: [f64; 3]| DVec3::from_array(r).extend(0.0);
    DMat4::from_cols(row(x), row(y), row(z), DVec4::W).transpose()
}

/// Two directions with a smaller sine between them count as parallel: far above the rounding of a cross
/// product of unit vectors (some 2^-53), far below what two binary32 directions can differ by on purpose.
const PARALLEL: f64 = 1e-12;

/// The direction of `v`, unless it is zero. Scaled first, so that no square overflows or vanishes.
fn unit(v: DVec3) -> Option<DVec3> {
    let longest = v.abs().max_element();
    (longest > 0.0).then(|| (v / longest).normalize())
}

/// The axis that makes the largest angle with `direction`; y before x before z.
fn farthest_axis(direction: DVec3) -> DVec3 {
    let size = direction.abs();
    if size.y <= size.x.min(size.z) {
        DVec3::Y
    } else if size.x <= size.z {
        DVec3::X
    } else {
        DVec3::Z
    }
}

/// The nearest binary32 matrix; never -0.
fn rounded(matrix: &DMat4) -> Matrix {
    matrix.to_cols_array().map(|entry| round_once(entry) + 0.0)
}
