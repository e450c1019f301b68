//! Colours that depend on the pixel: each pixel of opaque triangles is painted once, when its tile is finished, by
//! the triangle that is seen there; where colours are blended, each fragment that passes is painted at once.
//!
//! *Source:* Deering, Winner, Schediwy, Duffy, Hunt, The Triangle Processor and Normal Vector Shader, SIGGRAPH
//! 1988 (shading deferred until visibility is known).

use super::Stats;
use crate::math::Tally;

/// Gives the pixels of triangles their colours. Triangles count as in [`Triangles`](super::Triangles).
pub trait Painter: Sync {
    /// What painting one triangle needs.
    type Brush;

    /// Sets a triangle up. It covers a pixel.
    fn brush(&self, triangle: u32, tally: &mut Tally) -> Self::Brush;

    /// Paints over the colour codes of neighbouring pixels of one row, at most 64, from column x on. They hold what was drawn
    /// before if that matters.
    fn paint(&self, brush: &mut Self::Brush, pixel: [u32; 2], colors: &mut [[u8; 4]], tally: &mut Tally);

    /// When colours are made.
    fn order(&self) -> PaintOrder;
}

/// When colours are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PaintOrder {
    /// Once for each pixel: the last triangle drawn there hides all others.
    Last,
    /// Once for each fragment that passes, in order: blending.
    EachPassing,
    /// For each fragment before it is tested, in order; wasted on those that fail.
    EachCovered,
}

/// How many brushes are kept: neighbouring rows ask for the same few triangles.
const KEPT: usize = 64;

/// Brushes of the triangles that were painted last.
pub(super) struct Brushes<'p, P: Painter> {
    painter: &'p P,
    kept: Vec<Option<(u32, P::Brush)>>,
}

impl<'p, P: Painter> Brushes<'p, P> {
    pub(super) fn new(painter: &'p P) -> Self {
        Self { painter, kept: (0..KEPT).map(|_| None).collect() }
    }

    pub(super) fn painter(&self) -> &'p P {
        self.painter
    }

    /// Paints neighbouring pixels of one row.
    pub(super) fn paint(
        &mut self,
        triangle: u32,
        pixel: [u32; 2],
        colors: &mut [[u8; 4]],
        stats: &mut Stats,
    ) {
        stats.painted += colors.len() as u64;
        let kept = &mut self.kept[triangle as usize % KEPT];
        if !matches!(kept, Some((of, _)) if *of == triangle) {
            *kept = Some((triangle, self.painter.brush(triangle, &mut stats.tally)));
        }
        if let Some((_, brush)) = kept {
            self.painter.paint(brush, pixel, colors, &mut stats.tally);
        }
    }
}
