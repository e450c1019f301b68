//! The depths of a row's pixels, in binary32: a few pixels at once, with a proven error.
//!
//! A depth is the sum of what its row begins with and what its column adds. Both are split in two: a multiple of a
//! grid that binary32 holds up to the greatest depth, and a rest of at most half a step. The multiples add up exactly
//! and the rests nearly so; the last sum, of both, is the only one that rounds. Done for both ends of an interval,
//! it gives the correctly rounded depth where the ends agree.
//!
//! *Source:* Dekker, A Floating-Point Technique for Extending the Available Precision, 1971 (numbers in two pieces);
//! Rump, Ogita, Oishi, Accurate Floating-Point Summation, 2008 (pieces on one grid, so that their sum is exact).

use super::{
    lanes::{LANES, Wide},
    setup::Setup,
};

/// What the columns take away, from the first one on: on the grid, and the rest.
#[derive(Clone, Copy)]
pub(super) struct Across<const N: usize> {
    grid: [f32; N],
    rest: [f32; N],
}

impl<const N: usize> Across<N> {
    /// None.
    pub(super) const NOTHING: Self = Self { grid: [0.0; N], rest: [0.0; N] };
}

/// What rows begin with on the grid, and less the rest: a little too near and too far.
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

/// What one row begins with.
#[derive(Clone, Copy)]
pub(super) struct Start {
    grid: f32,
    near: f32,
    far: f32,
}

impl Start {
    /// The depths along the row, a little too near and too far, each rounded to nearest.
    #[inline(always)]
    pub(super) fn along<const N: usize>(self, across: &Across<N>) -> [[f32; N]; 2] {
        let (mut near, mut far) = ([0.0; N], [0.0; N]);
        for i in 0..N {
            let grid = self.grid - across.grid[i];
            near[i] = grid - (self.near - across.rest[i]);
            far[i] = grid - (self.far - across.rest[i]);
        }
        [near, far]
    }
}

impl Setup {
    /// What the columns add to the depth of the triangle in a lane.
    #[inline(always)]
    pub(super) fn across<const N: usize>(&self, lane: usize) -> Across<N> {
        let (slope, anchor) = (self.dz_dx[lane], self.anchor[lane]);
        let mut across = Across { grid: [0.0; N], rest: [0.0; N] };
        for i in 0..N {
            let along = -slope * i as f64;
            let grid = (along + anchor) - anchor;
            across.grid[i] = grid as f32;
            across.rest[i] = (grid - along) as f32;
        }
        across
    }

    /// The depths at the first column of the tile in the rows from `top` on, of the triangle in a lane.
    #[inline(always)]
    pub(super) fn down(&self, lane: usize, top: usize) -> Wide {
        let mut down = [0.0; LANES];
        for i in 0..LANES {
            down[i] = self.depth[lane] + self.dz_dy[lane] * (top + i) as f64;
        }
        down
    }

    /// What these rows begin with at column `x`.
    #[inline(always)]
    pub(super) fn starts(&self, lane: usize, x: usize, down: &Wide) -> Starts {
        let mut starts = Starts::NOTHING;
        let along = self.dz_dx[lane] * x as f64;
        for i in 0..LANES {
            starts.put(i, down[i] + along, self.slack[lane], self.anchor[lane]);
        }
        starts
    }

    /// The depths of all triangles in the tile's first row, at column `x` of each.
    #[inline(always)]
    pub(super) fn at_columns(&self, x: &[u32; LANES]) -> Wide {
        let mut depths = [0.0; LANES];
        for i in 0..LANES {
            depths[i] = self.depth[i] + self.dz_dx[i] * f64::from(x[i] as i32);
        }
        depths
    }

    /// What row `y` of each triangle begins with, at the column of those depths.
    #[inline(always)]
    pub(super) fn starts_of_all(&self, depths: &Wide, y: &Wide) -> Starts {
        let mut starts = Starts::NOTHING;
        for i in 0..LANES {
            starts.put(i, depths[i] + self.dz_dy[i] * y[i], self.slack[i], self.anchor[i]);
        }
        starts
    }

    /// The depth of the triangle in a lane at a pixel, a little too near and too far.
    #[inline(always)]
    pub(super) fn interval(&self, lane: usize, x: usize, y: usize) -> [f64; 2] {
        let depth = (self.depth[lane] + self.dz_dy[lane] * y as f64) + self.dz_dx[lane] * x as f64;
        [depth - self.error[lane], depth + self.error[lane]]
    }
}
