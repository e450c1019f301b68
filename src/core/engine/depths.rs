//! The depths of a stamp's pixels, in binary32: all at once, with a proven error.
//!
//! A depth is the sum of what its stamp begins with and what its column and its row add. All of these are split in two: a
//! multiple of a grid that binary32 holds up to the greatest depth, and a rest of at most half a step. The multiples add
//! up exactly and the rests nearly so; the last sum, of both, is the only one that rounds. Done for both ends of an
//! interval, it gives the correctly rounded depth where the ends agree.
//!
//! *Source:* Dekker, A Floating-Point Technique for Extending the Available Precision, 1971 (numbers in two pieces);
//! Rump, Ogita, Oishi, Accurate Floating-Point Summation, 2008 (pieces on one grid, so that their sum is exact).

use super::{
    lanes::{LANES, Wide},
    setup::Setup,
    stamp::{Each, STAMP, Steps},
};

/// What the pixels of a stamp take away, from the first one on: on the grid, and the rest.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(super) struct Across {
    grid: Each<f32>,
    rest: Each<f32>,
}

impl Across {
    /// None.
    pub(super) const NOTHING: Self = Self { grid: [0.0; STAMP], rest: [0.0; STAMP] };
}

/// What stamps begin with on the grid, and less the rest: a little too near and too far.
///
/// Everything is subtracted, for the compiler exchanges the terms of sums when it looks for what can be done in
/// lanes, and then has to exchange the lanes.
#[derive(Clone, Copy)]
pub(super) struct Starts {
    grid: [f32; LANES],
    near: [f32; LANES],
    far: [f32; LANES],
}

impl Starts {
    /// None.
    pub(super) const NOTHING: Self = Self { grid: [0.0; LANES], near: [0.0; LANES], far: [0.0; LANES] };

    /// Puts in what one lane begins with: `depth`, known up to `slack`.
    #[inline(always)]
    fn put(&mut self, i: usize, depth: f64, slack: f32, anchor: f64) {
        let grid = (depth + anchor) - anchor;
        let rest = (grid - depth) as f32;
        // Adding zero leaves no -0, nor does any difference from what is not -0.
        self.grid[i] = grid as f32 + 0.0;
        self.near[i] = rest + slack;
        self.far[i] = rest - slack;
    }

    /// One of them.
    #[inline(always)]
    pub(super) fn at(&self, i: usize) -> Start {
        let i = i % LANES;
        Start { grid: self.grid[i], near: self.near[i], far: self.far[i] }
    }
}

/// What one stamp begins with.
#[derive(Clone, Copy)]
pub(super) struct Start {
    grid: f32,
    near: f32,
    far: f32,
}

impl Start {
    /// The depths of the pixels, a little too near and too far, each rounded to nearest.
    #[inline(always)]
    pub(super) fn along(self, across: &Across) -> [Each<f32>; 2] {
        let (mut near, mut far) = ([0.0; STAMP], [0.0; STAMP]);
        for i in 0..STAMP {
            let grid = self.grid - across.grid[i];
            near[i] = grid - (self.near - across.rest[i]);
            far[i] = grid - (self.far - across.rest[i]);
        }
        [near, far]
    }
}

impl Setup {
    /// What columns and rows add to the depth of the triangle in a lane.
    #[inline(always)]
    pub(super) fn across(&self, lane: usize, Steps { x, y }: &Steps) -> Across {
        let [column, row] = &self.steps;
        let mut across = Across::NOTHING;
        for i in 0..STAMP {
            across.grid[i] = column.grid[lane] * x[i] + row.grid[lane] * y[i];
            across.rest[i] = column.rest[lane] * x[i] + row.rest[lane] * y[i];
        }
        across
    }

    /// What the stamps of a block begin with in the triangle of a lane, given their first columns and rows.
    #[inline(always)]
    pub(super) fn starts(&self, lane: usize, [x, y]: [&Wide; 2]) -> Starts {
        let mut starts = Starts::NOTHING;
        for i in 0..LANES {
            let depth = (self.depth[lane] + self.dz_dy[lane] * y[i]) + self.dz_dx[lane] * x[i];
            starts.put(i, depth, self.slack[lane], self.anchor[lane]);
        }
        starts
    }

    /// What a stamp of each triangle begins with, given its first column and row.
    #[inline(always)]
    pub(super) fn starts_of_all(&self, [x, y]: [&Wide; 2]) -> Starts {
        let mut starts = Starts::NOTHING;
        for i in 0..LANES {
            let depth = (self.depth[i] + self.dz_dy[i] * y[i]) + self.dz_dx[i] * x[i];
            starts.put(i, depth, self.slack[i], self.anchor[i]);
        }
        starts
    }

    /// The depth of the triangle in a lane at a pixel, a little too near and too far.
    #[inline(always)]
    pub(super) fn interval(&self, lane: usize, [x, y]: [usize; 2]) -> [f64; 2] {
        let depth = (self.depth[lane] + self.dz_dy[lane] * y as f64) + self.dz_dx[lane] * x as f64;
        [depth - self.error[lane], depth + self.error[lane]]
    }
}
