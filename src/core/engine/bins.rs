//! Binning: which tiles the box around each triangle meets, and of a large one those that it does not lie beside.
//!
//! *Source:* Molnar, Cox, Ellsworth, Fuchs, A Sorting Classification of Parallel Rendering, 1994 (sort-middle).

use super::{
    Stats,
    canvas::{TILE, tiles},
    group::{Entry, Group, List},
    lanes::{LANES, larger, lesser, mask, whole},
    source::Source,
    state::Rules,
};
use crate::math::predicates::ORIENT2D_FILTER;

/// For each tile the triangles that may touch it, in the order of drawing.
#[derive(Clone, Debug, Default)]
pub(super) struct Bins {
    lists: Vec<List>,
    columns: usize,
    /// Pixels of the boxes of all triangles, and how many of these there are.
    area: u64,
    count: u64,
}

impl Bins {
    /// Empties the lists, keeping their room.
    pub(super) fn reset(&mut self, size: [u32; 2]) {
        let [columns, rows] = tiles(size);
        self.lists.iter_mut().for_each(List::clear);
        self.lists.resize_with(columns * rows, List::default);
        self.columns = columns;
        (self.area, self.count) = (0, 0);
    }

    /// Whether many triangles of some size lie over each other in an image: then much of them may be hidden.
    pub(super) fn are_deep(&self, size: [u32; 2]) -> bool {
        let pixels = u64::from(size[0]) * u64::from(size[1]);
        self.area >= 4 * pixels && self.area >= LARGE * self.count
    }

    /// The triangles of a tile.
    pub(super) fn list(&self, tile: usize) -> &[Entry] {
        self.lists[tile].entries()
    }

    /// Sorts all triangles in. One with a coordinate that is no number, or whose box holds no pixel's centre,
    /// is in no list.
    #[inline(always)]
    pub(super) fn fill(&mut self, triangles: &impl Source, size: [u32; 2], rules: &Rules, stats: &mut Stats) {
        for start in (0..triangles.count()).step_by(LANES) {
            let count = LANES.min(triangles.count() - start);
            let mut group = Group::NOTHING;
            for half in [0, LANES / 2] {
                let i = start + half;
                let (a, b) = (triangles.vertices(i), triangles.vertices(i + 1));
                let (c, d) = (triangles.vertices(i + 2), triangles.vertices(i + 3));
                group.put(half, [a, b, c, d]);
            }
            let mut boxes = Boxes::new(&group, size);
            boxes.leave_out(&triangles.averted(start, &group), count);
            let [area, some] = boxes.sums();
            self.area += area;
            self.count += some;
            stats.culled += count as u64 - some;
            let tiles = boxes.tiles(self.columns as u32);
            for i in 0..count {
                if !boxes.some[i] {
                    continue;
                }
                let entry = || triangles.entry(start + i, rules.counts);
                if tiles.one[i] != 0 {
                    self.lists[tiles.first[i] as usize].push(entry());
                    continue;
                }
                let [left, right, top, bottom] = boxes.pixels.map(|ends| ends[i] as usize / TILE);
                if rules.tile && right - left > 1 && bottom - top > 1 {
                    self.push_large(entry(), [left, right, top, bottom], stats);
                } else {
                    let entry = entry();
                    for row in top..=bottom {
                        for list in &mut self.lists[row * self.columns..][left..=right] {
                            list.push(entry);
                        }
                    }
                }
            }
        }
    }
}

impl Bins {
    /// Puts a triangle into the lists of the tiles that do not lie beside it.
    fn push_large(&mut self, entry: Entry, [left, right, top, bottom]: [usize; 4], stats: &mut Stats) {
        let sides = Sides::new(&entry.corners);
        for row in top..=bottom {
            for column in left..=right {
                if sides.as_ref().is_some_and(|sides| sides.keep_out([column, row])) {
                    stats.binned += 1;
                    stats.beside += 1;
                } else {
                    self.lists[row * self.columns + column].push(entry);
                }
            }
        }
    }
}

/// The edges of a triangle, with the inside to their positive side: a point, and the direction.
struct Sides([[Point; 2]; 3]);

type Point = [f64; 2];

impl Sides {
    /// `None` if rounding leaves open which way the triangle turns.
    fn new(corners: &[[f32; 3]; 3]) -> Option<Self> {
        let [a, b, c] = corners.map(|[x, y, _]| [f64::from(x), f64::from(y)]);
        let from = |p: Point, q: Point| [q[0] - p[0], q[1] - p[1]];
        let (u, v) = (from(a, b), from(a, c));
        let (l, r) = (u[0] * v[1], u[1] * v[0]);
        let turn = l - r;
        let known = turn.abs() > ORIENT2D_FILTER * (l.abs() + r.abs());
        let edges = if turn > 0.0 { [[a, b], [b, c], [c, a]] } else { [[b, a], [c, b], [a, c]] };
        known.then_some(Self(edges.map(|[p, q]| [p, from(p, q)])))
    }

