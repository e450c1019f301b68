//! One tile: its colours, depths and stencil values in the first-level cache, and what is known of the depths of
//! whole blocks.
//!
//! *Source:* Greene, Kass, Miller, Hierarchical Z-Buffer Visibility, SIGGRAPH 1993 (one level of it: blocks).

use super::{
    Stats,
    canvas::{Clear, Stencil, Strip, TILE},
    lanes::LANES,
    paint::{Brushes, Painter},
    stamp::{self, Each, Place, SIDE, STAMP, STAMPS, band, band_mut, copy_row, set_row},
    test::Test,
};

/// Columns of a block; it has [`LANES`] rows.
pub(super) const BLOCK: usize = 16;
const ACROSS: usize = TILE / BLOCK;
const BLOCKS: usize = ACROSS * (TILE / LANES);

/// After so many pieces drawn in a block its farthest depth is looked for again; after more where that was in vain.
const PATIENCE: u8 = 4;
const MOST_PATIENCE: u8 = 64;

/// Begins at a cache line, so that no stamp lies in two.
#[repr(align(64))]
#[derive(Debug)]
struct Aligned<T>(T);

/// The pixels of a tile.
#[derive(Debug)]
pub(super) struct Tile {
    color: Aligned<[Each<u32>; STAMPS]>,
    depth: Aligned<[Each<f32>; STAMPS]>,
    stencil: Aligned<[Each<u8>; STAMPS]>,
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
            color: Aligned([[0; STAMP]; STAMPS]),
            depth: Aligned([[0.0; STAMP]; STAMPS]),
            stencil: Aligned([[0; STAMP]; STAMPS]),
            touched: [0; TILE],
            farthest: [0.0; BLOCKS],
            left: [0; BLOCKS],
            patience: [0; BLOCKS],
        }
    }
}

impl Tile {
    /// Makes all pixels empty, but for their colours, and for stencil values unless they are asked for.
    pub(super) fn clear(&mut self, clear: &Clear, stencil: Stencil) {
        self.depth.0.fill([clear.depth; STAMP]);
        if stencil == Stencil::With {
            self.stencil.0.fill([clear.stencil; STAMP]);
        }
        self.touched = [0; TILE];
        self.farthest = [clear.depth; BLOCKS];
        (self.left, self.patience) = ([PATIENCE; BLOCKS], [PATIENCE; BLOCKS]);
    }

    /// Takes the pixels of a strip from column `left` on.
    pub(super) fn load(&mut self, strip: &Strip<'_>, left: u32) {
        for (y, range) in strip.rows(left).enumerate() {
            let mut colors = [0; TILE];
            let codes = strip.color[4 * range.start..4 * range.end].as_chunks().0;
            colors.iter_mut().zip(codes).for_each(|(color, codes)| *color = u32::from_ne_bytes(*codes));
            set_row(band_mut(&mut self.color.0, y), y, &colors[..codes.len()]);
            set_row(band_mut(&mut self.depth.0, y), y, &strip.depth[range.clone()]);
            if let Some(stencil) = strip.stencil.get(range) {
                set_row(band_mut(&mut self.stencil.0, y), y, stencil);
            }
        }
        if strip.stencil.is_empty() {
            self.stencil.0.fill([0; STAMP]);
        }
        self.touched = [0; TILE];
        self.farthest = [f32::INFINITY; BLOCKS];
        (self.left, self.patience) = ([0; BLOCKS], [PATIENCE; BLOCKS]);
    }

    /// Gives all pixels one colour.
    pub(super) fn fill_colors(&mut self, color: [u8; 4]) {
        self.color.0.fill([u32::from_ne_bytes(color); STAMP]);
    }

    /// Forgets the colours: from now on they are numbers of triangles, of which 0 is none.
    pub(super) fn number(&mut self) {
        self.fill_colors([0; 4]);
    }

    /// Gives them back.
    pub(super) fn store(&self, strip: &mut Strip<'_>, left: u32) {
        self.store_colors(
            strip,
            left,
            false,
            #[inline(always)]
            |colors, codes| {
                for (codes, color) in codes.iter_mut().zip(colors) {
                    *codes = color.to_ne_bytes();
                }
            },
        );
        self.store_depths(strip, left);
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
        self.store_colors(
            strip,
            left,
            clear.is_none(),
            #[inline(always)]
            |numbers, codes| {
                // Mostly one triangle is seen in all of a stamp.
                let mut differ = 0;
                for number in numbers {
                    differ |= number ^ numbers[0];
                }
                if differ == 0 && (clear.is_some() || numbers[0] > 0) {
                    *codes = [color(numbers[0]); STAMP];
                    return;
                }
                for (codes, number) in codes.iter_mut().zip(numbers) {
                    if clear.is_some() || *number > 0 {
                        *codes = color(*number);
                    }
                }
            },
        );
        self.store_depths(strip, left);
    }

