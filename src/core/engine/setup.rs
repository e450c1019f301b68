//! Triangle set-up: how deep the plane lies and which rows and columns there are, for a few triangles at once and with a
//! proven error for every number.
//!
//! Coordinates are those of the tile: the centre of its first pixel is (0, 0).
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 15.4; Higham,
//! Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002, section 3.1 (the errors). Deviation: nothing is
//! added from row to row, and each number is an interval around the exact one.

use super::{
    Stats,
    canvas::TILE,
    group::Group,
    lanes::{LANES, Wide, greatest, larger, least, lesser, whole},
    sides::Sides,
    small::{Narrow, Small},
    stamp::SIDE,
    state::Rules,
};
use crate::math::{Sign, Tally, orient2d, predicates::ORIENT2D_FILTER};

/// The unit roundoff of binary64.
const U: f64 = f64::EPSILON / 2.0;

/// The bits of infinity; those of an exponent.
const INFINITY: u64 = f64::INFINITY.to_bits();

/// Depths between these are known, and 0: at greater ones binary32 overflows, at lesser ones it underflows.
const HIGHEST: f64 = power(100);
const LOWEST: f64 = power(-80);

/// Of the greatest depth's power of 2: what rounds to the grid, and what the roundings of binary32 come to.
const ANCHOR: f64 = 1.5 * power(52 - 23);
const SLACK: f64 = power(-23 - 20);

