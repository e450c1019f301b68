//! What the fragments that pass leave in a tile: a colour, the number of their triangle, or what a painter makes of
//! what is there.

use super::{
    Stats,
    group::{Entry, Group},
    paint::{Brushes, PaintOrder, Painter},
    setup::Setup,
    small::Small,
};

/// Colours the pixels of a row.
pub(super) trait Ink {
    /// Whether fragments are counted, also those that are hidden.
    const COUNTS: bool;
    /// Whether the pixels that are drawn are remembered.
    const TOUCHES: bool;
    /// Whether the half-planes of the edges are asked for.
    const SHADES: bool = false;

    /// Asks for what the next triangles will need.
    #[inline(always)]
    fn fetch(&self, _next: &[Entry]) {}

    /// Prepares for a few triangles.
    #[inline(always)]
    fn set_up(&mut self, _group: &Group, _setup: &Setup, _small: &Small) {}

    /// What neighbouring pixels hold after a triangle with that colour; `painted` is what they hold. Of each, the
    /// masks say whether it is covered and whether it passes. Unless an ink does otherwise, those that pass hold the
    /// colour.
    #[inline(always)]
    fn row<const N: usize>(
        &mut self,
        Stroke { color, .. }: Stroke<'_, N>,
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

/// A part of a row of a triangle.
#[derive(Clone, Copy)]
pub(super) struct Stroke<'s, const N: usize> {
    /// Colour codes, or a number from 1, of the triangle in this lane.
    pub(super) color: u32,
    pub(super) lane: usize,
    /// The first pixel, on the image.
    pub(super) pixel: [u32; 2],
    /// The half-planes of the edges at all pixels; not numbers where the exact colour is asked for.
    pub(super) planes: &'s [[f32; N]; 3],
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
        Stroke { color, pixel: [x, y], .. }: Stroke<'_, N>,
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
