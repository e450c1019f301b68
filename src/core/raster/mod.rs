//! Scan conversion: which pixels a triangle covers.
//!
//! Contract of every algorithm here: the pixels whose centre (x + 0.5, y + 0.5) lies inside the
//! triangle of the given binary32 vertices, exactly, in either winding; a centre exactly on an
//! edge is decided by the [`FillRule`]. Zero area covers nothing.

use serde::{Deserialize, Serialize};

/// Who draws a pixel whose centre lies exactly on an edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FillRule {
    /// Left edges and horizontal top edges draw it: every shared edge is drawn exactly once.
    #[default]
    TopLeft,
    /// Drawn if the triangle (closed) covers the point just right of the centre; both neighbours of a horizontal
    /// edge do.
    RightOfPoint,
    /// Every edge draws it: pixels on a shared edge are drawn twice.
    Inclusive,
    /// No edge draws it: pixels on a shared edge are holes.
    Strict,
}

impl FillRule {
    /// All rules, the default first.
    pub const ALL: [Self; 4] = [Self::TopLeft, Self::RightOfPoint, Self::Inclusive, Self::Strict];

    /// The name on the command line and in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::TopLeft => "top-left",
            Self::RightOfPoint => "right-of-point",
            Self::Inclusive => "inclusive",
            Self::Strict => "strict",
        }
    }
}

/// Which way y grows in screen space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum YAxis {
    /// Row 0 is the highest.
    #[default]
    Down,
    /// Row 0 is the lowest.
    Up,
}
