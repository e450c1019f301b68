//! The depth test of many pixels at once.

use super::{
    DepthStore,
    fill::Subject,
    lanes::{greatest, least, mask},
    pixels::Pixels,
    stamp::{Each, STAMP},
};
use crate::depth::DepthState;

/// Decides about depths that are known as intervals. Unless a test says otherwise, binary32 is stored, and whenever a
/// depth passes.
pub(super) trait Test: Copy {
    /// Whether there is a stencil test before.
    const STENCIL: bool = false;

    /// Whether a pixel may still change where depths are equal.
    const TIES: bool = false;

    /// What would be stored for the least depth that each pixel of a stamp may have, and for the greatest.
    #[inline(always)]
    fn stamp(&self, pixels: &Pixels<'_>, _: &Subject<'_>) -> [Each<f32>; 2] {
        pixels.start.along(pixels.across)
    }

    /// All bits if a depth passes against the stored one, else none. The two are what the pixel would hold as its
    /// colour, and what it holds.
    fn passes(&self, depths: [f32; 2], colors: [u32; 2]) -> u32;

    /// All bits if it matters that the two ends of an interval differ, for a pixel that is covered (or not) and
    /// passes (or not) at the near end.
    #[inline(always)]
    fn matters(&self, _covered: u32, passes: u32) -> u32 {
        passes
    }

    /// The bits of a depth that are stored.
    #[inline(always)]
    fn written(&self) -> u32 {
        u32::MAX
    }
}

/// Less, and stored. What is not less at its least is not less.
#[derive(Clone, Copy)]
pub(super) struct Nearer;

impl Test for Nearer {
    #[inline(always)]
    fn passes(&self, [new, stored]: [f32; 2], _: [u32; 2]) -> u32 {
        mask(new < stored)
    }
}

/// The same in any order of drawing: colours are places in the list, and of equal depths that of the first wins.
#[derive(Clone, Copy)]
pub(super) struct First;

impl Test for First {
    const TIES: bool = true;

    #[inline(always)]
    fn passes(&self, [new, stored]: [f32; 2], [place, painted]: [u32; 2]) -> u32 {
        mask(new < stored) | mask(new == stored) & mask(place < painted)
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
    fn passes(&self, [new, stored]: [f32; 2], _: [u32; 2]) -> u32 {
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
    #[inline(always)]
    fn stamp(&self, pixels: &Pixels<'_>, subject: &Subject<'_>) -> [Each<f32>; 2] {
        const SLACK: f64 = 1.0 / (1 << 24) as f64;
        let (mut low, mut high) = ([0.0; STAMP], [0.0; STAMP]);
        for i in 0..STAMP {
            let [near, far] = subject.setup.interval(subject.lane, pixels.place.pixel(i));
            [low[i], high[i]] = [self.code(near, -SLACK), self.code(far, SLACK)];
        }
        [low, high]
    }

    #[inline(always)]
    fn passes(&self, depths: [f32; 2], colors: [u32; 2]) -> u32 {
        self.state.passes(depths, colors)
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
    fn stamp(&self, pixels: &Pixels<'_>, subject: &Subject<'_>) -> [Each<f32>; 2] {
        self.0.stamp(pixels, subject)
    }

    #[inline(always)]
    fn passes(&self, depths: [f32; 2], colors: [u32; 2]) -> u32 {
        self.0.passes(depths, colors)
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
