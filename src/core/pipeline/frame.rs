//! The image with its depths and stencil values.

use super::Stats;
use crate::depth::DepthFormat;

/// One image. Row 0 comes first; it is the highest if y points down, else the lowest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frame {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Red, green, blue, alpha codes; `4 * width * height` bytes.
    pub color: Vec<u8>,
    /// The stored depth of each pixel; of a unorm format `code / (2^n - 1)`.
    pub depth: Vec<f32>,
    /// The stored code of each pixel, unless the format is f32.
    pub depth_codes: Option<Vec<u32>>,
    /// The stencil value of each pixel.
    pub stencil: Vec<u8>,
    /// What the stages counted.
    pub stats: Stats,
}

impl Frame {
    /// The colour codes of a pixel of the image.
    pub fn pixel(&self, pixel: [u32; 2]) -> [u8; 4] {
        let at = 4 * self.index(pixel);
        [0, 1, 2, 3].map(|channel| self.color[at + channel])
    }

    /// Where a pixel of the image stands in `depth` and `stencil`.
    pub fn index(&self, [x, y]: [u32; 2]) -> usize {
        y as usize * self.size[0] as usize + x as usize
    }

    /// Whether two images hold the same colours, depths and stencil values bit for bit, however they
    /// were made.
    pub fn same_image(&self, other: &Self) -> bool {
        let bits = |depth: &[f32]| depth.iter().map(|z| z.to_bits()).collect::<Vec<_>>();
        self.size == other.size
            && self.color == other.color
            && bits(&self.depth) == bits(&other.depth)
            && self.depth_codes == other.depth_codes
            && self.stencil == other.stencil
    }
}

/// A stored code as a binary32 depth.
pub(super) fn stored_depth(format: DepthFormat, code: u32) -> f32 {
    format.decode(code) as f32
}
