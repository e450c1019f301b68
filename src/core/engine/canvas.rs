//! What is drawn to: colours, depths and stencil values, and which tiles still hold what they were cleared to.

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

    /// Forgets which tiles are clean, if they would be cleared to something else now.
    pub(super) fn expect(&mut self, clear: &Clear) {
        if !self.cleared.same(clear) {
            self.clean.fill(false);
            self.cleared = *clear;
        }
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
