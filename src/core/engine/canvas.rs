//! What is drawn to: colours, depths and stencil values, and which tiles still hold what they were cleared to.

use std::ops::Range;

/// Pixels a side of a tile: colours and depths of one fit the first-level cache together.
pub(super) const TILE: usize = 64;

/// What empty pixels hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clear {
    /// Red, green, blue, alpha codes.
    pub color: [u8; 4],
    /// Depth, as it is stored.
    pub depth: f32,
    /// Stencil value.
    pub stencil: u8,
}

impl Default for Clear {
    /// Black, transparent, at depth 1.
    fn default() -> Self {
        Self { color: [0; 4], depth: 1.0, stencil: 0 }
    }
}

impl Clear {
    /// Whether both leave the same bits.
    fn same(&self, other: &Self) -> bool {
        self.color == other.color
            && self.depth.to_bits() == other.depth.to_bits()
            && self.stencil == other.stencil
    }
}

/// An image with depths and, if wanted, stencil values, row by row from row 0. Depths of unorm formats are stored as
/// their codes, whole numbers.
#[derive(Clone, Debug)]
pub struct Canvas {
    pub(super) size: [u32; 2],
    pub(super) color: Vec<u8>,
    pub(super) depth: Vec<f32>,
    /// Empty if there is no stencil.
    pub(super) stencil: Vec<u8>,
    /// For each tile, row by row, whether it holds `cleared` and nothing else.
    pub(super) clean: Vec<bool>,
    pub(super) cleared: Clear,
    /// For each row of each tile, which of its pixels were painted since they were cleared.
    pub(super) painted: Vec<[u64; TILE]>,
}

impl Canvas {
    /// An empty image; width and height in pixels, each in `1..=16384`. `stencil` makes room for stencil
    /// values.
    pub fn new(size: [u32; 2], clear: Clear, stencil: Stencil) -> Self {
        let pixels = size[0] as usize * size[1] as usize;
        let stencil = match stencil {
            Stencil::Without => Vec::new(),
            Stencil::With => vec![clear.stencil; pixels],
        };
        let mut canvas = Self::around(size, clear.color.repeat(pixels), vec![clear.depth; pixels], stencil);
        canvas.clean.fill(true);
        canvas.cleared = clear;
        canvas
    }

    /// Takes over buffers and what they hold; an empty `stencil` is none. `None` if a length is not the
    /// product of width and height, or four times that of the colours' bytes.
    pub fn from_parts(size: [u32; 2], color: Vec<u8>, depth: Vec<f32>, stencil: Vec<u8>) -> Option<Self> {
        let pixels = size[0] as usize * size[1] as usize;
        let fits = color.len() == 4 * pixels
            && depth.len() == pixels
            && (stencil.is_empty() || stencil.len() == pixels);
        fits.then(|| Self::around(size, color, depth, stencil))
    }

    fn around(size: [u32; 2], color: Vec<u8>, depth: Vec<f32>, stencil: Vec<u8>) -> Self {
        let [columns, rows] = tiles(size);
        let tiles = columns * rows;
        let (clean, painted) = (vec![false; tiles], vec![[0; TILE]; tiles]);
        Self { size, color, depth, stencil, clean, cleared: Clear::default(), painted }
    }

    /// Gives the colours, depths and stencil values back.
    pub fn into_parts(self) -> (Vec<u8>, Vec<f32>, Vec<u8>) {
        (self.color, self.depth, self.stencil)
    }

    /// Swaps the buffers with others of the same lengths, which hold the same.
    pub(crate) fn swap(&mut self, color: &mut Vec<u8>, depth: &mut Vec<f32>, stencil: &mut Vec<u8>) {
        std::mem::swap(&mut self.color, color);
        std::mem::swap(&mut self.depth, depth);
        std::mem::swap(&mut self.stencil, stencil);
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Red, green, blue, alpha codes of each pixel.
    pub fn color(&self) -> &[[u8; 4]] {
        self.color.as_chunks().0
    }

    /// The depth of each pixel.
    pub fn depth(&self) -> &[f32] {
        &self.depth
    }

    /// The stencil value of each pixel; empty if there is none.
    pub fn stencil(&self) -> &[u8] {
        &self.stencil
    }

    /// The rows of tiles, from row 0.
    pub(super) fn strips(&mut self) -> Vec<Strip<'_>> {
        let [width, height] = self.size;
        let columns = tiles(self.size)[0];
        let pixels = width as usize * TILE;
        let mut stencils = self.stencil.chunks_mut(pixels);
        let buffers = self.color.chunks_mut(4 * pixels).zip(self.depth.chunks_mut(pixels));
        let tiles = self.clean.chunks_mut(columns).zip(self.painted.chunks_mut(columns));
        let strips = (0..height).step_by(TILE).zip(buffers).zip(tiles);
        strips
            .map(|((top, (color, depth)), (clean, painted))| {
                let stencil = stencils.next().unwrap_or_default();
                let rows = (height - top).min(TILE as u32);
                Strip { width, top, rows, color, depth, stencil, clean, painted }
            })
            .collect()
    }

    /// Forgets which tiles are clean, if they would be cleared to something else now.
    pub(super) fn expect(&mut self, clear: &Clear) {
        if !self.cleared.same(clear) {
            self.clean.fill(false);
            self.cleared = *clear;
        }
    }
}

/// A row of tiles of a canvas.
pub(super) struct Strip<'c> {
    pub(super) width: u32,
    /// Its first row of pixels, and how many it has.
    pub(super) top: u32,
    pub(super) rows: u32,
    pub(super) color: &'c mut [u8],
    pub(super) depth: &'c mut [f32],
    pub(super) stencil: &'c mut [u8],
    pub(super) clean: &'c mut [bool],
    pub(super) painted: &'c mut [[u64; TILE]],
}

impl Strip<'_> {
    /// How many pixels a tile has that begins at a column.
    pub(super) fn pixels(&self, left: u32) -> u64 {
        u64::from((self.width - left).min(TILE as u32)) * u64::from(self.rows)
    }

    /// Where the rows of such a tile lie in the buffers.
    pub(super) fn rows(&self, left: u32) -> impl Iterator<Item = Range<usize>> + Clone + use<> {
        let (width, left) = (self.width as usize, left as usize);
        let columns = TILE.min(width - left);
        (0..self.rows as usize).map(move |row| row * width + left..row * width + left + columns)
    }
}

/// Whether a canvas has stencil values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stencil {
    /// None.
    #[default]
    Without,
    /// One a pixel.
    With,
}

/// How many tiles stand beside and above each other.
pub(super) fn tiles(size: [u32; 2]) -> [usize; 2] {
    size.map(|pixels| (pixels as usize).div_ceil(TILE))
}
