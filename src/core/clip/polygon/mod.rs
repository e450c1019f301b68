//! Polygons against a convex region, border by border.

pub mod clip_space;
pub mod clip_triangle;
pub mod outline;
pub mod sutherland_hodgman;

pub use clip_space::{Corner, Origin, Polygon, clip_triangle};

use crate::{
    math::{Arithmetic, Real},
    transform::DepthRange,
};
use serde::{Deserialize, Serialize};

/// The algorithms that clip a polygon against a rectangular window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Algorithm {
    /// Side by side: [`sutherland_hodgman`].
    #[default]
    SutherlandHodgman,
}

impl Algorithm {
    /// Every algorithm, the default first.
    pub const ALL: [Self; 1] = [Self::SutherlandHodgman];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::SutherlandHodgman => "sutherland-hodgman",
        }
    }

    /// What it can compute in. Fixed point is for scan conversion.
    pub fn arithmetics(self) -> &'static [Arithmetic] {
        match self {
            Self::SutherlandHodgman => &[Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64],
        }
    }
}

/// A border of the visible part of clip space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Plane {
    /// `-w <= x`.
    Left,
    /// `x <= w`.
    Right,
    /// `-w <= y`.
    Bottom,
    /// `y <= w`.
    Top,
    /// `0 <= z` or `-w <= z`: the smallest depth. With reversed depth it is farthest from the eye.
    Near,
    /// `z <= w`: the largest depth. With reversed depth it is nearest to the eye.
    Far,
}

impl Plane {
    /// All planes, in the order in which they are cut at.
    pub const ALL: [Self; 6] = [Self::Left, Self::Right, Self::Bottom, Self::Top, Self::Near, Self::Far];

    /// The id of the word for it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Left => "word-left",
            Self::Right => "word-right",
            Self::Bottom => "word-bottom",
            Self::Top => "word-top",
            Self::Near => "word-near",
            Self::Far => "word-far",
        }
    }
}

/// Which planes clip.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PlaneSet {
    /// All six.
    #[default]
    All,
    /// Only [`Plane::Near`], as where the rasterizer does the rest.
    Near,
    /// All six, but the sides stand farther apart by this power of two: what lies between is left to the
    /// rasterizer.
    Guard(u8),
}

impl PlaneSet {
    /// The sets, the default first; the guard band with the factor 4.
    pub const ALL: [Self; 3] = [Self::All, Self::Near, Self::Guard(2)];
    /// The largest power of two of a guard band.
    pub const MOST_GUARD: u8 = 16;

    /// The planes.
    pub fn planes(self) -> &'static [Plane] {
        match self {
            Self::All | Self::Guard(_) => &Plane::ALL,
            Self::Near => &[Plane::Near],
        }
    }

    /// What w is multiplied by at the sides: a power of two, so that the product is exact and a rounded
    /// corner on a side still fulfils its inequality.
    pub fn guard(self) -> f32 {
        match self {
            Self::Guard(power) => (1_u32 << power.min(Self::MOST_GUARD)) as f32,
            Self::All | Self::Near => 1.0,
        }
    }
}

/// The distance of a point of clip space from a plane as a sum of two terms; inside is `>= 0`.
#[inline]
fn distance_terms<R: Real>(plane: Plane, [x, y, z, w]: [R; 4], range: DepthRange) -> [R; 2] {
    match plane {
        Plane::Left => [w, x],
        Plane::Right => [w, -x],
        Plane::Bottom => [w, y],
        Plane::Top => [w, -y],
        Plane::Near => match range {
            DepthRange::ZeroToOne => [z, R::ZERO],
            DepthRange::MinusOneToOne => [w, z],
        },
        Plane::Far => [w, -z],
    }
}

/// Whether a point of clip space lies strictly outside a plane; exact, by one comparison.
#[inline]
pub fn distance_is_negative(plane: Plane, point: [f32; 4], range: DepthRange) -> bool {
    let [a, b] = distance_terms(plane, point, range);
    a < -b
}
