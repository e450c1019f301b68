//! Triangle set-up: where rows cross the edges and how deep the plane lies, for a few triangles at once and
//! with a proven error for every number.
//!
//! Coordinates are those of the tile: the centre of its first pixel is (0, 0).
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed., sections 3.6 and 15.4; Higham,
//! Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002, section 3.1 (the errors). Deviation: nothing is
//! added from row to row, and each number is an interval around the exact one.

use super::{
    Stats,
    bins::Entry,
    canvas::TILE,
    lanes::{LANES, Wide, greatest, integer, least},
    state::Rules,
};
use crate::math::{Sign, Tally, orient2d, predicates::ORIENT2D_FILTER};

/// The unit roundoff of binary64.
const U: f64 = f64::EPSILON / 2.0;

/// The last centre of a tile, as a coordinate.
const END: f64 = (TILE - 1) as f64;

/// Where the rows of a tile cross an edge: `x = start + (row - y) slope`, with the start moved outwards to
/// both sides by the error; infinitely far for a side that the edge does not bound.
#[derive(Clone, Copy)]
pub(super) struct Crossings {
    pub(super) y: Wide,
    pub(super) slope: Wide,
    /// Of a left edge: a little too far left, and too far right.
    pub(super) left: [Wide; 2],
    /// Of a right edge, likewise.
    pub(super) right: [Wide; 2],
}

const NOTHING: Crossings =
    Crossings { y: [0.0; LANES], slope: [0.0; LANES], left: [[0.0; LANES]; 2], right: [[0.0; LANES]; 2] };

/// A few triangles, ready for the rows of one tile.
pub(super) struct Setup {
    pub(super) edges: [Crossings; 3],
    /// First and one past the last row and column that can be covered; no rows if nothing is.
    pub(super) rows: [[u32; LANES]; 2],
    pub(super) columns: [[u32; LANES]; 2],
    /// The depth at (0, 0), a little too near and too far, and how it grows with x and y.
    pub(super) depth: [Wide; 2],
    pub(super) dz_dx: Wide,
    pub(super) dz_dy: Wide,
    /// The least and the greatest depth of the vertices.
    pub(super) range: [Wide; 2],
    /// No pixel of these rows and columns is nearer.
    pub(super) nearest: Wide,
    /// Which of them lie behind all pixels of the tile, if they are counted nevertheless.
    pub(super) behind: [bool; LANES],
}

impl Setup {
    /// Up to [`LANES`] triangles seen from the tile whose first pixel is `origin`, and of which no pixel is
    /// farther than `farthest`.
    #[inline(always)]
    pub(super) fn new(
        entries: &[Entry],
        (origin, farthest): ([u32; 2], f32),
        rules: &Rules,
        stats: &mut Stats,
    ) -> Self {
        let mut vertices = [[[0.0; LANES]; 3]; 3];
        let shift = [origin[0] as f64 + 0.5, origin[1] as f64 + 0.5, 0.0];
        for (lane, Entry { corners, .. }) in entries.iter().take(LANES).enumerate() {
            for corner in 0..3 {
                for axis in 0..3 {
                    vertices[corner][axis][lane] = f64::from(corners[corner][axis]);
                }
            }
        }
        let mut setup = Self {
            edges: [NOTHING; 3],
            rows: [[0; LANES]; 2],
            columns: [[0; LANES]; 2],
            depth: [[0.0; LANES]; 2],
            dz_dx: [0.0; LANES],
            dz_dy: [0.0; LANES],
            range: [[0.0; LANES]; 2],
            nearest: [0.0; LANES],
            behind: [false; LANES],
        };
        let turns = setup.plane(&vertices, entries, shift, stats);
        setup.bounds(&vertices, shift, &turns, rules);
        for edge in 0..3 {
            setup.edge(edge, [&vertices[edge], &vertices[(edge + 1) % 3]], shift, &turns);
        }
        if rules.tile {
            setup.reject(stats);
        }
        if rules.hierarchical_z {
            setup.hide(farthest, rules, stats);
        }
        setup
    }

