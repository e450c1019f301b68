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
    pub(super) corners: [[f32; 3]; 3],
    /// Its colour codes, or its number from 1 if they are painted.
    pub(super) color: u32,
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
        let count = triangles.len();
        for start in (0..count).step_by(LANES) {
            let mut corners = [NOWHERE; LANES];
            let mut vertices = [[[0.0; LANES]; 3]; 3];
            let lanes = LANES.min(count - start);
            for lane in 0..lanes {
                corners[lane] = triangles.corners(start + lane);
                for corner in 0..3 {
                    for axis in 0..3 {
                        vertices[corner][axis][lane] = corners[lane][corner][axis];
                    }
                }
            }
            let boxes = Boxes::around(&vertices, limit);
            for lane in 0..lanes {
                let [left, right, top, bottom] = boxes.tiles(lane);
                if left > right || top > bottom {
                    stats.culled += 1;
                    continue;
                }
                let triangle = start + lane;
                let color = if numbers { triangle as u32 + 1 } else { triangles.color(triangle) };
                let entry = Entry { corners: corners[lane], color };
                for row in top..=bottom {
                    for list in &mut self.lists[row * self.columns..][left..=right] {
                        list.push(entry);
                    }
                }
            }
        }
    }
}

/// Vertices that are not there.
pub(super) const NOWHERE: [[f32; 3]; 3] = [[f32::NAN; 3]; 3];

/// First and last column and row of the centres in the box around each triangle.
struct Boxes {
    first: [[i32; LANES]; 2],
    last: [[i32; LANES]; 2],
}

impl Boxes {
    /// Subtracting 1/2 rounds only below 1/4, and never across an integer.
    #[inline(always)]
    fn around([a, b, c]: &[[[f32; LANES]; 3]; 3], limit: [f32; 2]) -> Self {
        let mut boxes = Self { first: [[0; LANES]; 2], last: [[-1; LANES]; 2] };
        for axis in 0..2 {
            for lane in 0..LANES {
                let [a, b, c] = [a[axis][lane], b[axis][lane], c[axis][lane]];
                let least = |a: f32, b: f32| if a < b { a } else { b };
                let greatest = |a: f32, b: f32| if a > b { a } else { b };
                let first = (least(least(a, b), c) - 0.5).ceil();
                let last = (greatest(greatest(a, b), c) - 0.5).floor();
                // Clamped, so that the conversion needs no care; -1 and the limit are off the image.
                boxes.first[axis][lane] = integer(least(greatest(first, 0.0), limit[axis]));
                boxes.last[axis][lane] = integer(least(greatest(last, -1.0), limit[axis] - 1.0));
            }
        }
        // Infinity minus infinity, and whatever has to do with NaN, is NaN: no box at all.
        for lane in 0..LANES {
            let mut sum = 0.0;
            for vertex in [a, b, c] {
                for axis in 0..3 {
                    sum += vertex[axis][lane] * 0.0;
                }
            }
            let wrong = i32::from(sum != 0.0);
            boxes.last[0][lane] -= wrong << 20;
        }
        boxes
    }

    /// First and last tile column, first and last tile row; empty if a first one is behind its last.
    #[inline(always)]
    fn tiles(&self, lane: usize) -> [usize; 4] {
        let (left, right) = (self.first[0][lane], self.last[0][lane]);
        let (top, bottom) = (self.first[1][lane], self.last[1][lane]);
        if left > right || top > bottom {
            return [1, 0, 1, 0];
        }
        let tile = |pixel: i32| pixel as usize / TILE;
        [tile(left), tile(right), tile(top), tile(bottom)]
    }
}

/// A small whole number as an integer: the low bits after adding 1.5 * 2^23.
#[inline(always)]
fn integer(whole: f32) -> i32 {
    const SHIFT: f32 = 12_582_912.0;
    (whole + SHIFT).to_bits().wrapping_sub(SHIFT.to_bits()) as i32
}