    /// Stores colour codes, made stamp by stamp of what the tile has in place of colours and, if they are to be kept, of
    /// the codes that the strip holds.
    #[inline(always)]
    fn store_colors(
        &self,
        strip: &mut Strip<'_>,
        left: u32,
        keeps: bool,
        set: impl Fn(&Each<u32>, &mut Each<[u8; 4]>),
    ) {
        let mut codes = [[[0; 4]; STAMP]; stamp::ACROSS];
        for y in (0..strip.rows as usize).step_by(SIDE) {
            let rows = (y..).zip(strip.rows(left).skip(y).take(SIDE));
            if keeps {
                for (y, range) in rows.clone() {
                    set_row(&mut codes, y, strip.color[4 * range.start..4 * range.end].as_chunks().0);
                }
            }
            for (codes, colors) in codes.iter_mut().zip(band(&self.color.0, y)) {
                set(colors, codes);
            }
            for (y, range) in rows {
                copy_row(&codes, y, strip.color[4 * range.start..4 * range.end].as_chunks_mut().0);
            }
        }
    }

    fn store_depths(&self, strip: &mut Strip<'_>, left: u32) {
        for (y, range) in strip.rows(left).enumerate() {
            copy_row(band(&self.depth.0, y), y, &mut strip.depth[range.clone()]);
            if let Some(stencil) = strip.stencil.get_mut(range) {
                copy_row(band(&self.stencil.0, y), y, stencil);
            }
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
        for (y, range) in strip.rows(left).enumerate() {
            let codes = strip.color[4 * range.start..4 * range.end].as_chunks_mut().0;
            if let Some(clear) = clear {
                codes.fill(clear.color);
            }
            let mut numbers = [0; TILE];
            copy_row(band(&self.color.0, y), y, &mut numbers);
            let numbers = &numbers[..range.len()];
            let (mut x, mut touched) = (0, 0);
            for run in numbers.chunk_by(|a, b| a == b) {
                let end = x + run.len();
                if let Some(triangle) = run[0].checked_sub(1) {
                    let pixel = [left + x as u32, strip.top + y as u32];
                    brushes.paint(triangle, pixel, &mut codes[x..end], stats);
                    touched |= u64::MAX >> (64 - run.len()) << x;
                }
                x = end;
            }
            self.touched[y] = touched;
        }
        self.store_depths(strip, left);
    }

    /// Adds the pixels that were painted to those that were before, and counts the new ones.
    pub(super) fn mark(&self, painted: &mut [u64; TILE], stats: &mut Stats) {
        for (painted, touched) in painted.iter_mut().zip(self.touched) {
            stats.pixels += u64::from((touched & !*painted).count_ones());
            *painted |= touched;
        }
    }

    /// Pixels of a stamp are painted: all bits or none.
    #[inline(always)]
    pub(super) fn touch(&mut self, place: Place, pixels: &Each<u32>) {
        let [x, y] = place.first();
        for (row, pixels) in pixels.as_chunks::<SIDE>().0.iter().enumerate() {
            let bits: u64 = (0..).zip(pixels).map(|(i, pixel)| u64::from(pixel & 1) << i).sum();
            self.touched[y + row] |= bits << x;
        }
    }

    /// Counts what is drawn in the blocks from column `x` on: what is known of them grows old.
    #[inline(always)]
    pub(super) fn age(&mut self, x: usize, y: usize, columns: usize) {
        for x in [x, x + columns - 1] {
            let left = &mut self.left[block_at(x, y)];
            *left = left.saturating_sub(1);
        }
    }

    /// Depths and colours of a stamp.
    #[inline(always)]
    pub(super) fn stamp(&mut self, place: Place) -> (&mut Each<f32>, &mut Each<u32>) {
        (&mut self.depth.0[place.number()], &mut self.color.0[place.number()])
    }

    /// Stencil values of a stamp.
    #[inline]
    pub(super) fn stencils(&mut self, place: Place) -> &mut Each<u8> {
        &mut self.stencil.0[place.number()]
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
        let mut farthest = [f32::NEG_INFINITY; STAMP];
        for row in (y..y + LANES).step_by(SIDE) {
            for depths in &self.depth.0[Place::of([x, row]).number()..][..BLOCK / SIDE] {
                for i in 0..STAMP {
                    farthest[i] = greatest(farthest[i], depths[i]);
                }
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