    /// The plane of depths, and which way each triangle turns: 1, -1, or 0 if it has no area.
    ///
    /// With `l` and `r` the products of rounded differences, a determinant `l - r` is off by at most
    /// `4u (|l| + |r|)`. A slope is a quotient of two; while the area is known within a half, that of its
    /// error's is within twice `(e + |slope| E) / |area|`. On the way to a depth each term goes through at most
    /// seven roundings. All constants are a little greater, for the roundings of the bounds themselves.
    #[inline(always)]
    fn plane(
        &mut self,
        [a, b, c]: &[[Wide; 3]; 3],
        entries: &[Entry],
        shift: [f64; 3],
        stats: &mut Stats,
    ) -> Wide {
        let mut turns = [0.0; LANES];
        let mut doubt = [false; LANES];
        for i in 0..LANES {
            let (ax, ay, az) = (a[0][i], a[1][i], a[2][i]);
            let (bx, by, bz) = (b[0][i] - ax, b[1][i] - ay, b[2][i] - az);
            let (cx, cy, cz) = (c[0][i] - ax, c[1][i] - ay, c[2][i] - az);
            let (l, r) = (bx * cy, by * cx);
            let area = l - r;
            let size = l.abs() + r.abs();
            doubt[i] = area.abs() <= ORIENT2D_FILTER * size;
            turns[i] = if area > 0.0 { 1.0 } else { -1.0 };
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
            let known = area.abs() > 16.0 * U * size;
            let depth = az - dx * x - dy * y;
            self.depth[0][i] = if known { depth - error } else { f64::NEG_INFINITY };
            self.depth[1][i] = if known { depth + error } else { f64::INFINITY };
            self.dz_dx[i] = if known { dx } else { 0.0 };
            self.dz_dy[i] = if known { dy } else { 0.0 };
            let (bz, cz) = (b[2][i], c[2][i]);
            self.range[0][i] = least(least(az, bz), cz);
            self.range[1][i] = greatest(greatest(az, bz), cz);
        }
        if doubt.iter().any(|&doubt| doubt) {
            turn_exactly(&mut turns, &doubt, entries, stats);
        }
        turns
    }

    /// Rows and columns of the centres in the triangle's box, as far as they lie in the tile.
    ///
    /// Rows through the highest or lowest vertex count only where a horizontal edge there is drawn: above all
    /// others no pixel lies between a left and a right edge, unless both draw their ties.
    #[inline(always)]
    fn bounds(&mut self, [a, b, c]: &[[Wide; 3]; 3], shift: [f64; 3], turns: &Wide, rules: &Rules) {
        for i in 0..LANES {
            let [ax, bx, cx] = [a[0][i] - shift[0], b[0][i] - shift[0], c[0][i] - shift[0]];
            let first = least(least(ax, bx), cx).ceil();
            let last = greatest(greatest(ax, bx), cx).floor();
            self.columns[0][i] = integer(least(greatest(first, 0.0), END));
            self.columns[1][i] = integer(least(greatest(last, 0.0), END)) + 1;
            let [ay, by, cy] = [a[1][i] - shift[1], b[1][i] - shift[1], c[1][i] - shift[1]];
            let (top, bottom) = (least(least(ay, by), cy), greatest(greatest(ay, by), cy));
            let (first, last) = (top.ceil(), bottom.floor());
            // How many vertices are as high: two make a horizontal edge.
            let count = |at: f64| f64::from(at == ay) + f64::from(at == by) + f64::from(at == cy);
            let closed = count(top) + rules.first_row > 2.5;
            let first = if first == top && !closed { first + 1.0 } else { first };
            let closed = count(bottom) + rules.last_row > 2.5;
            let last = if last == bottom && !closed { last - 1.0 } else { last };
            let end = if turns[i] == 0.0 { 0.0 } else { last + 1.0 };
            self.rows[0][i] = integer(least(greatest(first, 0.0), END + 1.0));
            self.rows[1][i] = integer(least(greatest(end, 0.0), END + 1.0));
        }
    }

