//! One tile: its colours, depths and stencil values in the first-level cache, and what is known of the depths of
//! whole blocks.
//!
//! *Source:* Greene, Kass, Miller, Hierarchical Z-Buffer Visibility, SIGGRAPH 1993 (one level of it: blocks).

use super::{
    Stats,
    canvas::{Clear, Strip, TILE},
    lanes::LANES,
    paint::{Brushes, Painter},
    test::Test,
};
use std::ops::Range;

const PIXELS: usize = TILE * TILE;

/// Columns of a block; it has [`LANES`] rows.
pub(super) const BLOCK: usize = 16;
const ACROSS: usize = TILE / BLOCK;
const BLOCKS: usize = ACROSS * (TILE / LANES);

/// After so many pieces drawn in a block its farthest depth is looked for again; after more where that was in vain.
const PATIENCE: u8 = 4;
const MOST_PATIENCE: u8 = 64;

/// So many neighbouring pixels get their colours together if they are of one triangle.
const RUN: usize = 8;

/// Begins at a cache line, so that no row of a block lies in two.
#[repr(align(64))]
#[derive(Debug)]
struct Aligned<T>(T);

/// The pixels of a tile.
#[derive(Debug)]
pub(super) struct Tile {
    color: Aligned<[u32; PIXELS]>,
    depth: Aligned<[f32; PIXELS]>,
    stencil: Aligned<[u8; PIXELS]>,
    /// Which pixels of each row were painted one fragment after another.
    touched: [u64; TILE],
    /// No pixel of a block is farther.
    farthest: [f32; BLOCKS],
    /// How many more pieces are drawn there before that is looked for again, and how many were to be.
    left: [u8; BLOCKS],
    patience: [u8; BLOCKS],
}

impl Default for Tile {
    fn default() -> Self {
        Self {
            color: Aligned([0; PIXELS]),
            depth: Aligned([0.0; PIXELS]),
            stencil: Aligned([0; PIXELS]),
            touched: [0; TILE],
            farthest: [0.0; BLOCKS],
            left: [0; BLOCKS],
            patience: [0; BLOCKS],
        }
    }
}

/// One pixel of a tile.
pub(super) struct Pixel<'t> {
    pub(super) color: &'t mut u32,
    pub(super) depth: &'t mut f32,
    pub(super) stencil: &'t mut u8,
}

impl Tile {
    /// Makes all pixels empty.
    pub(super) fn clear(&mut self, clear: &Clear) {
        self.color.0.fill(u32::from_ne_bytes(clear.color));
        self.depth.0.fill(clear.depth);
        self.stencil.0.fill(clear.stencil);
        self.touched = [0; TILE];
        self.farthest = [clear.depth; BLOCKS];
        (self.left, self.patience) = ([PATIENCE; BLOCKS], [PATIENCE; BLOCKS]);
    }

    /// Takes the pixels of a strip from column `left` on.
    pub(super) fn load(&mut self, strip: &Strip<'_>, left: u32) {
        for (range, at) in strip.rows(left) {
            let codes = strip.color[4 * range.start..4 * range.end].as_chunks().0;
            let color = self.color.0[at..].iter_mut().zip(codes);
            color.for_each(|(pixel, codes)| *pixel = u32::from_ne_bytes(*codes));
            self.depth.0[at..at + range.len()].copy_from_slice(&strip.depth[range.clone()]);
            if let Some(stencil) = strip.stencil.get(range.clone()) {
                self.stencil.0[at..at + range.len()].copy_from_slice(stencil);
            }
        }
        self.touched = [0; TILE];
        self.farthest = [f32::INFINITY; BLOCKS];
        (self.left, self.patience) = ([0; BLOCKS], [PATIENCE; BLOCKS]);
    }

    /// Forgets the colours: from now on they are numbers of triangles, of which 0 is none.
    pub(super) fn number(&mut self) {
        self.color.0.fill(0);
    }

