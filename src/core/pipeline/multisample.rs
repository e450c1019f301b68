//! Several samples a pixel: each has its own colour, depth and stencil value, and the image shows their mean.
//!
//! *Source:* Direct3D 11.3 functional specification, sections 3.5.4 and 3.5.5. A pixel is shaded once: at its
//! centre if all samples are covered, else at the first one that is, so never outside the triangle.

use super::{
    Frame, Skip,
    fragments::{FragmentState, ImageState, Paint, Target},
    shader::Shader,
};
use crate::{
    depth::{DepthFormat, DepthPlane, DepthState, Early},
    math::{Arithmetic, Tally},
    raster::{Samples, Span, cover_samples, edge::centre},
    stencil::StencilOutcome,
};
use std::ops::Range;

/// What one sample holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    pub(super) color: [u8; 4],
    pub(super) depth: u32,
    pub(super) stencil: u8,
}

impl Sample {
    /// What is left by clearing, given the code of the depth.
    pub(super) fn cleared(state: &ImageState, depth: u32) -> Self {
        Self { color: state.clear_color(), depth, stencil: state.clear.stencil }
    }

    /// The colour that a pixel with these samples shows.
    pub(super) fn mean(samples: &[Self], state: &ImageState) -> [u8; 4] {
        [0, 1, 2, 3].map(|channel| {
            let mut codes = [0; Samples::MOST];
            for (code, sample) in codes.iter_mut().zip(samples) {
                *code = sample.color[channel];
            }
            state.samples.resolve(&codes)
        })
    }
}

/// The samples of all pixels, pixel by pixel.
#[derive(Debug)]
pub(super) struct Multisample {
    /// How many a pixel has.
    count: usize,
    samples: Vec<Sample>,
}

impl Multisample {
    pub(super) fn new(state: &ImageState, depth: u32, pixels: usize) -> Self {
        let count = state.samples.count() as usize;
        Self { count, samples: vec![Sample::cleared(state, depth); count * pixels] }
    }

    /// Clears a range of pixels.
    pub(super) fn clear(&mut self, pixels: Range<usize>, state: &ImageState, depth: u32) {
        self.samples[self.count * pixels.start..self.count * pixels.end].fill(Sample::cleared(state, depth));
    }

    fn pixel(&self, index: usize) -> &[Sample] {
        &self.samples[self.count * index..self.count * (index + 1)]
    }

    fn pixel_mut(&mut self, index: usize) -> &mut [Sample] {
        &mut self.samples[self.count * index..self.count * (index + 1)]
    }
}

/// A triangle that is drawn, with what all its pixels share.
pub(super) struct Drawn<'d> {
    pub(super) shader: &'d Shader,
    pub(super) state: &'d FragmentState,
    pub(super) depths: DepthPlane,
    pub(super) image: ImageState,
}

impl Drawn<'_> {
    /// Where the pixel's colour is computed.
    pub(super) fn point(&self, pixel: [u32; 2], mask: u8) -> [f32; 2] {
        let image = &self.image;
        if mask == image.samples.full() {
            centre(pixel[0], pixel[1])
        } else {
            image.samples.point(pixel, mask.trailing_zeros() as usize, image.y_axis)
        }
    }

    /// The pixel's colour.
    pub(super) fn paint(&self, pixel: [u32; 2], mask: u8, tally: &mut Tally) -> Paint<'_> {
        Paint::at_point(self.shader, self.state, self.point(pixel, mask), tally)
    }

    /// Whether the alpha test keeps the pixel, all its samples alike.
    fn is_kept(&self, pixel: [u32; 2], mask: u8, tally: &mut Tally) -> bool {
        let test = self.state.alpha_test;
        test.is_none() || self.shader.at(self.point(pixel, mask), tally).is_kept(test, tally)
    }

    /// Stencil and depth of one sample; also whether its depth code is the stored one.
    pub(super) fn test(
        &self,
        pixel: [u32; 2],
        index: usize,
        sample: &mut Sample,
        tally: &mut Tally,
    ) -> (StencilOutcome, bool) {
        let Self { state, depths, image, .. } = self;
        let point = image.samples.point(pixel, index, image.y_axis);
        let (format, depth_state): (DepthFormat, DepthState) = (image.format, state.depth);
        let Sample { depth, stencil, .. } = sample;
        let mut equal = false;
        let outcome = state.test(stencil, || {
            let code = depths.code_at(point, format, tally);
            equal = code == *depth;
            format.test(depth_state, code, depth)
        });
        (outcome, equal)
    }
}

