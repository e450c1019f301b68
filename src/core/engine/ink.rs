//! What the fragments that pass leave in a tile: a colour, the number of their triangle, or what a painter makes of
//! what is there.

use super::{
    Stats,
    paint::{Brushes, PaintOrder, Painter},
};

/// Colours the pixels of a row.
pub(super) trait Ink {
    /// Whether fragments are counted, also those that are hidden.
    const COUNTS: bool;
    /// Whether the pixels that are drawn are remembered.
    const TOUCHES: bool;

    /// What neighbouring pixels hold after a triangle with that colour; `painted` is what they hold. Of each, the
    /// masks say whether it is covered and whether it passes. Unless an ink does otherwise, those that pass hold the
    /// colour.
    #[inline(always)]
    fn row<const N: usize>(
        &mut self,
        color: u32,
        _pixel: [u32; 2],
        [_covered, drawn]: [&[u32; N]; 2],
        painted: [u32; N],
        _stats: &mut Stats,
    ) -> [u32; N] {
        let mut new = painted;
        for i in 0..N {
            new[i] = color & drawn[i] | painted[i] & !drawn[i];
        }
        new
    }
}

/// One colour for all pixels of a triangle.
pub(super) struct Flat;

/// The number of the triangle, to be painted later.
pub(super) struct Numbers;

/// Painted at once.
pub(super) struct Wet<'b, 'p, P: Painter>(pub(super) &'b mut Brushes<'p, P>);

impl Ink for Flat {
    const COUNTS: bool = false;
    const TOUCHES: bool = false;
}

impl Ink for Numbers {
    const COUNTS: bool = true;
    const TOUCHES: bool = false;
}

impl<P: Painter> Ink for Wet<'_, '_, P> {
    const COUNTS: bool = true;
    const TOUCHES: bool = true;

    #[inline(never)]
    fn row<const N: usize>(
        &mut self,
        color: u32,
        [x, y]: [u32; 2],
        [covered, drawn]: [&[u32; N]; 2],
        mut painted: [u32; N],
        stats: &mut Stats,
    ) -> [u32; N] {
        let Some(triangle) = color.checked_sub(1) else { return painted };
        let asked = if self.0.painter().order() == PaintOrder::EachCovered { covered } else { drawn };
        let mut codes = painted.map(u32::to_ne_bytes);
        let mut start = 0;
        for run in asked.chunk_by(|a, b| a == b) {
            let end = start + run.len();
            if run[0] != 0 {
                self.0.paint(triangle, [x + start as u32, y], &mut codes[start..end], stats);
            }
            start = end;
        }
        for i in 0..N {
            if drawn[i] != 0 {
                painted[i] = u32::from_ne_bytes(codes[i]);
            }
        }
        painted
    }
}
