//! Work that can be left out without changing the image, each piece with its own switch.

use serde::Serialize;

/// Work that can be left out. Colour, depth and stencil are the same bit for bit with it on and off.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Skip {
    /// Objects of which a body around them is outside the frustum: their vertices are not transformed.
    ObjectFrustum,
    /// Triangles wholly outside one plane: neither their facing nor their clipping is looked at.
    Frustum,
    /// Triangles that the cull mode drops: dropped before clipping instead of at the fragments.
    BackFace,
    /// Triangles without area as seen from the eye: dropped before clipping instead of at the fragments.
    Degenerate,
    /// Tiles that the box around a triangle meets, but not the triangle. Only the engine has tiles.
    Tile,
    /// Pixels of a row behind the triangle's last one. The engine looks at none of them either way.
    Row,
    /// Colours of fragments that fail the stencil or depth test; of a draw whose fragments may be discarded only
    /// if failing changes nothing.
    EarlyZ,
    /// Tiles and blocks of pixels in which a triangle lies behind all that is drawn. Only the engine keeps the
    /// farthest depth of each.
    HierarchicalZ,
    /// Colours of fragments that later ones hide. Only the engine waits with colours until all is drawn.
    Deferred,
    /// Clearing pixels that the image before did not touch.
    Clear,
    /// Stages whose input is the same as last time.
    Memo,
}

impl Skip {
    /// Every skip, in pipeline order.
    pub const ALL: [Self; 11] = [
        Self::ObjectFrustum,
        Self::Frustum,
        Self::BackFace,
        Self::Degenerate,
        Self::Tile,
        Self::Row,
        Self::EarlyZ,
        Self::HierarchicalZ,
        Self::Deferred,
        Self::Clear,
        Self::Memo,
    ];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::ObjectFrustum => "object-frustum",
            Self::Frustum => "frustum",
            Self::BackFace => "back-face",
            Self::Degenerate => "degenerate",
            Self::Tile => "tile",
            Self::Row => "row",
            Self::EarlyZ => "early-z",
            Self::HierarchicalZ => "hierarchical-z",
            Self::Deferred => "deferred",
            Self::Clear => "clear",
            Self::Memo => "memo",
        }
    }

    /// The skip called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|skip| skip.name() == name)
    }
}

/// Which skips are on.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Skips(u16);

impl Skips {
    /// Everything is done.
    pub const NONE: Self = Self(0);
    /// Everything that can be left out is left out; the default.
    pub const ALL: Self = Self((1 << Skip::ALL.len()) - 1);

    /// Whether a skip is on.
    #[inline]
    pub fn has(self, skip: Skip) -> bool {
        self.0 & 1 << skip as u16 != 0
    }

    /// The same with one skip switched.
    #[must_use]
    pub fn with(self, skip: Skip, on: bool) -> Self {
        let bit = 1 << skip as u16;
        Self(if on { self.0 | bit } else { self.0 & !bit })
    }

    /// The skips with these names; the first unknown name is the error.
    pub fn from_names<'n>(names: impl IntoIterator<Item = &'n str>) -> Result<Self, &'n str> {
        names.into_iter().try_fold(Self::NONE, |skips, name| {
            Skip::from_name(name).map(|skip| skips.with(skip, true)).ok_or(name)
        })
    }

    /// Those that are on.
    pub fn iter(self) -> impl Iterator<Item = Skip> {
        Skip::ALL.into_iter().filter(move |skip| self.has(*skip))
    }
}

impl Default for Skips {
    fn default() -> Self {
        Self::ALL
    }
}

impl FromIterator<Skip> for Skips {
    fn from_iter<I: IntoIterator<Item = Skip>>(skips: I) -> Self {
        skips.into_iter().fold(Self::NONE, |set, skip| set.with(skip, true))
    }
}

impl std::fmt::Debug for Skips {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_set().entries(self.iter().map(Skip::name)).finish()
    }
}