    /// Gives them back.
    pub(super) fn store(&self, strip: &mut Strip<'_>, left: u32) {
        for (range, at) in strip.rows(left) {
            let codes = strip.color[4 * range.start..4 * range.end].as_chunks_mut().0;
            let color = codes.iter_mut().zip(&self.color.0[at..]);
            color.for_each(|(codes, pixel)| *codes = pixel.to_ne_bytes());
            self.store_depth(strip, range, at);
        }
    }

    /// Gives depths and stencil values back, and the colours of the triangles that the pixels' numbers name; the others
    /// are cleared if `clear` says to what.
    pub(super) fn store_numbered(
        &self,
        strip: &mut Strip<'_>,
        left: u32,
        clear: Option<&Clear>,
        colors: &mut [u32],
    ) {
        let none = clear.map_or(0, |clear| u32::from_ne_bytes(clear.color));
        if let Some(color) = colors.first_mut() {
            *color = none;
        }
        let color = |number: u32| colors.get(number as usize).copied().unwrap_or(none).to_ne_bytes();
        for (range, at) in strip.rows(left) {
            let codes: &mut [[u8; 4]] = strip.color[4 * range.start..4 * range.end].as_chunks_mut().0;
            let numbers = &self.color.0[at..at + codes.len()];
            for (codes, numbers) in codes.chunks_mut(RUN).zip(numbers.chunks(RUN)) {
                // Mostly one triangle is seen in all of a few pixels.
                let differ = numbers.iter().fold(0, |differ, number| differ | (number ^ numbers[0]));
                let pixels = codes.iter_mut().zip(numbers);
                if clear.is_none() {
                    pixels
                        .filter(|(_, number)| **number > 0)
                        .for_each(|(codes, number)| *codes = color(*number));
                } else if differ == 0 {
                    codes.fill(color(numbers[0]));
                } else {
                    pixels.for_each(|(codes, number)| *codes = color(*number));
                }
            }
            self.store_depth(strip, range, at);
        }
    }

    fn store_depth(&self, strip: &mut Strip<'_>, range: Range<usize>, at: usize) {
        strip.depth[range.clone()].copy_from_slice(&self.depth.0[at..at + range.len()]);
        if let Some(stencil) = strip.stencil.get_mut(range.clone()) {
            stencil.copy_from_slice(&self.stencil.0[at..at + range.len()]);
        }
    }

    /// Gives depths and stencil values back, and paints the pixels with the triangles that their numbers name; the
    /// others are cleared if `clear` says to what. Counts the pixels that are painted.
    pub(super) fn store_painted<P: Painter>(
        &mut self,
        strip: &mut Strip<'_>,
        left: u32,
        clear: Option<&Clear>,
        brushes: &mut Brushes<'_, P>,
        stats: &mut Stats,
    ) {
        for (row, (range, at)) in strip.rows(left).enumerate() {
            let codes = strip.color[4 * range.start..4 * range.end].as_chunks_mut().0;
            if let Some(clear) = clear {
                codes.fill(clear.color);
            }
            let numbers = &self.color.0[at..at + range.len()];
            let y = strip.top + row as u32;
            let (mut x, mut touched) = (0, 0);
            for run in numbers.chunk_by(|a, b| a == b) {
                let end = x + run.len();
                if let Some(triangle) = run[0].checked_sub(1) {
                    brushes.paint(triangle, [left + x as u32, y], &mut codes[x..end], stats);
                    touched |= u64::MAX >> (64 - run.len()) << x;
                }
                x = end;
            }
            self.touched[row] = touched;
            self.store_depth(strip, range, at);
        }
    }

    /// Adds the pixels that were painted to those that were before, and counts the new ones.
    pub(super) fn mark(&self, painted: &mut [u64; TILE], stats: &mut Stats) {
        for (painted, touched) in painted.iter_mut().zip(self.touched) {
            stats.pixels += u64::from((touched & !*painted).count_ones());
            *painted |= touched;
        }
    }

