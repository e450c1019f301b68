//! What is inside of a polygon that crosses itself or has holes.

use serde::{Deserialize, Serialize};

/// Which points are inside, told from how often the contours wind around them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum WindingRule {
    /// An odd number of times, whatever the direction: every edge separates inside from outside.
    #[default]
    EvenOdd,
    /// Any number of times but zero; the directions of the contours matter.
    NonZero,
}

impl WindingRule {
    /// Both, the default first.
    pub const ALL: [Self; 2] = [Self::EvenOdd, Self::NonZero];

    /// The name on the command line and in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::EvenOdd => "even-odd",
            Self::NonZero => "non-zero",
        }
    }

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::EvenOdd => "word-winding-even-odd",
            Self::NonZero => "word-winding-non-zero",
        }
    }

    /// Whether a point with this winding number is inside.
    #[inline]
    pub fn is_inside(self, winding: i32) -> bool {
        match self {
            Self::EvenOdd => winding % 2 != 0,
            Self::NonZero => winding != 0,
        }
    }
}
