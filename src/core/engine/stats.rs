//! What a call did and left out.

use crate::math::Tally;

#[cfg(doc)]
use super::Engine;

/// What one call did and left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    /// Triangles asked for.
    pub triangles: u64,
    /// Those with no pixel's centre in their box, or a coordinate that is no number.
    pub culled: u64,
    /// Pairs of a triangle and a tile that its box meets.
    pub binned: u64,
    /// Those of them where the triangle lies beside the tile: the skip `tile`.
    pub beside: u64,
    /// Those of them where it lies behind all that is drawn: the skip `hierarchical-z`.
    pub behind: u64,
    /// Blocks of 16 x 8 pixels where a triangle lies behind all that is drawn: the same skip.
    pub hidden: u64,
    /// Blocks of that size, or narrower ones around small triangles, whose pixels were looked at.
    pub blocks: u64,
    /// Tiles whose triangles were drawn front to back: the same skip.
    pub sorted: u64,
    /// Tiles that needed no clearing, since nothing was drawn there: the skip `clear`.
    pub clean: u64,
    /// How many pixels these tiles have.
    pub clean_pixels: u64,
    /// Areas, centres and depths that intervals did not decide.
    pub exact_turns: u64,
    /// Signs of edges asked for at centres.
    pub exact_signs: u64,
    /// Depths rounded exactly.
    pub exact_depths: u64,
    /// Of [`Engine::paint`]: rows of triangles, as far as they are covered.
    pub spans: u64,
    /// Of the same: covered pixels of all triangles, also where they are hidden.
    pub fragments: u64,
    /// Of the same: fragments that fail the stencil test.
    pub stencil_failed: u64,
    /// Of the same: fragments that pass both tests.
    pub passed: u64,
    /// Of the same: colours asked for.
    pub painted: u64,
    /// Of the same: pixels painted for the first time since they were cleared.
    pub pixels: u64,
    /// Of the same: roundings of colours, and those that needed exact arithmetic.
    pub tally: Tally,
}

impl std::ops::AddAssign for Stats {
    fn add_assign(&mut self, other: Self) {
        self.triangles += other.triangles;
        self.culled += other.culled;
        self.binned += other.binned;
        self.beside += other.beside;
        self.behind += other.behind;
        self.hidden += other.hidden;
        self.blocks += other.blocks;
        self.sorted += other.sorted;
        self.clean += other.clean;
        self.clean_pixels += other.clean_pixels;
        self.exact_turns += other.exact_turns;
        self.exact_signs += other.exact_signs;
        self.exact_depths += other.exact_depths;
        self.spans += other.spans;
        self.fragments += other.fragments;
        self.stencil_failed += other.stencil_failed;
        self.passed += other.passed;
        self.painted += other.painted;
        self.pixels += other.pixels;
        self.tally += other.tally;
    }
}
