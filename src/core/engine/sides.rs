//! Where the rows of a tile cross the edges of a few triangles, with a proven error.
//!
//! Coordinates are those of the tile: the centre of its first pixel is (0, 0).
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 3.6; Higham, Accuracy and
//! Stability of Numerical Algorithms, 2nd ed. 2002, section 3.1 (the errors). Deviation: nothing is added from row to
//! row, and each number is an interval around the exact one.

use super::{
    canvas::TILE,
    lanes::{LANES, Wide, greatest, least},
};

/// The unit roundoff of binary64.
const U: f64 = f64::EPSILON / 2.0;

/// The last centre of a tile, as a coordinate.
const END: f64 = (TILE - 1) as f64;

/// Where rows cross an edge: `x = start + (row - y) slope`, with the start moved outwards to the left by the error;
/// infinitely far for a side that the edge does not bound.
#[derive(Clone, Copy)]
pub(super) struct Crossings {
    pub(super) y: Wide,
    pub(super) slope: Wide,
    /// The start of a left edge, and of a right one.
    pub(super) left: Wide,
    pub(super) right: Wide,
}

const NOTHING: Crossings =
    Crossings { y: [0.0; LANES], slope: [0.0; LANES], left: [0.0; LANES], right: [0.0; LANES] };

/// The sides of a few triangles.
#[derive(Clone, Copy)]
pub(super) struct Sides {
    pub(super) edges: [Crossings; 3],
    /// How far to the right of where they seem to be crossings lie at most.
    pub(super) doubt: Wide,
}

impl Sides {
    /// None.
    #[inline(always)]
    pub(super) fn none() -> Self {
        Self { edges: [NOTHING; 3], doubt: [0.0; LANES] }
    }

    /// Those of triangles that turn in a way each: 1, -1, or 0 without an area. `shift` takes their vertices to the tile.
    #[inline(always)]
    pub(super) fn new(vertices: &[[Wide; 3]; 3], turns: &Wide, shift: [f64; 3]) -> Self {
        let mut sides = Self::none();
        for edge in 0..3 {
            sides.edge(edge, [&vertices[edge], &vertices[(edge + 1) % 3]], turns, shift);
        }
        sides
    }

    /// Where rows cross the edge from `p` to `q`.
    ///
    /// The slope is off by at most three roundings, the height above `p` by one and that of `p` itself, their
    /// product by one more; `p` and each of two sums by one: below `7u |slope| (|y| + 64) + 3u |x|`. Twice that, and a
    /// little for adding it to a column of the tile, is how far to the right a crossing may lie of where it is put.
    #[inline(always)]
    fn edge(&mut self, edge: usize, [p, q]: [&[Wide; 3]; 2], turns: &Wide, shift: [f64; 3]) {
        const TIE: f64 = 256.0 * U;
        let crossings = &mut self.edges[edge];
        for i in 0..LANES {
            let (x, y) = (p[0][i] - shift[0], p[1][i] - shift[1]);
            let height = q[1][i] - p[1][i];
            let level = height == 0.0;
            let slope = (q[0][i] - p[0][i]) / if level { 1.0 } else { height };
            let error = 8.0 * U * (slope.abs() * (y.abs() + 64.0) + x.abs());
            // Turned positively, edges that go towards smaller y have the inside to their right.
            let uphill = height * turns[i];
            let left = if uphill < 0.0 { 0.0 } else { f64::NEG_INFINITY };
            let right = if uphill > 0.0 { 0.0 } else { f64::INFINITY };
            crossings.y[i] = y;
            crossings.slope[i] = if level { 0.0 } else { slope };
            crossings.left[i] = x - error + left;
            crossings.right[i] = x - error + right;
            self.doubt[i] = greatest(self.doubt[i], 2.001 * error + TIE);
        }
    }

    /// Which triangles lie beside the tile: 1, else 0. One edge keeps out its nearest corner.
    #[inline(always)]
    pub(super) fn beside(&self) -> [u32; LANES] {
        let mut beside = [0; LANES];
        for crossings in &self.edges {
            for i in 0..LANES {
                let slope = crossings.slope[i];
                let (top, bottom) = (-crossings.y[i] * slope, (END - crossings.y[i]) * slope);
                let left = least(top, bottom) + crossings.left[i];
                let right = greatest(top, bottom) + crossings.right[i] + self.doubt[i];
                beside[i] |= u32::from(left > END) | u32::from(right < 0.0);
            }
        }
        beside
    }
}
