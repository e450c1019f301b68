//! Lines against a rectangular window.
//!
//! Contract of every algorithm here: the window is closed, so touching it counts as visible;
//! what lies inside comes back bit for bit; a cut end lies on the crossed border bit for bit, its
//! other coordinate is the exact intersection rounded once to binary32 (if that is a coordinate of
//! the window, with that border's bits: -0 stays -0). So the answer depends on
//! the line and the border alone: not on the order of the ends, nor on the algorithm.

mod at_once;
pub mod cohen_sutherland;
mod convex;
pub mod cyrus_beck;
pub(in crate::clip) mod intersection;
pub mod liang_barsky;
mod meets;
pub mod midpoint;
mod mistake;
pub mod nicholl_lee_nicholl;
mod parametric;
pub(in crate::clip) mod subject;

pub use at_once::{clip, clip_all};
pub use convex::{ConvexWindow, Flaw};
pub use mistake::{Mistake, Mistakes};
pub use parametric::{Course, Parameter, Quotient, Visible};

use crate::{
    explain::{Piece, View},
    math::{Arithmetic, Sign},
    message::Value,
};
use serde::{Deserialize, Serialize};
use std::fmt;

/// A point of the window's plane: any unit, y up, finite.
pub type Point = [f32; 2];

/// Both ends of a segment, in the order given.
pub type Segment = [Point; 2];

/// The visible part of one of many segments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kept {
    /// Which segment it was; the first is 0.
    pub index: u32,
    /// What is visible of it.
    pub segment: Segment,
}

/// The algorithms of this stage.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Algorithm {
    /// Outcodes: [`cohen_sutherland`].
    #[default]
    CohenSutherland,
    /// Ordered parameters: [`liang_barsky`].
    LiangBarsky,
    /// Any convex window, edge by edge: [`cyrus_beck`].
    CyrusBeck,
    /// Halving: [`midpoint`].
    Midpoint,
    /// Regions and slopes: [`nicholl_lee_nicholl`].
    NichollLeeNicholl,
}

impl Algorithm {
    /// Every algorithm, the default first.
    pub const ALL: [Self; 5] =
        [Self::CohenSutherland, Self::LiangBarsky, Self::CyrusBeck, Self::Midpoint, Self::NichollLeeNicholl];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::CohenSutherland => "cohen-sutherland",
            Self::LiangBarsky => "liang-barsky",
            Self::CyrusBeck => "cyrus-beck",
            Self::Midpoint => "midpoint",
            Self::NichollLeeNicholl => "nicholl-lee-nicholl",
        }
    }
}

/// A closed axis-parallel window; `xmin <= xmax` and `ymin <= ymax`, equality allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Left border.
    pub xmin: f32,
    /// Bottom border.
    pub ymin: f32,
    /// Right border.
    pub xmax: f32,
    /// Top border.
    pub ymax: f32,
}

impl Window {
    /// From `[xmin, ymin, xmax, ymax]`; `None` if a minimum is above its maximum or a value is
    /// not finite.
    pub fn new([xmin, ymin, xmax, ymax]: [f32; 4]) -> Option<Self> {
        let finite = [xmin, ymin, xmax, ymax].iter().all(|v| v.is_finite());
        (finite && xmin <= xmax && ymin <= ymax).then_some(Self { xmin, ymin, xmax, ymax })
    }

    /// As `[xmin, ymin, xmax, ymax]`.
    #[inline]
    pub fn array(&self) -> [f32; 4] {
        [self.xmin, self.ymin, self.xmax, self.ymax]
    }

    /// The constant coordinate of a border.
    #[inline]
    pub fn at(&self, border: Border) -> f32 {
        // Without a jump, which a processor could not foresee: an upper border is an even one.
        let [min, max] = self.sides(border.axis());
        if (border as u8).is_multiple_of(2) { max } else { min }
    }

    /// Minimum and maximum of x (axis 0) or y (axis 1).
    #[inline]
    pub fn sides(&self, axis: usize) -> [f32; 2] {
        if axis == 0 { [self.xmin, self.xmax] } else { [self.ymin, self.ymax] }
    }

    /// Counter-clockwise from the lower left corner.
    pub fn corners(&self) -> [Point; 4] {
        let Self { xmin, ymin, xmax, ymax } = *self;
        [[xmin, ymin], [xmax, ymin], [xmax, ymax], [xmin, ymax]]
    }
}

/// A border of the window, in the order in which an outcode is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Border {
    /// `y = ymax`.
    Top,
    /// `y = ymin`.
    Bottom,
    /// `x = xmax`.
    Right,
    /// `x = xmin`.
    Left,
}

impl Border {
    /// As an outcode is written, from left to right.
    pub const ALL: [Self; 4] = [Self::Top, Self::Bottom, Self::Right, Self::Left];

    /// 0 if the border is `x = constant`, 1 if it is `y = constant`.
    #[inline]
    pub fn axis(self) -> usize {
        match self {
            Self::Right | Self::Left => 0,
            Self::Top | Self::Bottom => 1,
        }
    }

