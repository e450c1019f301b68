//! Interpolation: what a value given at three vertices is at a point between them.
//!
//! Contract: the exact quotient of sums, rounded once to binary32 or to an 8-bit code. So the
//! value depends on the triangle and the point alone, three equal values come back bit for bit,
//! and nothing overshoots the vertices' range.

pub mod area_ratios;
pub(crate) mod barycentric;
mod perspective;
pub mod perspective_correction;
pub mod plane_equation;

pub use area_ratios::Subject;
pub use barycentric::{Barycentric, Weights};
pub use perspective::Interpolator;

use crate::{
    math::{Arithmetic, Tally},
    message::Message,
};
use serde::{Deserialize, Serialize};

/// Along which line values change evenly.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mode {
    /// Evenly in space: `sum(l a / w) / sum(l / w)`.
    #[default]
    Perspective,
    /// Evenly on the screen, as if all w were equal: `sum(l a)`.
    Affine,
}

impl Mode {
    /// Both modes, the default first.
    pub const ALL: [Self; 2] = [Self::Perspective, Self::Affine];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Perspective => "perspective",
            Self::Affine => "affine",
        }
    }

    /// The mode called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|mode| mode.name() == name)
    }
}

/// Why there is no value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, thiserror::Error, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum InterpolateError {
    /// The triangle has no area, hence no inside.
    #[error("error-interpolate-zero-area")]
    ZeroArea,
    /// The point lies outside the closed triangle.
    #[error("error-interpolate-outside")]
    Outside,
    /// A vertex has w = 0: it is infinitely far away on the screen.
    #[error("error-interpolate-zero-w")]
    ZeroW,
    /// `sum(l / w)` is 0, which needs w of both signs: the point is infinitely far away in space.
    #[error("error-interpolate-infinite")]
    Infinite,
}

impl InterpolateError {
    /// The sentence that says so.
    pub fn message(self) -> Message {
        Message::new(match self {
            Self::ZeroArea => "error-interpolate-zero-area",
            Self::Outside => "error-interpolate-outside",
            Self::ZeroW => "error-interpolate-zero-w",
            Self::Infinite => "error-interpolate-infinite",
        })
    }
}

/// Interpolates an attribute at a point of the closed triangle.
///
/// Vertices are (x, y, w): x and y in pixels, w of clip space, any finite numbers but w = 0 in
/// perspective; `at` is in pixels, too. Either winding. The result is correctly rounded; it may
/// be infinite only if w has both signs: [`area_ratios::interpolate`], which says the rest.
pub fn interpolate(
    mode: Mode,
    vertices: [[f32; 3]; 3],
    attribute: [f32; 3],
    at: [f32; 2],
    arithmetic: Arithmetic,
    tally: &mut Tally,
) -> Result<f32, InterpolateError> {
    area_ratios::interpolate(mode, &Subject { vertices, attribute, at }, arithmetic, tally)
}

/// The code of a value in `0..=max`: `floor(max value + 1/2)`, exactly; values outside 0..1 are
/// clamped, NaN is 0. A few ns.
///
/// *Source:* Direct3D 11.3 functional specification, section 3.2.3.6 (float to UNORM).
pub fn unorm(value: f32, max: u32) -> u32 {
    if value >= 1.0 {
        return max;
    }
    // Below 2^-34 the code is 0 even with 32 bits.
    if value.is_nan() || value < 1.0 / (1u64 << 34) as f32 {
        return 0;
    }
    // value = mantissa * 2^-shift with 24 <= shift <= 57, and the product has at most 57 bits.
    let bits = value.to_bits();
    let mantissa = u64::from(bits & 0x7F_FFFF | 0x80_0000);
    let shift = 150 - (bits >> 23);
    ((2 * mantissa * u64::from(max) + (1 << shift)) >> (shift + 1)) as u32
}
