//! The depth test of many pixels at once.

use super::{
    DepthStore,
    fill::Subject,
    lanes::{greatest, least, mask},
    pixels::Pixels,
};
use crate::depth::DepthState;

/// Decides about depths that are known as intervals.
pub(super) trait Test: Copy {
    /// Whether there is a stencil test before.
    const STENCIL: bool;

    /// What is stored for a depth that lies between two: that for the least and that for the greatest.
    fn ends(&self, near: f64, far: f64) -> [f32; 2];

    /// The same for the pixels of a row.
    #[inline(always)]
    fn row<const N: usize>(&self, pixels: &Pixels<'_, N>, _: &Subject<'_>) -> [[f32; N]; 2] {
        pixels.start.along(pixels.across)
    }

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
    const STENCIL: bool = false;

    #[inline(always)]
    fn ends(&self, near: f64, far: f64) -> [f32; 2] {
        [near as f32, far as f32]
    }

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
    const STENCIL: bool = false;

    #[inline(always)]
    fn ends(&self, near: f64, far: f64) -> [f32; 2] {
        [near as f32, far as f32]
    }

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

/// Any state over the codes of a unorm format, which binary32 holds as whole numbers.
#[derive(Clone, Copy)]
pub(super) struct Codes {
    state: Any,
    max: f64,
}

impl Codes {
    /// `None` for a format that stores the depth itself.
    pub(super) fn new(state: DepthState, store: DepthStore) -> Option<Self> {
        Some(Self { state: Any::new(state), max: f64::from(store.max_code()?) })
    }

    /// The code of a depth is `floor(max z + 1/2)`, within the codes. `slack` is more than what the product and
    /// the sum, below 2^25, are off by.
    #[inline(always)]
    fn code(self, depth: f64, slack: f64) -> f32 {
        greatest(least((depth * self.max + 0.5 + slack).floor(), self.max), 0.0) as f32
    }
}

impl Test for Codes {
    const STENCIL: bool = false;

    #[inline(always)]
    fn ends(&self, near: f64, far: f64) -> [f32; 2] {
        const SLACK: f64 = 1.0 / (1 << 24) as f64;
        [self.code(near, -SLACK), self.code(far, SLACK)]
    }

    #[inline(always)]
    fn row<const N: usize>(&self, pixels: &Pixels<'_, N>, subject: &Subject<'_>) -> [[f32; N]; 2] {
        let (mut low, mut high) = ([0.0; N], [0.0; N]);
        for i in 0..N {
            let [near, far] = pixels.place.interval(i, subject);
            [low[i], high[i]] = self.ends(near, far);
        }
        [low, high]
    }

    #[inline(always)]
    fn passes(&self, new: f32, stored: f32) -> u32 {
        self.state.passes(new, stored)
    }

    #[inline(always)]
    fn matters(&self, covered: u32, passes: u32) -> u32 {
        self.state.matters(covered, passes)
    }

    #[inline(always)]
    fn written(&self) -> u32 {
        self.state.written()
    }
}

/// The same behind a stencil test.
#[derive(Clone, Copy)]
pub(super) struct Masked<T>(pub(super) T);

impl<T: Test> Test for Masked<T> {
    const STENCIL: bool = true;

    #[inline(always)]
    fn ends(&self, near: f64, far: f64) -> [f32; 2] {
        self.0.ends(near, far)
    }

    #[inline(always)]
    fn passes(&self, new: f32, stored: f32) -> u32 {
        self.0.passes(new, stored)
    }

    #[inline(always)]
    fn matters(&self, covered: u32, passes: u32) -> u32 {
        self.0.matters(covered, passes)
    }

    #[inline(always)]
    fn written(&self) -> u32 {
        self.0.written()
    }
}
