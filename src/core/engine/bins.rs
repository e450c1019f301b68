//! Binning: which tiles the box around each triangle meets, and of a large one those that it does not lie beside.
//!
//! *Source:* Molnar, Cox, Ellsworth, Fuchs, A Sorting Classification of Parallel Rendering, 1994 (sort-middle).

use super::{
    Stats, Triangles,
    canvas::{TILE, tiles},
    lanes::LANES,
    state::Rules,
};
use crate::math::predicates::ORIENT2D_FILTER;

/// A triangle in a list. A copy, since the lists are read one after another, but the triangles in a list lie far
/// apart in memory.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    /// Vertices: x and y in pixels, depth.
    corners: [[f32; 3]; 3],
    /// Its colour codes, or its number from 1 if they are painted.
    pub(super) color: u32,
}

impl Entry {
    const NOTHING: Self = Self { corners: [[0.0; 3]; 3], color: 0 };

    /// The depth of its nearest vertex.
    #[inline(always)]
    pub(super) fn nearest(&self) -> f32 {
        let [[.., a], [.., b], [.., c]] = self.corners;
        a.min(b).min(c)
    }
}

/// Up to [`LANES`] of them, one a lane; those that are missing have no area.
pub(super) struct Group {
    pub(super) corners: [[[f32; LANES]; 3]; 3],
    pub(super) colors: [u32; LANES],
}

impl Group {
    #[inline(always)]
    pub(super) fn new(entries: &[Entry]) -> Self {
        let mut few = [Entry::NOTHING; LANES];
        match entries.first_chunk() {
            Some(all) => Self::of(all),
            None => {
                few.iter_mut().zip(entries).for_each(|(entry, other)| *entry = *other);
                Self::of(&few)
            }
        }
    }

    /// Of those of a list whose places are given. In place of a colour they have their place, from 1.
    #[inline(always)]
    pub(super) fn at(places: &[u32], entries: &[Entry]) -> Self {
        let mut few = [Entry::NOTHING; LANES];
        for (entry, place) in few.iter_mut().zip(places) {
            if let Some(other) = entries.get(*place as usize) {
                *entry = Entry { color: place + 1, ..*other };
            }
        }
        Self::of(&few)
    }

    #[inline(always)]
    fn of(all: &[Entry; LANES]) -> Self {
        let mut group = Self { corners: [[[0.0; LANES]; 3]; 3], colors: [0; LANES] };
        for corner in 0..3 {
            for axis in 0..3 {
                for i in 0..LANES {
                    group.corners[corner][axis][i] = all[i].corners[corner][axis];
                }
            }
        }
        for i in 0..LANES {
            group.colors[i] = all[i].color;
        }
        group
    }

    /// The vertices of one.
    pub(super) fn triangle(&self, lane: usize) -> [[f32; 3]; 3] {
        self.corners.map(|corner| corner.map(|all| all[lane]))
    }
}

/// For each tile the triangles that may touch it, in the order of drawing.
#[derive(Clone, Debug, Default)]
pub(super) struct Bins {
    lists: Vec<Vec<Entry>>,
    columns: usize,
    /// Pixels of the boxes of all triangles, and how many of these there are.
    area: u64,
    count: u64,
}

impl Bins {
    /// Empties the lists, keeping their room.
    pub(super) fn reset(&mut self, size: [u32; 2]) {
        let [columns, rows] = tiles(size);
        self.lists.iter_mut().for_each(Vec::clear);
        self.lists.resize_with(columns * rows, Vec::new);
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
        &self.lists[tile]
    }

    /// Sorts all triangles in. One with a coordinate that is no number, or whose box holds no pixel's centre,
    /// is in no list.
    #[inline(always)]
    pub(super) fn fill(
        &mut self,
        triangles: &Triangles<'_>,
        size: [u32; 2],
        rules: &Rules,
        stats: &mut Stats,
    ) {
        let limit = size.map(|pixels| pixels as f32);
        for triangle in 0..triangles.len() {
            let corners = triangles.corners(triangle);
            let Some(pixels) = pixels_of(&corners, limit) else {
                stats.culled += 1;
                continue;
            };
            let [left, right, top, bottom] = pixels.map(|pixel| pixel as usize / TILE);
            let [width, height] = [pixels[1] - pixels[0], pixels[3] - pixels[2]];
            self.area += (width + 1) as u64 * (height + 1) as u64;
            self.count += 1;
            let color = if rules.counts { triangle as u32 + 1 } else { triangles.color(triangle) };
            let entry = Entry { corners, color };
            if rules.tile && right - left > 1 && bottom - top > 1 {
                self.push_large(entry, [left, right, top, bottom], stats);
                continue;
            }
            for row in top..=bottom {
                for list in &mut self.lists[row * self.columns..][left..=right] {
                    list.push(entry);
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

/// Vertices that are not there.
pub(super) const NOWHERE: [[f32; 3]; 3] = [[f32::NAN; 3]; 3];

/// First and last column, first and last row of the centres in the box around a triangle; `None` if there is no such
/// centre or a coordinate is no number.
///
/// Subtracting 1/2 rounds only below 1/4, and never across an integer.
#[inline(always)]
fn pixels_of([a, b, c]: &[[f32; 3]; 3], limit: [f32; 2]) -> Option<[i32; 4]> {
    let least = |a: f32, b: f32| if a < b { a } else { b };
    let greatest = |a: f32, b: f32| if a > b { a } else { b };
    let (mut first, mut last) = ([0; 2], [0; 2]);
    for axis in 0..2 {
        let [a, b, c] = [a[axis], b[axis], c[axis]];
        let begin = (least(least(a, b), c) - 0.5).ceil();
        let end = (greatest(greatest(a, b), c) - 0.5).floor();
        // Clamped, so that the conversion needs no care; -1 and the limit are off the image.
        first[axis] = integer(least(greatest(begin, 0.0), limit[axis]));
        last[axis] = integer(least(greatest(end, -1.0), limit[axis] - 1.0));
    }
    // Infinity minus infinity, and whatever has to do with NaN, is NaN.
    let nothing = |[x, y, z]: &[f32; 3]| x * 0.0 + y * 0.0 + z * 0.0;
    let sum = nothing(a) + nothing(b) + nothing(c);
    if sum.is_nan() || first[0] > last[0] || first[1] > last[1] {
        return None;
    }
    Some([first[0], last[0], first[1], last[1]])
}

/// A small whole number as an integer: the low bits after adding 1.5 * 2^23.
#[inline(always)]
fn integer(whole: f32) -> i32 {
    const SHIFT: f32 = 12_582_912.0;
    (whole + SHIFT).to_bits().wrapping_sub(SHIFT.to_bits()) as i32
}