    /// Where rows cross the edge from `p` to `q`.
    ///
    /// The slope is off by at most three roundings, the height above `p` by one and that of `p` itself, their
    /// product by one more; `p` and each of two sums by one: below `7u |slope| (|y| + 64) + 3u |x|`. What is
    /// added on top keeps ties inside the interval where all terms vanish.
    #[inline(always)]
    fn edge(&mut self, edge: usize, [p, q]: [&[Wide; 3]; 2], shift: [f64; 3], turns: &Wide) {
        const TIE: f64 = 1e-20;
        let crossings = &mut self.edges[edge];
        for i in 0..LANES {
            let (x, y) = (p[0][i] - shift[0], p[1][i] - shift[1]);
            let height = q[1][i] - p[1][i];
            let level = height == 0.0;
            let slope = (q[0][i] - p[0][i]) / if level { 1.0 } else { height };
            let error = 8.0 * U * (slope.abs() * (y.abs() + 64.0) + x.abs()) + TIE;
            // Turned positively, edges that go towards smaller y have the inside to their right.
            let uphill = height * turns[i];
            let left = if uphill < 0.0 { 0.0 } else { f64::NEG_INFINITY };
            let right = if uphill > 0.0 { 0.0 } else { f64::INFINITY };
            crossings.y[i] = y;
            crossings.slope[i] = if level { 0.0 } else { slope };
            crossings.left[0][i] = x - error + left;
            crossings.left[1][i] = x + error + left;
            crossings.right[0][i] = x - error + right;
            crossings.right[1][i] = x + error + right;
        }
    }

    /// Empties the rows of triangles that lie beside the tile: one edge keeps out its nearest corner.
    #[inline(always)]
    fn reject(&mut self, stats: &mut Stats) {
        let mut beside = [0_u32; LANES];
        for crossings in &self.edges {
            for i in 0..LANES {
                let slope = crossings.slope[i];
                let (top, bottom) = (-crossings.y[i] * slope, (END - crossings.y[i]) * slope);
                let left = least(top, bottom) + crossings.left[0][i];
                let right = greatest(top, bottom) + crossings.right[1][i];
                beside[i] |= u32::from(left > END) | u32::from(right < 0.0);
            }
        }
        for i in 0..LANES {
            let any = u32::from(self.rows[0][i] < self.rows[1][i]);
            stats.beside += u64::from(beside[i] & any);
            self.rows[1][i] *= 1 - beside[i];
        }
    }
}

impl Setup {
    /// Empties the rows of triangles that lie behind all pixels of the tile, unless they are to be counted.
    #[inline(always)]
    fn hide(&mut self, farthest: f32, rules: &Rules, stats: &mut Stats) {
        let farthest = f64::from(farthest);
        for i in 0..LANES {
            let [left, right] = [f64::from(self.columns[0][i]), f64::from(self.columns[1][i]) - 1.0];
            let [top, bottom] = [f64::from(self.rows[0][i]), f64::from(self.rows[1][i]) - 1.0];
            let (dx, dy) = (self.dz_dx[i], self.dz_dy[i]);
            let near = self.depth[0][i] + least(dy * top, dy * bottom) + least(dx * left, dx * right);
            self.nearest[i] = greatest(near, self.range[0][i]);
        }
        for i in 0..LANES {
            let hidden = u32::from(self.nearest[i] >= farthest);
            let any = u32::from(self.rows[0][i] < self.rows[1][i]);
            stats.behind += u64::from(hidden & any);
            self.behind[i] = hidden != 0;
            self.rows[1][i] *= 1 - (hidden & u32::from(!rules.counts));
        }
    }
}

/// Turns that the determinant's error leaves open.
#[cold]
#[inline(never)]
fn turn_exactly(turns: &mut Wide, doubt: &[bool; LANES], entries: &[Entry], stats: &mut Stats) {
    for (i, entry) in entries.iter().enumerate().take(LANES) {
        if doubt[i] {
            let [a, b, c] = entry.corners.map(|[x, y, _]| [x, y]);
            turns[i] = match orient2d(a, b, c, &mut Tally::default()) {
                Sign::Positive => 1.0,
                Sign::Negative => -1.0,
                Sign::Zero => 0.0,
            };
            stats.exact_turns += 1;
        }
    }
    for turn in &mut turns[entries.len().min(LANES)..] {
        *turn = 0.0;
    }
}
