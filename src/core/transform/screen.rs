//! From clip space to the screen: the perspective divide and the viewport.
//!
//! *Source:* Shirley, Marschner, Fundamentals of Computer Graphics, 4th ed. 2015, sections 7.1.1 and
//! 7.3; Blinn, Hyperbolic Interpolation, 1992 (why 1/w is kept).

use super::{DepthRange, matrices::round_once};
use crate::raster::YAxis;

/// The image that NDC is stretched over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Viewport {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Which depths in NDC are visible; they become 0..=1.
    pub depth_range: DepthRange,
    /// Whether row 0 is the highest or the lowest.
    pub y_axis: YAxis,
}

/// Clip space to NDC: `(x / w, y / w, z / w, 1 / w)`, each rounded once.
///
/// 1/w stays in the fourth place, for perspective-correct attributes. A point with `w < 0` lies behind
/// the eye and comes out mirrored; one with `w = 0` has no image and becomes (0, 0, 0, 0). What the
/// clipper lets through has `w > 0`, or is (0, 0, 0, 0) itself.
#[inline]
pub fn divide([x, y, z, w]: [f32; 4]) -> [f32; 4] {
    if w == 0.0 {
        return [0.0; 4];
    }
    let mut point = [x, y, z, 1.0];
    for component in &mut point {
        *component = quotient(*component, w);
    }
    point
}

/// `component / w`, rounded once; `w` is not zero. (Binary64 first does not round twice: a quotient of
/// 24-bit numbers is never that near to a tie, unless it is subnormal.)
#[inline]
pub(super) fn quotient(component: f32, w: f32) -> f32 {
    round_once(f64::from(component) / f64::from(w)) + 0.0
}

impl Viewport {
    /// NDC to screen space: x to the right and y in pixels from the corner of pixel (0, 0), whose centre
    /// is (0.5, 0.5); depth 0..=1; the fourth component stays. Never rounded to pixels.
    #[inline]
    pub fn to_screen(&self, [x, y, z, r]: [f32; 4]) -> [f32; 4] {
        let [half_width, half_height] = self.size.map(|n| f64::from(n) / 2.0);
        let (x, y, z) = (f64::from(x), f64::from(y), f64::from(z));
        let y_screen = match self.y_axis {
            YAxis::Down => half_height * (1.0 - y),
            YAxis::Up => half_height * (y + 1.0),
        };
        let z_screen = match self.depth_range {
            DepthRange::ZeroToOne => z,
            DepthRange::MinusOneToOne => (z + 1.0) / 2.0,
        };
        [round_once(half_width * (x + 1.0)), round_once(y_screen), round_once(z_screen) + 0.0, r]
    }

    /// Width divided by height.
    pub fn aspect(&self) -> f64 {
        f64::from(self.size[0]) / f64::from(self.size[1])
    }
}