    /// Pixels of a row are painted: a bit each, from column x on.
    #[inline(always)]
    pub(super) fn touch(&mut self, [x, y]: [usize; 2], pixels: u64) {
        self.touched[y % TILE] |= pixels << (x % TILE);
    }

    /// Counts what is drawn in the blocks from column `x` on: what is known of them grows old.
    #[inline(always)]
    pub(super) fn age(&mut self, x: usize, y: usize, columns: usize) {
        for x in [x, x + columns - 1] {
            let left = &mut self.left[block_at(x, y)];
            *left = left.saturating_sub(1);
        }
    }

    /// Some neighbouring pixels of a row: depths and colours.
    #[inline(always)]
    pub(super) fn row<const N: usize>(&mut self, x: usize, y: usize) -> (&mut [f32; N], &mut [u32; N]) {
        let at = (y * TILE + x).min(PIXELS - N);
        let depths = &mut self.depth.0[at..at + N].as_chunks_mut().0[0];
        let colors = &mut self.color.0[at..at + N].as_chunks_mut().0[0];
        (depths, colors)
    }

    /// One pixel.
    pub(super) fn pixel(&mut self, x: usize, y: usize) -> Pixel<'_> {
        let at = y * TILE + x;
        Pixel { color: &mut self.color.0[at], depth: &mut self.depth.0[at], stencil: &mut self.stencil.0[at] }
    }

    /// Whether all pixels in the block with a pixel at (x, y) are nearer than a depth, or as near if a test says that
    /// this is enough.
    #[inline(always)]
    pub(super) fn hides<T: Test>(&mut self, x: usize, y: usize, depth: f64) -> bool {
        let block = block_at(x, y);
        if self.left[block] == 0 {
            self.look(block);
        }
        let farthest = f64::from(self.farthest[block]);
        let hides = if T::TIES { depth > farthest } else { depth >= farthest };
        if hides {
            self.patience[block] = PATIENCE;
        }
        hides
    }

    /// Looks for the farthest pixel of a block.
    #[inline(never)]
    fn look(&mut self, block: usize) {
        let [x, y] = [block % ACROSS * BLOCK, block / ACROSS * LANES];
        let mut farthest = [f32::NEG_INFINITY; BLOCK];
        for row in 0..LANES {
            let depths = *self.row::<BLOCK>(x, y + row).0;
            for i in 0..BLOCK {
                farthest[i] = greatest(farthest[i], depths[i]);
            }
        }
        self.farthest[block] = greatest_of(&farthest);
        self.left[block] = self.patience[block];
        self.patience[block] = (2 * self.patience[block]).min(MOST_PATIENCE);
    }

    /// No pixel of the tile is farther than this.
    #[inline(always)]
    pub(super) fn farthest_of_all(&self) -> f32 {
        let mut farthest = [f32::NEG_INFINITY; BLOCK];
        for blocks in self.farthest.as_chunks::<BLOCK>().0 {
            for i in 0..BLOCK {
                farthest[i] = greatest(farthest[i], blocks[i]);
            }
        }
        greatest_of(&farthest)
    }

    /// From now on no pixel of the block is farther than `depth`.
    #[inline(always)]
    pub(super) fn bring(&mut self, x: usize, y: usize, depth: f32) {
        let farthest = &mut self.farthest[block_at(x, y)];
        *farthest = if depth < *farthest { depth } else { *farthest };
    }
}

#[inline(always)]
fn greatest(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// Compared as integers of the same order: of these the compiler knows how to find the greatest of a vector.
#[inline(always)]
fn greatest_of(values: &[f32; BLOCK]) -> f32 {
    let flip = |bits: i32| bits ^ (bits >> 31 & i32::MAX);
    let mut greatest = i32::MIN;
    for value in values {
        greatest = greatest.max(flip(value.to_bits() as i32));
    }
    f32::from_bits(flip(greatest) as u32)
}

#[inline(always)]
fn block_at(x: usize, y: usize) -> usize {
    (y / LANES * ACROSS + x / BLOCK) % BLOCKS
}
