//! The stored depth of every pixel, and the test against it.

use super::{DepthFormat, DepthState};

/// One depth code a pixel, row by row from row 0.
#[derive(Debug, PartialEq, Eq)]
pub struct DepthBuffer {
    size: [u32; 2],
    format: DepthFormat,
    codes: Vec<u32>,
}

impl Clone for DepthBuffer {
    fn clone(&self) -> Self {
        Self { codes: self.codes.clone(), ..*self }
    }

    fn clone_from(&mut self, from: &Self) {
        self.codes.clone_from(&from.codes);
        (self.size, self.format) = (from.size, from.format);
    }
}

impl DepthBuffer {
    /// Every pixel at the depth `clear`.
    pub fn new(size: [u32; 2], format: DepthFormat, clear: f32) -> Self {
        Self { size, format, codes: vec![format.encode(clear); size[0] as usize * size[1] as usize] }
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// How a depth is stored.
    pub fn format(&self) -> DepthFormat {
        self.format
    }

    /// All codes; see [`DepthFormat::decode`].
    pub fn codes(&self) -> &[u32] {
        &self.codes
    }

    /// Puts one code into a range of [`codes`](Self::codes).
    pub fn fill(&mut self, range: std::ops::Range<usize>, code: u32) {
        self.codes[range].fill(code);
    }

    /// A range of [`codes`](Self::codes), to be tested against and written.
    pub fn codes_mut(&mut self, range: std::ops::Range<usize>) -> &mut [u32] {
        &mut self.codes[range]
    }

    /// The stored code of a pixel of the buffer.
    #[inline]
    pub fn code(&self, [x, y]: [u32; 2]) -> u32 {
        self.codes[self.index([x, y])]
    }

    /// The depth test: whether a fragment's code passes against the stored one, which it then
    /// replaces if the state writes. A state without a test lets all pass and writes nothing.
    #[inline]
    pub fn test(&mut self, state: DepthState, pixel: [u32; 2], code: u32) -> bool {
        let index = self.index(pixel);
        self.format.test(state, code, &mut self.codes[index])
    }

    /// Whether [`test`](Self::test) would pass; nothing is stored.
    #[inline]
    pub fn would_pass(&self, state: DepthState, pixel: [u32; 2], code: u32) -> bool {
        let mut stored = self.code(pixel);
        self.format.test(state, code, &mut stored)
    }

    /// Stores a code, whatever is there.
    pub(crate) fn set(&mut self, pixel: [u32; 2], code: u32) {
        let index = self.index(pixel);
        self.codes[index] = code;
    }

    /// Where a pixel stands in [`codes`](Self::codes).
    #[inline]
    pub(crate) fn index(&self, [x, y]: [u32; 2]) -> usize {
        y as usize * self.size[0] as usize + x as usize
    }
}

impl DepthFormat {
    /// The test of [`DepthBuffer::test`] against one stored code.
    #[inline]
    pub fn test(self, state: DepthState, code: u32, stored: &mut u32) -> bool {
        if !state.test {
            return true;
        }
        let passes = match self {
            Self::F32 => state.compare.passes(f32::from_bits(code), f32::from_bits(*stored)),
            _ => state.compare.passes(code, *stored),
        };
        if passes && state.write {
            *stored = code;
        }
        passes
    }
}