    /// Whether inside is where the coordinate is smaller.
    #[inline]
    pub fn is_upper(self) -> bool {
        matches!(self, Self::Top | Self::Right)
    }

    /// The name of its constant.
    pub fn name(self) -> &'static str {
        match self {
            Self::Top => "ymax",
            Self::Bottom => "ymin",
            Self::Right => "xmax",
            Self::Left => "xmin",
        }
    }

    /// Its letter, as an outcode names its bits.
    pub fn letter(self) -> &'static str {
        match self {
            Self::Top => "T",
            Self::Bottom => "B",
            Self::Right => "R",
            Self::Left => "L",
        }
    }

    /// The sign of the outward direction along its axis.
    #[inline]
    pub(crate) fn outward(self) -> Sign {
        match self {
            Self::Left | Self::Bottom => Sign::Negative,
            Self::Right | Self::Top => Sign::Positive,
        }
    }

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::Top => "word-top",
            Self::Bottom => "word-bottom",
            Self::Right => "word-right",
            Self::Left => "word-left",
        }
    }
}

/// Which end of the segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum End {
    /// The first point.
    P1,
    /// The second point.
    P2,
}

impl End {
    /// Both ends in order.
    pub const ALL: [Self; 2] = [Self::P1, Self::P2];

    /// Its name in the listing.
    pub fn name(self) -> &'static str {
        match self {
            Self::P1 => "P1",
            Self::P2 => "P2",
        }
    }

    /// The other one.
    pub fn other(self) -> Self {
        match self {
            Self::P1 => Self::P2,
            Self::P2 => Self::P1,
        }
    }

    /// Of two ends with different codes, the one beyond a border at which they differ.
    #[inline(always)]
    fn beyond(border: Border, [c1, _]: [Outcode; 2]) -> Self {
        if c1.has(border) { Self::P1 } else { Self::P2 }
    }
}

/// Four bits saying beyond which borders a point lies; 0 is inside. Written top, bottom, right,
/// left.
///
/// *Source:* Newman and Sproull, Principles of Interactive Computer Graphics, 2nd ed. 1979,
/// section 5-1.
#[derive(Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct Outcode(pub u8);

impl fmt::Display for Outcode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04b}", self.0)
    }
}

impl fmt::Debug for Outcode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl Serialize for Outcode {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl Outcode {
    /// The bit of a border.
    #[inline]
    pub fn bit(border: Border) -> Self {
        Self(0b1000 >> border as u8)
    }

    /// Joins the answers to "beyond this border?", in the order of [`Border::ALL`].
    #[inline]
    pub fn from_bits(beyond: [bool; 4]) -> Self {
        Self(beyond.iter().fold(0, |code, &bit| code << 1 | u8::from(bit)))
    }

    /// The outcode of a point: exact, since it only compares. A NaN counts as inside.
    #[inline]
    pub fn of<R: PartialOrd>([x, y]: [R; 2], [xmin, ymin, xmax, ymax]: [R; 4]) -> Self {
        Self::from_bits([y > ymax, y < ymin, x > xmax, x < xmin])
    }

    /// Whether the point lies beyond `border`.
    #[inline]
    pub fn has(self, border: Border) -> bool {
        self.0 & Self::bit(border).0 != 0
    }

    /// The first border, in writing order, whose bit is 1.
    #[inline]
    pub fn first(self) -> Option<Border> {
        Border::ALL.into_iter().find(|&border| self.has(border))
    }
}

/// What the labs of this stage show: the points of the input, the window, and some room around both.
pub(in crate::clip) fn view(points: impl IntoIterator<Item = Point>, window: &Window) -> View {
    subject::view(window.corners().into_iter().chain(points))
}

/// The numbers of how far along from a1 to a2 the border c lies, `= (c − a1) / (a2 − a1) = t`, and t.
pub(in crate::clip) fn share(c: f32, [a1, a2]: [f32; 2], arithmetic: Arithmetic) -> (Vec<Piece>, Value) {
    let t = if arithmetic == Arithmetic::F32 {
        Value::F32((c - a1) / (a2 - a1))
    } else {
        let [c, a1, a2] = [c, a1, a2].map(f64::from);
        Value::F64((c - a1) / (a2 - a1))
    };
    let [c, a1, a2] = [c, a1, a2].map(|x| Piece::Number(x.into()));
    let text = Piece::Text;
    let (open, minus, over) = (text("= ("), text(" − "), text(") / ("));
    let numbers = vec![open, c, minus.clone(), a1.clone(), over, a2, minus, a1, text(") = ")];
    (numbers.into_iter().chain([Piece::Result(t.clone())]).collect(), t)
}

/// The numbers of a coordinate at t: `= b1 + t (b2 − b1) = result`.
pub(in crate::clip) fn along(b1: Piece, b2: Piece, t: Value, result: Piece) -> Vec<Piece> {
    let text = Piece::Text;
    let (plus, open, minus, equals) = (text(" + "), text(" ("), text(" − "), text(") = "));
    vec![text("= "), b1.clone(), plus, Piece::Number(t), open, b2, minus, b1, equals, result]
}