/// 2 to a power.
const fn power(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// What a pixel to the right, or down, takes from the depth: a multiple of the grid, and the rest.
#[derive(Clone, Copy)]
pub(super) struct Step {
    pub(super) grid: Narrow,
    pub(super) rest: Narrow,
}

impl Step {
    const NOTHING: Self = Self { grid: [0.0; LANES], rest: [0.0; LANES] };

    #[inline(always)]
    fn put(&mut self, i: usize, slope: f64, anchor: f64) {
        let grid = (-slope + anchor) - anchor;
        self.grid[i] = grid as f32;
        self.rest[i] = (grid + slope) as f32;
    }
}

/// A few triangles, ready for the rows of one tile.
#[repr(align(64))]
pub(super) struct Setup {
    /// First and one past the last row and column that can be covered; no rows if nothing is.
    pub(super) rows: [[u32; LANES]; 2],
    pub(super) columns: [[u32; LANES]; 2],
    /// The depth at (0, 0), and how it grows with x and y.
    pub(super) depth: Wide,
    pub(super) dz_dx: Wide,
    pub(super) dz_dy: Wide,
    /// How far a depth is off at most; infinite if nothing is known.
    pub(super) error: Wide,
    /// Adding this, then subtracting it, leaves a multiple of the grid of [`Across`](super::depths::Across); and how far
    /// off a depth may be that is computed in that way.
    pub(super) anchor: Wide,
    pub(super) slack: Narrow,
    /// What each column and each row adds, on that grid.
    pub(super) steps: [Step; 2],
    /// The least and the greatest depth of the vertices.
    pub(super) range: [Wide; 2],
    /// Which of them lie behind all pixels of the tile, if they are counted nevertheless.
    pub(super) behind: [bool; LANES],
    /// Which way each triangle turns: 1, -1, or 0 if it has no area.
    pub(super) turns: Wide,
    /// Twice its area, turned positive, in square pixels.
    pub(super) area: Wide,
}

impl Setup {
    /// Up to [`LANES`] triangles seen from the tile whose first pixel is `origin`, and of which no pixel is
    /// farther than `farthest`. What small ones need goes to `small`; only if there are others, sides are found.
    #[inline(always)]
    pub(super) fn new(
        group: &Group,
        (small, sides): (&mut Small, &mut Sides),
        (origin, farthest): ([u32; 2], f32),
        rules: &Rules,
        stats: &mut Stats,
    ) -> Self {
        let mut vertices = [[[0.0; LANES]; 3]; 3];
        let shift = [origin[0] as f64 + 0.5, origin[1] as f64 + 0.5, 0.0];
        for corner in 0..3 {
            for axis in 0..3 {
                vertices[corner][axis] = group.corners[corner][axis].map(f64::from);
            }
        }
        let mut setup = Self {
            rows: [[0; LANES]; 2],
            columns: [[0; LANES]; 2],
            depth: [0.0; LANES],
            dz_dx: [0.0; LANES],
            dz_dy: [0.0; LANES],
            error: [0.0; LANES],
            anchor: [0.0; LANES],
            slack: [0.0; LANES],
            steps: [Step::NOTHING; 2],
            range: [[0.0; LANES]; 2],
            behind: [false; LANES],
            turns: [0.0; LANES],
            area: [0.0; LANES],
        };
        setup.plane(&vertices, group, shift, stats);
        setup.bounds(group, origin, rules);
        small.set_up(&setup, group, origin);
        // Small ones are found beside the tile as soon.
        if small.fits.iter().any(|fits| !fits) {
            *sides = Sides::new(&vertices, &setup.turns, shift);
            if rules.tile {
                setup.reject(&sides.beside(), stats);
            }
        }
        if rules.hierarchical_z {
            setup.hide(farthest, rules, stats);
        }
        setup
    }

    /// The plane of depths, and which way each triangle turns.
    ///
    /// With `l` and `r` the products of rounded differences, a determinant `l - r` is off by at most
    /// `4u (|l| + |r|)`. A slope is a quotient of two; while the area is known within a half, that of its
    /// error's is within twice `(e + |slope| E) / |area|`. On the way to a depth each term goes through at most
    /// seven roundings. All constants are a little greater, for the roundings of the bounds themselves.
    ///
    /// A power of 2, at most the greatest depth `m` and more than half of it, makes the grid of [`Across`]: multiples of
    /// `2^-23` of it, which binary32 holds up to `m`. Rests are at most half a step. In units of `2^-25` steps, that of a
    /// stamp's start is rounded twice by 1; that of a step by 1, three times that by 2 more, and the sum of two such by 4:
    /// 14; the sum of both by 4. All this is less than 32 of them, the slack.
    ///
    /// [`Across`]: super::depths::Across
    #[inline(always)]
    fn plane(&mut self, [a, b, c]: &[[Wide; 3]; 3], group: &Group, shift: [f64; 3], stats: &mut Stats) {
        let mut doubt = [false; LANES];
        for i in 0..LANES {
            let (ax, ay, az) = (a[0][i], a[1][i], a[2][i]);
            let (bx, by, bz) = (b[0][i] - ax, b[1][i] - ay, b[2][i] - az);
            let (cx, cy, cz) = (c[0][i] - ax, c[1][i] - ay, c[2][i] - az);
            let (l, r) = (bx * cy, by * cx);
            let area = l - r;
            self.area[i] = area.abs();
            let size = l.abs() + r.abs();
            doubt[i] = (area.abs() <= ORIENT2D_FILTER * size) & (size > 0.0);
            let turn = if area > 0.0 { 1.0 } else { -1.0 };
            self.turns[i] = if size > 0.0 { turn } else { 0.0 };
            let inverse = 1.0 / area;
            let (l, r) = (bz * cy, by * cz);
            let (dx, size_x) = ((l - r) * inverse, l.abs() + r.abs());
            let (l, r) = (bx * cz, bz * cx);
            let (dy, size_y) = ((l - r) * inverse, l.abs() + r.abs());
            let (sx, sy) = (dx.abs(), dy.abs());
            let scale = 9.0 * U * inverse.abs();
            let error_x = scale * (size_x + sx * size) + 4.0 * U * sx;
            let error_y = scale * (size_y + sy * size) + 4.0 * U * sy;
            let wide = greatest(greatest(bx.abs(), cx.abs()), (b[0][i] - c[0][i]).abs());
            let high = greatest(greatest(by.abs(), cy.abs()), (b[1][i] - c[1][i]).abs());
            let (x, y) = (ax - shift[0], ay - shift[1]);
            let (far_x, far_y) = (x.abs() + 64.0, y.abs() + 64.0);
            let error = error_x * wide + error_y * high + 9.0 * U * (az.abs() + sx * far_x + sy * far_y);
            let depth = az - dx * x - dy * y;
            let (bz, cz) = (b[2][i], c[2][i]);
            let range = [least(least(az, bz), cz), greatest(greatest(az, bz), cz)];
            // Where a stamp begins that has a pixel of the triangle, no depth is greater, nor are its parts on the grid.
            let most = 1.001 * (greatest(range[0].abs(), range[1].abs()) + SIDE as f64 * (sx + sy));
            let power = f64::from_bits(most.to_bits() & INFINITY);
            let held = (most < HIGHEST) & ((most > LOWEST) | (most == 0.0));
            let known = (area.abs() > 16.0 * U * size) & held;
            self.range[0][i] = range[0];
            self.range[1][i] = range[1];
            self.depth[i] = if known { depth } else { 0.0 };
            self.dz_dx[i] = if known { dx } else { 0.0 };
            self.dz_dy[i] = if known { dy } else { 0.0 };
            self.error[i] = if known { error } else { f64::INFINITY };
            self.anchor[i] = if known { ANCHOR * power } else { 0.0 };
            self.steps[0].put(i, self.dz_dx[i], self.anchor[i]);
            self.steps[1].put(i, self.dz_dy[i], self.anchor[i]);
            self.slack[i] = (1.000_001 * (self.error[i] + SLACK * power)) as f32;
        }
        if doubt.iter().any(|&doubt| doubt) {
            turn_exactly(&mut self.turns, &doubt, group, stats);
        }
    }

    /// Rows and columns of the centres in the triangle's box, as far as they lie in the tile.
    ///
    /// Rows through the highest or lowest vertex count only where a horizontal edge there is drawn: above all
    /// others no pixel lies between a left and a right edge, unless both draw their ties.
    ///
    /// In binary32: what is subtracted rounds only where the result lies before the tile, and never across an integer.
    #[inline(always)]
    fn bounds(&mut self, group: &Group, origin: [u32; 2], rules: &Rules) {
        const LAST: f32 = (TILE - 1) as f32;
        let [x, y] = origin.map(|at| at as f32 + 0.5);
        let [[ax, ay, _], [bx, by, _], [cx, cy, _]] = &group.corners;
        for i in 0..LANES {
            let first = (lesser(lesser(ax[i], bx[i]), cx[i]) - x).ceil();
            let last = (larger(larger(ax[i], bx[i]), cx[i]) - x).floor();
            self.columns[0][i] = whole(lesser(larger(first, 0.0), LAST));
            self.columns[1][i] = whole(lesser(larger(last, 0.0), LAST)) + 1;
            let [ay, by, cy] = [ay[i], by[i], cy[i]];
            let (highest, lowest) = (lesser(lesser(ay, by), cy), larger(larger(ay, by), cy));
            let (top, bottom) = (highest - y, lowest - y);
            let (first, last) = (top.ceil(), bottom.floor());
            // How many vertices are as high: two make a horizontal edge.
            let one = |equal: bool| if equal { 1.0_f32 } else { 0.0 };
            let count = |at: f32| one(at == ay) + one(at == by) + one(at == cy);
            let closed = count(highest) + rules.first_row > 2.5;
            let first = if (first == top) & !closed { first + 1.0 } else { first };
            let closed = count(lowest) + rules.last_row > 2.5;
            let last = if (last == bottom) & !closed { last - 1.0 } else { last };
            let end = if self.turns[i] as f32 == 0.0 { 0.0 } else { last + 1.0 };
            self.rows[0][i] = whole(lesser(larger(first, 0.0), LAST + 1.0));
            self.rows[1][i] = whole(lesser(larger(end, 0.0), LAST + 1.0));
        }
    }
}

impl Setup {
    /// Empties the rows of triangles that lie beside the tile.
    #[inline(always)]
    fn reject(&mut self, beside: &[u32; LANES], stats: &mut Stats) {
        for i in 0..LANES {
            let any = u32::from(self.rows[0][i] < self.rows[1][i]);
            stats.beside += u64::from(beside[i] & any);
            self.rows[1][i] *= 1 - beside[i];
        }
    }

    /// Empties the rows of triangles that lie behind all pixels of the tile, unless they are to be counted.
    #[inline(always)]
    fn hide(&mut self, farthest: f32, rules: &Rules, stats: &mut Stats) {
        let farthest = f64::from(farthest);
        let mut any = 0;
        for i in 0..LANES {
            any |= u32::from(self.range[1][i] >= farthest);
        }
        if any == 0 {
            return;
        }
        for i in 0..LANES {
            let hidden = u32::from(self.nearest(i) >= farthest);
            let any = u32::from(self.rows[0][i] < self.rows[1][i]);
            stats.behind += u64::from(hidden & any);
            self.behind[i] = hidden != 0;
            self.rows[1][i] *= 1 - (hidden & u32::from(!rules.counts));
        }
    }

    /// Whether nothing of the triangle in a lane can be covered.
    #[inline(always)]
    pub(super) fn is_empty(&self, lane: usize) -> bool {
        self.rows[0][lane] >= self.rows[1][lane]
    }

    /// No pixel of the rows and columns of the triangle in a lane is nearer.
    #[inline(always)]
    pub(super) fn nearest(&self, i: usize) -> f64 {
        let [left, right] =
            [f64::from(self.columns[0][i] as i32), f64::from(self.columns[1][i] as i32) - 1.0];
        let [top, bottom] = [f64::from(self.rows[0][i] as i32), f64::from(self.rows[1][i] as i32) - 1.0];
        let (dx, dy) = (self.dz_dx[i], self.dz_dy[i]);
        let near =
            self.depth[i] + least(dy * top, dy * bottom) + least(dx * left, dx * right) - self.error[i];
        greatest(near, self.range[0][i])
    }
}

/// Turns that the determinant's error leaves open.
#[cold]
#[inline(never)]
fn turn_exactly(turns: &mut Wide, doubt: &[bool; LANES], group: &Group, stats: &mut Stats) {
    for i in 0..LANES {
        if doubt[i] {
            let [a, b, c] = group.triangle(i).map(|[x, y, _]| [x, y]);
            turns[i] = match orient2d(a, b, c, &mut Tally::default()) {
                Sign::Positive => 1.0,
                Sign::Negative => -1.0,
                Sign::Zero => 0.0,
            };
            stats.exact_turns += 1;
        }
    }
}
