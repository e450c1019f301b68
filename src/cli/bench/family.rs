//! The families of inputs: ordinary ones, and those that break textbook code.

use serde::Serialize;

/// What is special about inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Family {
    /// Nothing.
    Ordinary,
    /// Past a corner of the window, but for the rounding of an end.
    PastACorner,
    /// On a border or a pixel's centre, or up to two steps beside it.
    Beside,
    /// Nearly parallel to a border.
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
    /// The name in the table and in JSON.
    pub(super) fn name(self) -> &'static str {
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
}
