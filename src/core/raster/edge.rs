//! Edge functions with exact signs, and who owns a centre on an edge.
//!
//! *Source:* Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; Direct3D 11.3
//! functional specification, section 3.4.2 (top-left rule).

use super::{FillRule, Settings, YAxis};
use crate::math::{Sign, Tally, orient2d};

/// A directed edge with the inside where [`orient2d`] of the edge and a point is positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Its ends, in pixels.
    pub ends: [[f32; 2]; 2],
    /// Whether a centre exactly on it is drawn, as far as this edge decides.
    pub draws_ties: bool,
}

impl Edge {
    /// The edge from `a` to `b`, inside where the orientation is positive, under a fill rule.
    pub fn new(a: [f32; 2], b: [f32; 2], fill_rule: FillRule, y_axis: YAxis) -> Self {
        let mut edge = Self { ends: [a, b], draws_ties: false };
        let horizontal = a[1] == b[1];
        edge.draws_ties = match fill_rule {
            FillRule::TopLeft => edge.is_left() || horizontal && (a[0] < b[0]) == (y_axis == YAxis::Down),
            FillRule::RightOfPoint => edge.is_left() || horizontal,
            FillRule::Inclusive => true,
            FillRule::Strict => false,
        };
        edge
    }

    /// Whether the inside is to the right of it.
    ///
    /// The inward normal is (ay - by, bx - ax), of which only the signs matter: nothing is rounded.
    #[inline]
    pub fn is_left(&self) -> bool {
        self.ends[0][1] > self.ends[1][1]
    }

    /// On which side `point` lies: positive is inside.
    #[inline]
    pub fn side(&self, point: [f32; 2], tally: &mut Tally) -> Sign {
        orient2d(self.ends[0], self.ends[1], point, tally)
    }

    /// Whether a point with this [`side`](Self::side) is drawn, as far as this edge decides.
    #[inline]
    pub fn draws(&self, side: Sign) -> bool {
        side.is_positive() || side.is_zero() && self.draws_ties
    }
}

/// The three edges of a triangle, turned so that its inside is positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edges(pub [Edge; 3]);

impl Edges {
    /// The edges of a triangle of either winding; `None` if its area is exactly zero.
    pub fn new([a, b, c]: [[f32; 2]; 3], settings: &Settings, tally: &mut Tally) -> Option<Self> {
        let edge = |a, b| Edge::new(a, b, settings.fill_rule, settings.y_axis);
        match orient2d(a, b, c, tally) {
            Sign::Positive => Some(Self([edge(a, b), edge(b, c), edge(c, a)])),
            Sign::Negative => Some(Self([edge(b, a), edge(c, b), edge(a, c)])),
            Sign::Zero => None,
        }
    }

    /// Whether a point, such as a pixel's centre or a sample, is covered.
    #[inline]
    pub fn cover(&self, point: [f32; 2], tally: &mut Tally) -> bool {
        self.0.iter().all(|edge| edge.draws(edge.side(point, tally)))
    }
}

/// The centre of a pixel; exact for every image.
#[inline]
pub(crate) fn centre(x: u32, y: u32) -> [f32; 2] {
    [x as f32 + 0.5, y as f32 + 0.5]
}

/// The first column of `0..width` that is `reached`, or `width`; from the first one on all are.
///
/// Asks about two columns if `guess` is right, else bisects.
#[inline]
pub(crate) fn first_reached(guess: u32, width: u32, mut reached: impl FnMut(u32) -> bool) -> u32 {
    let is_reached = guess >= width || reached(guess);
    if is_reached && (guess == 0 || !reached(guess - 1)) { guess } else { bisect(width, reached) }
}

/// The first of `0..limit` that is `reached`, or `limit`; from the first one on all are.
#[cold]
pub(crate) fn bisect(limit: u32, mut reached: impl FnMut(u32) -> bool) -> u32 {
    let (mut low, mut high) = (0, limit);
    while low < high {
        let middle = low + (high - low) / 2;
        if reached(middle) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    low
}
