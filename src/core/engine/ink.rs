//! What the fragments that pass leave in a tile: a colour, the number of their triangle, or what a painter makes of
//! what is there.

use super::{
    Stats,
    fill::Subject,
    group::{Entry, Group},
    lanes::LANES,
    paint::{Brushes, PaintOrder, Painter},
    setup::Setup,
    small::Small,
    stamp::{Each, Place, SIDE, STAMP},
};

/// Colours the pixels of a stamp.
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

    /// Colours the pixels of a stamp. Of each, the masks say whether it is covered and whether it passes. Unless an ink
    /// does otherwise, those that pass hold the stroke's colour.
    #[inline(always)]
    fn stamp(
        &mut self,
        Stroke { color, .. }: Stroke<'_>,
        [_covered, drawn]: [&Each<u32>; 2],
        colors: &mut Each<u32>,
        _stats: &mut Stats,
    ) {
        for i in 0..STAMP {
            colors[i] = color & drawn[i] | colors[i] & !drawn[i];
        }
    }
}

/// A stamp of a triangle.
#[derive(Clone, Copy)]
pub(super) struct Stroke<'s> {
    /// Colour codes, or a number from 1, of the triangle in this lane.
    pub(super) color: u32,
    pub(super) lane: usize,
    /// The first pixel, on the image.
    pub(super) pixel: [u32; 2],
    /// The half-planes of the edges at all pixels.
    pub(super) planes: &'s [Each<f32>; 3],
}

impl<'s> Stroke<'s> {
    #[inline(always)]
    pub(super) fn new(subject: &Subject<'_>, place: Place, planes: &'s [Each<f32>; 3]) -> Self {
        let lane = subject.lane % LANES;
        let ([left, top], [x, y]) = (subject.job.origin, place.first());
        Self { color: subject.group.colors[lane], lane, pixel: [left + x as u32, top + y as u32], planes }
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
    fn stamp(
        &mut self,
        Stroke { color, pixel: [x, y], .. }: Stroke<'_>,
        [covered, drawn]: [&Each<u32>; 2],
        colors: &mut Each<u32>,
        stats: &mut Stats,
    ) {
        let Some(triangle) = color.checked_sub(1) else { return };
        let asked = if self.0.painter().order() == PaintOrder::EachCovered { covered } else { drawn };
        let mut codes = colors.map(u32::to_ne_bytes);
        let rows = asked.as_chunks::<SIDE>().0.iter().zip(codes.as_chunks_mut::<SIDE>().0);
        for ((asked, codes), y) in rows.zip(y..) {
            let mut start = 0;
            for run in asked.chunk_by(|a, b| a == b) {
                let end = start + run.len();
                if run[0] != 0 {
                    self.0.paint(triangle, [x + start as u32, y], &mut codes[start..end], stats);
                }
                start = end;
            }
        }
        for i in 0..STAMP {
            if drawn[i] != 0 {
                colors[i] = u32::from_ne_bytes(codes[i]);
            }
        }
    }
}
