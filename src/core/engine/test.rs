//! The depth test of many pixels at once.

use super::lanes::mask;
use crate::depth::DepthState;

/// Decides about depths that are known as intervals.
pub(super) trait Test: Copy {
    /// All bits if a depth passes against the stored one, else none.
    fn passes(&self, new: f32, stored: f32) -> u32;

    /// All bits if it matters that the two ends of an interval differ, for a pixel that is covered (or not) and
    /// passes (or not) at the near end.
    fn matters(&self, covered: u32, passes: u32) -> u32;

    /// The bits of a depth that are stored.
    fn written(&self) -> u32;
}

/// Less, and stored. What is not less at its least is not less.
#[derive(Clone, Copy)]
pub(super) struct Nearer;

impl Test for Nearer {
    #[inline(always)]
    fn passes(&self, new: f32, stored: f32) -> u32 {
        mask(new < stored)
    }

    #[inline(always)]
    fn matters(&self, _: u32, passes: u32) -> u32 {
        passes
    }

    #[inline(always)]
    fn written(&self) -> u32 {
        u32::MAX
    }
}

/// Any state. Passes where one of three comparisons does that the state asks for.
#[derive(Clone, Copy)]
pub(super) struct Any {
    less: u32,
    equal: u32,
    greater: u32,
    tests: u32,
    written: u32,
}

impl Any {
    pub(super) fn new(state: DepthState) -> Self {
        let passes = |new: f32| mask(!state.test || state.compare.passes(new, 0.0));
        Self {
            less: passes(-1.0),
            equal: passes(0.0),
            greater: passes(1.0),
            tests: mask(state.test),
            written: mask(state.test && state.write),
        }
    }
}

impl Test for Any {
    #[inline(always)]
    fn passes(&self, new: f32, stored: f32) -> u32 {
        self.less & mask(new < stored) | self.equal & mask(new == stored) | self.greater & mask(new > stored)
    }

    #[inline(always)]
    fn matters(&self, covered: u32, _: u32) -> u32 {
        covered & self.tests
    }

    #[inline(always)]
    fn written(&self) -> u32 {
        self.written
    }
}
