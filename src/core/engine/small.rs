//! Small triangles: the half-planes of the edges of a few at once, in binary32, and the stamps that each may meet.
//!
//! *Source:* Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; McCormack and McNamara, Tiled Polygon
//! Traversal Using Half-Plane Edge Functions, Graphics Hardware 2000; Higham, Accuracy and Stability of Numerical
//! Algorithms, 2nd ed. 2002, section 3.1 (the error). Deviation: what the error leaves open is decided exactly.

use super::{
    depths::Starts,
    group::Group,
    lanes::{LANES, Wide, larger, mask},
    setup::Setup,
    stamp::{Each, SIDE, STAMP, Steps},
};

/// Most stamps beside and above each other that a small triangle may meet, and all of them.
pub(super) const GRID: usize = 4;
pub(super) const PIECES: usize = GRID * GRID;

/// Most stamps beside and above each other of a tiny one.
pub(super) const TINY: usize = 2;

/// The unit roundoff of binary32.
const U: f32 = f32::EPSILON / 2.0;

/// Half-planes whose error is at least this are not looked at in binary32.
const BLURRED: f32 = 1e20;

/// One binary32 number a lane.
pub(super) type Narrow = [f32; LANES];

/// A few triangles of which some are small.
#[repr(align(64))]
pub(super) struct Small {
    /// Which are.
    pub(super) fits: [bool; LANES],
    /// Column and row of the first stamp's first pixel, and how many stamps stand beside and above each other.
    pub(super) first: [[u32; LANES]; 2],
    pub(super) stamps: [[u32; LANES]; 2],
    /// The half-planes of the edges, positive inside, in square pixels: at the centre of that pixel, and what they grow
    /// by from column to column and from row to row; how far any of them is off at most inside, not finite if that is not
    /// known.
    at: [Narrow; 3],
    pub(super) right: [Narrow; 3],
    down: [Narrow; 3],
    pub(super) error: Narrow,
    /// What they are where each stamp begins, and the depths there.
    pub(super) begin: [[Narrow; 3]; PIECES],
    pub(super) starts: [Starts; PIECES],
    /// Whether something of a stamp may be covered: 1, else 0.
    pub(super) some: [[u32; LANES]; PIECES],
    /// Whether all triangles are tiny.
    pub(super) tiny: bool,
    pub(super) steps: Steps,
}

impl Small {
    /// None.
    pub(super) fn none() -> Self {
        Self {
            fits: [false; LANES],
            first: [[0; LANES]; 2],
            stamps: [[0; LANES]; 2],
            at: [[0.0; LANES]; 3],
            right: [[0.0; LANES]; 3],
            down: [[0.0; LANES]; 3],
            error: [0.0; LANES],
            begin: [[[0.0; LANES]; 3]; PIECES],
            starts: [Starts::NOTHING; PIECES],
            some: [[0; LANES]; PIECES],
            tiny: false,
            steps: Steps::new(),
        }
    }

    /// Takes triangles whose planes, rows and columns are known.
    ///
    /// With d a difference of two vertices and p one of a vertex and the first centre, each rounded once, a half-plane is
    /// `dx (py + row) - dy (px + column)`. No term of it goes through more than nine roundings, so it is off by at
    /// most `9u T`, T being the sum of the terms' magnitudes at the last pixel; what is left of 10 covers the
    /// roundings of the bound itself. Products that underflow are off by less than the least normal number, too.
    #[inline(always)]
    pub(super) fn set_up(&mut self, setup: &Setup, group: &Group, origin: [u32; 2]) {
        let (mut x, mut y): (Narrow, Narrow) = ([0.0; LANES], [0.0; LANES]);
        let mut far = [0.0; LANES];
        let mut most = [TINY as u32; 2];
        for i in 0..LANES {
            let ends = [[setup.columns[0][i], setup.columns[1][i]], [setup.rows[0][i], setup.rows[1][i]]];
            let first = ends.map(|[first, _]| first & !(SIDE as u32 - 1));
            let [across, high] = [0, 1].map(|axis| {
                let pixels = ends[axis][1].wrapping_sub(first[axis]) as i32;
                (pixels + (SIDE as i32 - 1)) >> SIDE.ilog2()
            });
            let fits = (across <= GRID as i32) & (high <= GRID as i32);
            self.fits[i] = fits;
            // Where there are more, blocks may begin before the first.
            far[i] = (across.max(high).max(GRID as i32) * SIDE as i32) as f32;
            x[i] = (origin[0] + first[0]) as i32 as f32 + 0.5;
            y[i] = (origin[1] + first[1]) as i32 as f32 + 0.5;
            for (axis, count) in [across, high].into_iter().enumerate() {
                self.first[axis][i] = first[axis];
                self.stamps[axis][i] = if fits & (count > 0) { count as u32 } else { 0 };
                most[axis] = most[axis].max(self.stamps[axis][i]);
            }
        }
        let mut terms = [0.0; LANES];
        for edge in 0..3 {
            let [p, q] = [&group.corners[edge], &group.corners[(edge + 1) % 3]];
            for i in 0..LANES {
                let (px, py) = (x[i] - p[0][i], y[i] - p[1][i]);
                let turn = setup.turns[i] as f32;
                let (dx, dy) = ((q[0][i] - p[0][i]) * turn, (q[1][i] - p[1][i]) * turn);
                self.at[edge][i] = dx * py - dy * px;
                self.right[edge][i] = -dy;
                self.down[edge][i] = dx;
                let sum = dx.abs() * (py.abs() + far[i]) + dy.abs() * (px.abs() + far[i]);
                terms[i] = if sum > terms[i] { sum } else { terms[i] };
            }
        }
        for i in 0..LANES {
            self.error[i] = 10.0 * U * terms[i] + f32::MIN_POSITIVE;
            // What is not a number is less than nothing.
            self.fits[i] &= self.error[i] < BLURRED;
        }
        self.tiny = most == [TINY as u32; 2];
        self.begin_stamps(setup, most);
    }

