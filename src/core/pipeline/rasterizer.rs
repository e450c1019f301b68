//! What turns triangles into pixels.

use crate::raster::Algorithm;

/// What turns triangles into pixels; all give the same image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rasterizer {
    /// The [`engine`](crate::engine), many triangles at once; scan line where it has no way: several samples a
    /// pixel, depths in unorm32, a draw with scissor, alpha test, depth bias or depth clamp.
    #[default]
    Engine,
    /// One triangle after another.
    Each(Algorithm),
}

impl Rasterizer {
    /// The algorithm for single triangles.
    pub(super) fn algorithm(self) -> Algorithm {
        match self {
            Self::Engine => Algorithm::Scanline,
            Self::Each(algorithm) => algorithm,
        }
    }
}

impl From<Algorithm> for Rasterizer {
    fn from(algorithm: Algorithm) -> Self {
        Self::Each(algorithm)
    }
}
