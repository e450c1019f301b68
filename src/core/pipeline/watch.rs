//! What happens to each pixel of an image, counted while the image is drawn, for who asks.

use super::{
    Frame, Outputs, ScreenTriangle, Skips,
    fragments::{FragmentState, ImageState, Target},
};
use crate::scene::Scene;
use std::ops::Range;

/// The number of no piece.
const NOBODY: u32 = u32::MAX;

/// Counts of each pixel, row by row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PixelCounts {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Fragments that scan conversion made within the scissor, also those discarded later; with several samples
    /// a pixel, triangles that cover one.
    pub generated: Vec<u32>,
    /// Fragments whose colour was written.
    pub written: Vec<u32>,
    /// The piece that was scan converted last, and the one that was written last, counted over all pieces.
    last: Vec<[u32; 2]>,
    /// The pieces.
    triangles: Vec<ScreenTriangle>,
    /// The piece in hand.
    piece: u32,
}

impl PixelCounts {
    /// Draws a scene once more and counts. `outputs` are those of the same scene.
    ///
    /// Nothing depends on the skips that `outputs` were made with.
    pub fn of(scene: &Scene, outputs: &Outputs) -> Self {
        let state = ImageState::new(scene, Default::default(), Skips::ALL);
        let mut frame = Frame::default();
        let mut target = Target::new(state, &mut frame);
        let pixels = frame.stencil.len();
        target.watch = Some(Box::new(Self {
            size: scene.size,
            generated: vec![0; pixels],
            written: vec![0; pixels],
            last: vec![[NOBODY; 2]; pixels],
            triangles: outputs.triangles().collect(),
            piece: NOBODY,
        }));
        for (draw, stages) in scene.draws.iter().zip(&outputs.draws) {
            target.draw(stages, &FragmentState::new(draw), &mut frame);
        }
        target.watch.take().map(|counts| *counts).unwrap_or_default()
    }

    /// A piece that is not carried comes.
    pub(super) fn next(&mut self) {
        self.piece = self.piece.wrapping_add(1);
    }

    /// The piece in hand has fragments at pixels of a row.
    pub(super) fn generated(&mut self, pixels: Range<usize>) {
        for (count, last) in self.generated[pixels.clone()].iter_mut().zip(&mut self.last[pixels]) {
            *count += 1;
            last[0] = self.piece;
        }
    }

    /// The piece in hand was written to a pixel.
    #[cold]
    pub(super) fn written(&mut self, pixel: usize) {
        self.written[pixel] += 1;
        self.last[pixel][1] = self.piece;
    }

    /// The piece that was scan converted last at a pixel, counted row by row, whatever became of it.
    pub fn last_generated(&self, pixel: usize) -> Option<&ScreenTriangle> {
        self.last(pixel, 0)
    }

    /// The piece that was written last to a pixel, counted row by row: the one that is seen.
    pub fn last_written(&self, pixel: usize) -> Option<&ScreenTriangle> {
        self.last(pixel, 1)
    }

    fn last(&self, pixel: usize, which: usize) -> Option<&ScreenTriangle> {
        // Nobody is no piece.
        self.triangles.get(self.last.get(pixel)?[which] as usize)
    }
}