    /// Finds where all stamps begin, and which of them may be covered.
    #[inline(always)]
    fn begin_stamps(&mut self, setup: &Setup, [across, high]: [u32; 2]) {
        let (mut left, mut top): (Wide, Wide) = ([0.0; LANES], [0.0; LANES]);
        // What the half-planes may be greater by in the stamp's best corner.
        let mut reach: [Narrow; 3] = [[0.0; LANES]; 3];
        for i in 0..LANES {
            left[i] = f64::from(self.first[0][i] as i32);
            top[i] = f64::from(self.first[1][i] as i32);
            for edge in 0..3 {
                const LAST: f32 = (SIDE - 1) as f32;
                let (right, down) = (self.right[edge][i], self.down[edge][i]);
                reach[edge][i] = larger(right * LAST, 0.0) + larger(down * LAST, 0.0) + self.error[i];
            }
        }
        let mut y = top;
        for row in 0..GRID.min(high as usize) {
            let mut x = left;
            for column in 0..GRID.min(across as usize) {
                let piece = row * GRID + column;
                let mut some = [0; LANES];
                for i in 0..LANES {
                    let [across, high] = [self.stamps[0][i], self.stamps[1][i]];
                    some[i] = mask((column as u32) < across) & mask((row as u32) < high);
                }
                for edge in 0..3 {
                    for i in 0..LANES {
                        let down = self.at[edge][i] + self.down[edge][i] * (row * SIDE) as i32 as f32;
                        let begin = down + self.right[edge][i] * (column * SIDE) as i32 as f32;
                        self.begin[piece][edge][i] = begin;
                        some[i] &= mask(begin + reach[edge][i] >= 0.0);
                    }
                }
                for i in 0..LANES {
                    self.some[piece][i] = some[i] & 1;
                }
                self.starts[piece] = setup.starts_of_all([&x, &y]);
                x = x.map(
                    #[inline(always)]
                    |x| x + SIDE as f64,
                );
            }
            y = y.map(
                #[inline(always)]
                |y| y + SIDE as f64,
            );
        }
    }

    /// What the pixels of a stamp add to the half-planes of a triangle.
    #[inline(always)]
    pub(super) fn offsets(&self, lane: usize) -> [Each<f32>; 3] {
        let Steps { x, y } = &self.steps;
        let mut offsets = [[0.0; STAMP]; 3];
        for edge in 0..3 {
            for i in 0..STAMP {
                offsets[edge][i] = self.right[edge][lane] * x[i] + self.down[edge][lane] * y[i];
            }
        }
        offsets
    }

    /// The half-planes of any triangle where some stamps begin, given their first columns and rows.
    #[inline(always)]
    pub(super) fn begins(&self, lane: usize, [x, y]: [&Wide; 2]) -> [Narrow; 3] {
        let mut begins = [[0.0; LANES]; 3];
        let [left, top] = [self.first[0][lane] as i32 as f32, self.first[1][lane] as i32 as f32];
        for edge in 0..3 {
            for i in 0..LANES {
                let down = self.at[edge][lane] + self.down[edge][lane] * (y[i] as f32 - top);
                begins[edge][i] = down + self.right[edge][lane] * (x[i] as f32 - left);
            }
        }
        begins
    }
}
