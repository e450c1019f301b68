//! Families of inputs: ordinary ones, and those that break textbook code.
//!
//! What the benchmark times and the stress lab shows are the same inputs, the same on every run and machine.
//! A generator takes a family and a count; the first inputs of a longer list are those of a shorter one.

pub mod clip_triangles;
pub mod dial;
pub mod judge;
pub mod points;
pub mod polygons;
mod random;
pub mod segments;
pub mod shrink;
pub mod trial;
pub mod triangles;

pub use random::Random;

use serde::{Deserialize, Serialize};

/// What is special about inputs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Family {
    /// Nothing.
    #[default]
    Ordinary,
    /// Past a corner of the window, but for the rounding of an end.
    PastACorner,
    /// On a border or a pixel's centre, or up to two steps beside it.
    Beside,
    /// Nearly parallel to a border or to a row of centres.
    NearlyParallel,
    /// From 1e20 to 3e38.
    Huge,
    /// Below the smallest normal number.
    Denormal,
    /// Nearly without area.
    Sliver,
    /// w near 0, of both signs where that is legal.
    NearWZero,
    /// Over thousands of rows, so that errors add up.
    Long,
}

impl Family {
    /// Every family, the ordinary one first.
    pub const ALL: [Self; 9] = [
        Self::Ordinary,
        Self::PastACorner,
        Self::Beside,
        Self::NearlyParallel,
        Self::Huge,
        Self::Denormal,
        Self::Sliver,
        Self::NearWZero,
        Self::Long,
    ];

    /// The name in tables and in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ordinary => "ordinary",
            Self::PastACorner => "past-a-corner",
            Self::Beside => "beside",
            Self::NearlyParallel => "nearly-parallel",
            Self::Huge => "huge",
            Self::Denormal => "denormal",
            Self::Sliver => "sliver",
            Self::NearWZero => "near-w-zero",
            Self::Long => "long",
        }
    }

    /// The family called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|family| family.name() == name)
    }
}