    /// Whether one of them surely has all centres of a tile on its other side: the one farthest inwards.
    fn keep_out(&self, [column, row]: [usize; 2]) -> bool {
        let [x, y] = [column, row].map(|tile| [(tile * TILE) as f64 + 0.5, ((tile + 1) * TILE) as f64 - 0.5]);
        self.0.iter().any(|[p, [dx, dy]]| {
            let l = dx * (y[usize::from(*dx > 0.0)] - p[1]);
            let r = dy * (x[usize::from(*dy <= 0.0)] - p[0]);
            l - r < -ORIENT2D_FILTER * (l.abs() + r.abs())
        })
    }
}

/// Pixels of the box around a triangle of which large parts can be hidden.
const LARGE: u64 = 256;

/// Where the boxes around a few triangles begin.
struct Tiles {
    /// The number of the tile.
    first: [u32; LANES],
    /// Whether the box lies in that alone: all bits or none.
    one: [u32; LANES],
}

/// The boxes around a few triangles.
struct Boxes {
    /// First and last column, first and last row of the centres in each.
    pixels: [[u32; LANES]; 4],
    /// Whether there is such a centre, and all coordinates are numbers.
    some: [bool; LANES],
}

impl Boxes {
    /// Those in an image.
    ///
    /// Subtracting 1/2 rounds only below 1/4, and never across an integer.
    #[inline(always)]
    fn new(group: &Group, size: [u32; 2]) -> Self {
        let mut boxes = Self { pixels: [[0; LANES]; 4], some: [true; LANES] };
        for axis in 0..2 {
            let limit = size[axis] as f32;
            let [a, b, c] = [&group.corners[0][axis], &group.corners[1][axis], &group.corners[2][axis]];
            for i in 0..LANES {
                let begin = (lesser(lesser(a[i], b[i]), c[i]) - 0.5).ceil();
                let end = (larger(larger(a[i], b[i]), c[i]) - 0.5).floor();
                // Clamped, so that the conversion needs no care; -1 and the limit are off the image.
                let begin = lesser(larger(begin, 0.0), limit);
                let end = lesser(larger(end, -1.0), limit - 1.0);
                boxes.pixels[2 * axis][i] = whole(begin);
                boxes.pixels[2 * axis + 1][i] = whole(end);
                boxes.some[i] &= begin <= end;
            }
        }
        let mut nothing = [0.0; LANES];
        for corner in &group.corners {
            for numbers in corner {
                for i in 0..LANES {
                    // Infinity times zero, and whatever has to do with NaN, is NaN.
                    nothing[i] += numbers[i] * 0.0;
                }
            }
        }
        for i in 0..LANES {
            boxes.some[i] &= nothing[i] == 0.0;
        }
        boxes
    }

    /// Leaves triangles out, and all from a lane on.
    #[inline(always)]
    fn leave_out(&mut self, which: &[bool; LANES], end: usize) {
        for i in 0..LANES {
            self.some[i] &= !which[i] & (i < end);
        }
    }

    /// How many pixels they have, and how many there are.
    #[inline(always)]
    fn sums(&self) -> [u64; 2] {
        let [left, right, top, bottom] = &self.pixels;
        let (mut area, mut count) = (0, 0);
        for i in 0..LANES {
            // At most 2^28 pixels each.
            let pixels = right[i]
                .wrapping_sub(left[i])
                .wrapping_add(1)
                .wrapping_mul(bottom[i].wrapping_sub(top[i]).wrapping_add(1));
            area += u64::from(pixels & mask(self.some[i]));
            count += u64::from(self.some[i]);
        }
        [area, count]
    }

    /// The tiles in which they begin.
    #[inline(always)]
    fn tiles(&self, columns: u32) -> Tiles {
        let mut tiles = Tiles { first: [0; LANES], one: [0; LANES] };
        let [left, right, top, bottom] = &self.pixels;
        for i in 0..LANES {
            let size = TILE as u32;
            let [left, right, top, bottom] =
                [left[i] / size, right[i] / size, top[i] / size, bottom[i] / size];
            tiles.first[i] = top * columns + left;
            tiles.one[i] = mask(left == right) & mask(top == bottom);
        }
        tiles
    }
}
