//! The scissor test: a rectangle of pixels outside of which a draw leaves everything as it is.
//!
//! *Source:* WebGPU, `setScissorRect`. Deviation: a rectangle may reach beyond the image, as it
//! may elsewhere; what counts is what lies in both.

use super::Span;
use serde::{Deserialize, Serialize};

/// Columns `x .. x + width` and rows `y .. y + height`; rows are counted as the image's, row 0 first.
///
/// In a scene file `[x, y, width, height]`, each at most 16384. Without width or height nothing is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(from = "[u32; 4]", into = "[u32; 4]")]
pub struct Scissor {
    /// First column.
    pub x: u32,
    /// First row.
    pub y: u32,
    /// How many columns.
    pub width: u32,
    /// How many rows.
    pub height: u32,
}

impl From<[u32; 4]> for Scissor {
    fn from([x, y, width, height]: [u32; 4]) -> Self {
        Self { x, y, width, height }
    }
}

impl From<Scissor> for [u32; 4] {
    fn from(Scissor { x, y, width, height }: Scissor) -> Self {
        [x, y, width, height]
    }
}

impl Scissor {
    /// One past the last column and row.
    pub fn end(&self) -> [u32; 2] {
        [self.x.saturating_add(self.width), self.y.saturating_add(self.height)]
    }

    /// Whether a pixel passes.
    #[inline]
    pub fn holds(&self, [x, y]: [u32; 2]) -> bool {
        let [right, bottom] = self.end();
        (self.x..right).contains(&x) && (self.y..bottom).contains(&y)
    }

    /// The pixels of a span that pass; an empty span at its place if none does.
    #[inline]
    pub fn clip(&self, span: Span) -> Span {
        let [right, bottom] = self.end();
        let begin = span.begin.max(self.x).min(span.end);
        let end = span.end.min(right).max(begin);
        let inside = (self.y..bottom).contains(&span.y);
        Span { begin, end: if inside { end } else { begin }, ..span }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_span_keeps_the_pixels_that_the_rectangle_holds() {
        for rectangle in [[2, 1, 3, 2], [0, 0, 9, 9], [4, 0, 0, 9], [7, 2, 9, 1], [0, 0, u32::MAX, u32::MAX]]
        {
            let scissor = Scissor::from(rectangle);
            for y in 0..4 {
                for begin in 0..8 {
                    for end in begin..8 {
                        let kept = scissor.clip(Span { y, begin, end });
                        let expected = (begin..end).filter(|x| scissor.holds([*x, y]));
                        assert!(expected.eq(kept.begin..kept.end), "{rectangle:?} {y} {begin}..{end}");
                    }
                }
            }
        }
    }
}
