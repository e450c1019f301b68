//! Binning: which tiles the box around each triangle meets.
//!
//! *Source:* Molnar, Cox, Ellsworth, Fuchs, A Sorting Classification of Parallel Rendering, 1994 (sort-middle).

use super::{
    Stats, Triangles,
    canvas::{TILE, tiles},
    lanes::LANES,
};

/// A triangle in a list. A copy, since the lists are read one after another, but the triangles in a list lie far
/// apart in memory.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    /// Vertices: x and y in pixels, depth.
    corners: [[f32; 3]; 3],
    /// Its colour codes, or its number from 1 if they are painted.
    color: u32,
}

/// Up to [`LANES`] of them, one a lane; those that are missing have no area.
pub(super) struct Group {
    pub(super) corners: [[[f32; LANES]; 3]; 3],
    pub(super) colors: [u32; LANES],
}

impl Group {
    #[inline(always)]
    pub(super) fn new(entries: &[Entry]) -> Self {
        const NOTHING: Entry = Entry { corners: [[0.0; 3]; 3], color: 0 };
        let mut few = [NOTHING; LANES];
        let all = match entries.first_chunk() {
            Some(all) => all,
            None => {
                few.iter_mut().zip(entries).for_each(|(entry, other)| *entry = *other);
                &few
            }
        };
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
}

impl Bins {
    /// Empties the lists, keeping their room.
    pub(super) fn reset(&mut self, size: [u32; 2]) {
        let [columns, rows] = tiles(size);
        self.lists.iter_mut().for_each(Vec::clear);
        self.lists.resize_with(columns * rows, Vec::new);
        self.columns = columns;
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
        numbers: bool,
        stats: &mut Stats,
    ) {
        let limit = size.map(|pixels| pixels as f32);
        for triangle in 0..triangles.len() {
            let corners = triangles.corners(triangle);
            let Some([left, right, top, bottom]) = tiles_of(&corners, limit) else {
                stats.culled += 1;
                continue;
            };
            let color = if numbers { triangle as u32 + 1 } else { triangles.color(triangle) };
            for row in top..=bottom {
                for list in &mut self.lists[row * self.columns..][left..=right] {
                    list.push(Entry { corners, color });
                }
            }
        }
    }
}

/// Vertices that are not there.
pub(super) const NOWHERE: [[f32; 3]; 3] = [[f32::NAN; 3]; 3];

/// First and last tile column, first and last tile row of the centres in the box around a triangle; `None` if there
/// is no such centre or a coordinate is no number.
///
/// Subtracting 1/2 rounds only below 1/4, and never across an integer.
#[inline(always)]
fn tiles_of([a, b, c]: &[[f32; 3]; 3], limit: [f32; 2]) -> Option<[usize; 4]> {
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
    let tile = |pixel: i32| pixel as usize / TILE;
    Some([tile(first[0]), tile(last[0]), tile(first[1]), tile(last[1])])
}

/// A small whole number as an integer: the low bits after adding 1.5 * 2^23.
#[inline(always)]
fn integer(whole: f32) -> i32 {
    const SHIFT: f32 = 12_582_912.0;
    (whole + SHIFT).to_bits().wrapping_sub(SHIFT.to_bits()) as i32
}
