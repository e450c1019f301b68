//! What the parametric algorithms share: places on the line, named before they are divided out.

use super::{Border, End, Point, Segment};
use crate::{
    math::{Real, Sign},
    message::Value,
};
use serde::Serialize;
use std::fmt;

/// What the line does at a border.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Course {
    /// It comes in.
    Enters,
    /// It goes out.
    Leaves,
    /// It keeps its distance.
    Parallel,
}

impl Course {
    /// By the sign of how fast the line goes outward.
    #[inline]
    pub(super) fn outward(speed: Sign) -> Self {
        match speed {
            Sign::Negative => Self::Enters,
            Sign::Zero => Self::Parallel,
            Sign::Positive => Self::Leaves,
        }
    }

    /// Its word.
    pub(super) fn word(self) -> Value {
        Value::Word(match self {
            Self::Enters => "clip-line-enters",
            Self::Leaves => "clip-line-leaves",
            Self::Parallel => "clip-line-parallel",
        })
    }
}

/// A place on the line: where the visible part begins or ends. A fraction, not divided. `B` names
/// a border: one of four, or an edge by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Parameter<B = Border> {
    /// t = 0 or 1: an end of the segment.
    Of(End),
    /// Where it meets a border that is not parallel.
    At(B),
}

impl<B> Parameter<B> {
    /// The border that cuts there, if one does.
    pub(super) fn border(self) -> Option<B> {
        match self {
            Self::At(border) => Some(border),
            Self::Of(_) => None,
        }
    }
}

/// The sign of `a - b`, without computing it: one comparison.
#[inline]
pub(super) fn difference<R: PartialOrd>(a: R, b: R) -> Sign {
    a.partial_cmp(&b).map_or(Sign::Zero, Sign::from)
}

/// A quotient, compared by its bits: rounded arithmetic can divide zero by zero.
#[derive(Clone, Copy, Serialize)]
#[serde(transparent)]
pub struct Quotient(pub f32);

impl PartialEq for Quotient {
    fn eq(&self, other: &Self) -> bool {
        self.0.to_bits() == other.0.to_bits()
    }
}

impl fmt::Debug for Quotient {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&self.0, f)
    }
}

/// The visible part of a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Visible {
    /// Its ends, in the order given.
    pub segment: Segment,
    /// Their parameters: 0 at the given first end, 1 at the second. In exact arithmetic correctly
    /// rounded, and `0 <= t0 <= t1 <= 1`.
    pub t: [f32; 2],
}

/// `P1 + t (P2 - P1)`.
pub(super) fn point_at<R: Real>(segment: Segment, t: R) -> Point {
    let [p1, p2] = segment.map(|p| p.map(R::from_f32));
    [0, 1].map(|axis| (p1[axis] + t * (p2[axis] - p1[axis])).to_f32())
}