impl Target {
    /// A triangle with several samples a pixel.
    pub(super) fn sampled_triangle(
        &mut self,
        corners: [[f32; 4]; 3],
        shader: &Shader,
        state: &FragmentState,
    ) {
        let image = self.state;
        let mut tally = Tally::default();
        let depths = DepthPlane::new(corners.map(|[x, y, z, _]| [x, y, z]), Arithmetic::Exact, &mut tally)
            .placed(&state.placement, image.format);
        let drawn = Drawn { shader, state, depths, image };
        let (vertices, settings) = (corners.map(|[x, y, ..]| [x, y]), image.settings());
        let mut row = None;
        cover_samples(vertices, image.samples, &settings, &mut tally, &mut |pixel, mask| {
            if row != Some(pixel[1]) {
                row = Some(pixel[1]);
                self.counts.spans += 1;
            }
            self.sampled_pixel(pixel, mask, &drawn);
        });
        self.counts.tally += tally;
    }

    fn sampled_pixel(&mut self, pixel: [u32; 2], mask: u8, drawn: &Drawn<'_>) {
        let [x, y] = pixel;
        self.touch(Span { y, begin: x, end: x + 1 });
        let index = y as usize * self.state.size[0] as usize + x as usize;
        let Self { state: image, multisample, counts, written, watch, .. } = self;
        let Some(multisample) = multisample else { return };
        counts.fragments += 1;
        if drawn.state.scissor.is_some_and(|scissor| !scissor.holds(pixel)) {
            counts.scissored += 1;
            return;
        }
        watch.iter_mut().for_each(|watch| watch.generated(index..index + 1));
        let early = image.skips.has(Skip::EarlyZ);
        let early = early && drawn.state.early(early) != Early::Never;
        let tally = &mut counts.tally;
        let mut paint = if early { None } else { Some(drawn.paint(pixel, mask, tally)) };
        // Until it is known, nothing is stored: a sample that fails early changes nothing.
        let mut kept = drawn.state.alpha_test.is_none();
        if !kept && !early {
            kept = drawn.is_kept(pixel, mask, tally);
            if !kept {
                counts.discarded += 1;
                return;
            }
        }
        let (mut passed, mut reached_depth, mut equal) = (false, false, false);
        let samples = multisample.pixel_mut(index).iter_mut().enumerate();
        for (i, sample) in samples.filter(|(i, _)| mask & 1 << i != 0) {
            let mut tested = *sample;
            let (outcome, is_equal) = drawn.test(pixel, i, &mut tested, tally);
            equal |= is_equal;
            if outcome == StencilOutcome::Pass && !kept {
                kept = drawn.is_kept(pixel, mask, tally);
                if !kept {
                    counts.discarded += 1;
                    return;
                }
            }
            *sample = tested;
            reached_depth |= outcome != StencilOutcome::Fail;
            if outcome == StencilOutcome::Pass {
                passed = true;
                let paint = paint.get_or_insert_with(|| drawn.paint(pixel, mask, tally));
                sample.color = paint.over(sample.color, drawn.state, tally);
            }
        }
        if equal {
            watch.iter_mut().for_each(|watch| watch.equal(index));
        }
        if passed {
            counts.redrawn += u64::from(std::mem::replace(&mut written[index], true));
            watch.iter_mut().for_each(|watch| watch.written(index));
        } else {
            counts.failed += 1;
            counts.stencil_failed += u64::from(!reached_depth);
            counts.never_colored += u64::from(early);
        }
    }

    /// Writes the mean of each pixel's samples to the frame, and depth and stencil of the first one.
    pub(super) fn resolve(&mut self, frame: &mut Frame) {
        let Self { multisample: Some(multisample), depth, touched, state, .. } = self else { return };
        for (y, columns) in (0..).zip(&*touched) {
            for x in columns.clone() {
                let index = frame.index([x, y]);
                let samples = multisample.pixel(index);
                frame.color[4 * index..4 * index + 4].copy_from_slice(&Sample::mean(samples, state));
                depth.fill(index..index + 1, samples[0].depth);
                frame.stencil[index] = samples[0].stencil;
            }
        }
    }
}
