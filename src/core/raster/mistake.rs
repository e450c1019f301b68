//! What is got wrong in filling a triangle, to be switched on and seen beside the right answer.

use serde::{Deserialize, Serialize};

/// A common mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mistake {
    /// A centre counts as lying on an edge if the edge function is less than 1e-5 there: what that means
    /// in pixels depends on how long the edge is.
    EpsilonSmall,
    /// The same with 1/2, so that it is seen.
    EpsilonLarge,
    /// The scan line adds the slope to x in binary32 from row to row, whatever the arithmetic.
    AccumulatedSlopes,
    /// The vertices are cast to whole numbers, which drops their fractions.
    WholeVertices,
    /// x and y are divided by w before anything else, so that what lies behind the eye comes out before it.
    DivideFirst,
}

impl Mistake {
    /// Every mistake, in the order in which they are shown.
    pub const ALL: [Self; 5] = [
        Self::EpsilonSmall,
        Self::EpsilonLarge,
        Self::AccumulatedSlopes,
        Self::WholeVertices,
        Self::DivideFirst,
    ];

    /// The mistakes of the slope scan line.
    pub const OF_SCANLINE: [Self; 4] =
        [Self::EpsilonSmall, Self::EpsilonLarge, Self::AccumulatedSlopes, Self::WholeVertices];

    /// The mistakes of edge functions in the plane.
    pub const OF_EDGES: [Self; 3] = [Self::EpsilonSmall, Self::EpsilonLarge, Self::WholeVertices];

    /// The mistakes of homogeneous edge functions.
    pub const OF_HOMOGENEOUS: [Self; 3] = [Self::DivideFirst, Self::EpsilonSmall, Self::EpsilonLarge];

    /// The name in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::EpsilonSmall => "epsilon-small",
            Self::EpsilonLarge => "epsilon-large",
            Self::AccumulatedSlopes => "accumulated-slopes",
            Self::WholeVertices => "whole-vertices",
            Self::DivideFirst => "divide-first",
        }
    }

    /// Message ids of its name and of what it breaks.
    pub fn words(self) -> [&'static str; 2] {
        match self {
            Self::EpsilonSmall => ["mistake-epsilon-small", "mistake-epsilon-small-effect"],
            Self::EpsilonLarge => ["mistake-epsilon-large", "mistake-epsilon-large-effect"],
            Self::AccumulatedSlopes => ["mistake-accumulated-slopes", "mistake-accumulated-slopes-effect"],
            Self::WholeVertices => ["mistake-whole-vertices", "mistake-whole-vertices-effect"],
            Self::DivideFirst => ["mistake-divide-first", "mistake-divide-first-effect"],
        }
    }

    /// How far from zero an edge function still counts as zero.
    pub fn epsilon(self) -> Option<f64> {
        match self {
            Self::EpsilonSmall => Some(1e-5),
            Self::EpsilonLarge => Some(0.5),
            Self::AccumulatedSlopes | Self::WholeVertices | Self::DivideFirst => None,
        }
    }
}
