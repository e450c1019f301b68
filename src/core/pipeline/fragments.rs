//! From screen triangles to the image: scan conversion, stencil, depth, blend, write.

use super::{
    Frame, PixelCounts, Rasterizer, Skip, Skips, Stats,
    counts::Counts,
    draw::DrawOutputs,
    frame::stored_depth,
    multisample::Multisample,
    shader::{Color, Shader},
};
use crate::{
    blend::{AlphaTest, BlendState},
    depth::{DepthBuffer, DepthFormat, DepthPlacement, DepthRow, DepthRows, DepthState, Early},
    interpolate::unorm,
    math::Tally,
    raster::{FillRule, Samples, Scissor, Settings, Span, YAxis, cover, edge::centre},
    scene::{Clear, Draw, Scene, Texture},
    stencil::{StencilOutcome, StencilState},
};
use std::ops::Range;

/// The state of a draw that its fragments need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FragmentState {
    pub(super) depth: DepthState,
    pub(super) placement: DepthPlacement,
    pub(super) scissor: Option<Scissor>,
    pub(super) alpha_test: Option<AlphaTest>,
    pub(super) stencil: Option<StencilState>,
    pub(super) blend: Option<BlendState>,
    pub(super) texture: Option<Texture>,
}

impl FragmentState {
    pub(super) fn new(draw: &Draw) -> Self {
        Self {
            depth: draw.depth,
            placement: draw.placement,
            scissor: draw.scissor,
            alpha_test: draw.alpha_test,
            stencil: draw.stencil,
            blend: draw.blend,
            texture: draw.texture,
        }
    }

    /// The stencil test, then the depth test `depth`, if the draw has one; the stencil value follows.
    #[inline]
    pub(super) fn test(&self, stencil: &mut u8, depth: impl FnOnce() -> bool) -> StencilOutcome {
        StencilState::test(self.stencil.as_ref(), stencil, || !self.depth.test || depth())
    }
}

/// What all fragments share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ImageState {
    pub(super) size: [u32; 2],
    pub(super) clear: Clear,
    pub(super) format: DepthFormat,
    pub(super) samples: Samples,
    pub(super) fill_rule: FillRule,
    pub(super) y_axis: YAxis,
    pub(super) rasterizer: Rasterizer,
    pub(super) skips: Skips,
}

impl ImageState {
    pub(super) fn new(scene: &Scene, rasterizer: Rasterizer, skips: Skips) -> Self {
        Self {
            size: scene.size,
            clear: scene.clear,
            format: scene.depth_format,
            // A scene is refused unless there is a pattern.
            samples: Samples::try_from(scene.samples).unwrap_or_default(),
            fill_rule: scene.fill_rule,
            y_axis: scene.y_axis,
            rasterizer,
            skips,
        }
    }

    pub(super) fn settings(&self) -> Settings {
        Settings {
            fill_rule: self.fill_rule,
            y_axis: self.y_axis,
            skip_row: self.skips.has(Skip::Row),
            ..Settings::new(self.size)
        }
    }

    /// The codes that cleared pixels hold.
    pub(super) fn clear_color(&self) -> [u8; 4] {
        self.clear.color.map(|channel| unorm(channel, 255) as u8)
    }

    /// Whether another image is cleared to the same values.
    fn clears_like(&self, other: &Self) -> bool {
        (self.size, self.format, self.samples, self.clear)
            == (other.size, other.format, other.samples, other.clear)
    }
}

/// The pixels that are drawn to, kept from image to image.
#[derive(Debug)]
pub(super) struct Target {
    pub(super) state: ImageState,
    pub(super) depth: DepthBuffer,
    /// In each row, a range around all pixels that were touched.
    pub(super) touched: Vec<Range<u32>>,
    /// Whether a pixel's colour was written.
    pub(super) written: Vec<bool>,
    /// What the samples hold, if a pixel has several.
    pub(super) multisample: Option<Multisample>,
    /// Fragments counted during one image.
    pub(super) counts: Counts,
    /// Who counts pixel by pixel, if somebody asks.
    pub(super) watch: Option<Box<PixelCounts>>,
    /// What the last image counted.
    stats: Stats,
}

impl Target {
    /// An image of clear values only, written to `frame`.
    pub(super) fn new(state: ImageState, frame: &mut Frame) -> Self {
        let pixels = state.size[0] as usize * state.size[1] as usize;
        let depth = DepthBuffer::new(state.size, state.format, state.clear.depth);
        let code = depth.codes().first().copied().unwrap_or_default();
        frame.size = state.size;
        frame.color = state.clear_color().repeat(pixels);
        frame.depth = vec![stored_depth(state.format, code); pixels];
        frame.depth_codes = state.format.max_code().map(|_| vec![code; pixels]);
        frame.stencil = vec![state.clear.stencil; pixels];
        let touched = vec![0..0; state.size[1] as usize];
        let multisample = (state.samples != Samples::One).then(|| Multisample::new(&state, code, pixels));
        Self {
            state,
            depth,
            multisample,
            touched,
            written: vec![false; pixels],
            counts: Counts::default(),
            watch: None,
            stats: Stats::default(),
        }
    }

    /// Clears for the next image. What the last one did not touch is clear already.
    pub(super) fn clear(&mut self, state: ImageState, frame: &mut Frame) {
        (self.counts, self.stats) = Default::default();
        if !state.skips.has(Skip::Clear) || !self.state.clears_like(&state) {
            *self = Self::new(state, frame);
            return;
        }
        self.state = state;
        let color = state.clear_color();
        let code = state.format.encode(state.clear.depth);
        let depth = stored_depth(state.format, code);
        let mut skipped = self.written.len();
        for (y, columns) in (0..).zip(&mut self.touched) {
            let range = frame.index([columns.start, y])..frame.index([columns.end, y]);
            skipped -= range.len();
            frame.color[4 * range.start..4 * range.end].as_chunks_mut().0.fill(color);
            frame.depth[range.clone()].fill(depth);
            frame.stencil[range.clone()].fill(state.clear.stencil);
            self.depth.fill(range.clone(), code);
            self.multisample.iter_mut().for_each(|samples| samples.clear(range.clone(), &state, code));
            frame.depth_codes.iter_mut().for_each(|codes| codes[range.clone()].fill(code));
            self.written[range].fill(false);
            *columns = 0..0;
        }
        self.stats.skip(Skip::Clear, skipped as u64);
    }

    /// Draws all pieces of a draw, in order.
    pub(super) fn draw(&mut self, draw: &DrawOutputs, state: &FragmentState, frame: &mut Frame) {
        let (screen, pieces) = (draw.screen(), &draw.clipped().pieces);
        self.counts.pieces += pieces.len() as u64;
        for piece in pieces {
            let corners = piece.corners.map(|i| screen[i as usize]);
            if piece.carried {
                self.counts.carry(corners.map(|[x, y, ..]| [x, y]), &self.state);
                continue;
            }
            self.watch.iter_mut().for_each(|watch| watch.next());
            if let Some(shader) = Shader::new(draw, piece, state.texture, &mut self.counts.tally) {
                self.triangle(corners, &shader, state, frame);
            }
        }
    }

    fn triangle(
        &mut self,
        corners: [[f32; 4]; 3],
        shader: &Shader,
        state: &FragmentState,
        frame: &mut Frame,
    ) {
        let vertices = corners.map(|[x, y, ..]| [x, y]);
        let settings = self.state.settings();
        let mut tally = Tally::default();
        if self.multisample.is_some() {
            self.sampled_triangle(corners, shader, state);
            return;
        }
        let depths = DepthRows::new(corners.map(|[x, y, z, _]| [x, y, z]), self.state.format, &mut tally)
            .placed(&state.placement, &mut tally);
        let counts = cover(self.state.rasterizer.algorithm(), vertices, &settings, &mut tally, &mut |span| {
            self.span(span, &depths.row(span.y), shader, state, frame);
        });
        self.counts.row_skipped += counts.skipped;
        self.counts.tally += tally;
    }

    fn span(
        &mut self,
        span: Span,
        depths: &DepthRow<'_>,
        shader: &Shader,
        state: &FragmentState,
        frame: &mut Frame,
    ) {
        self.counts.spans += 1;
        self.counts.fragments += u64::from(span.len());
        let (span, scissored) = state.scissored(span);
        self.counts.scissored += scissored;
        self.touch(span);
        let Self { state: image, depth, written, counts, watch, .. } = self;
        let range = frame.index([span.begin, span.y])..frame.index([span.end, span.y]);
        watch.iter_mut().for_each(|watch| watch.generated(range.clone()));
        let first = range.start;
        let colors = frame.color[4 * range.start..4 * range.end].as_chunks_mut().0;
        let stored = depth.codes_mut(range.clone()).iter_mut().zip(&mut frame.stencil[range.clone()]);
        let pixels = colors.iter_mut().zip(stored).zip(&mut written[range]);
        let early = image.skips.has(Skip::EarlyZ);
        let when = state.early(early);
        let early = early && when != Early::Never;
        let Counts { stencil_failed, redrawn, discarded, tally, .. } = counts;
        let mut failed = 0;
        for (x, ((color, (depth, stencil)), written)) in (span.begin..).zip(pixels) {
            let pixel = [x, span.y];
            let paint = if early { None } else { Some(Paint::new(shader, state, pixel, tally)) };
            let mut equal = false;
            let passes = |depth: &mut u32, tally: &mut Tally| {
                !state.depth.test || {
                    let code = depths.code(x, tally);
                    equal = code == *depth;
                    image.format.test(state.depth, code, depth)
                }
            };
            let keeps =
                |tally: &mut Tally| shader.at(centre(x, span.y), tally).is_kept(state.alpha_test, tally);
            let stored = (stencil, depth);
            let tested = when.test(state.stencil.as_ref(), stored, (passes, keeps), tally);
            if equal {
                watch.iter_mut().for_each(|watch| watch.equal(first + (x - span.begin) as usize));
            }
            let Some(tested) = tested else {
                *discarded += 1;
                continue;
            };
            if tested != StencilOutcome::Pass {
                failed += 1;
                *stencil_failed += u64::from(tested == StencilOutcome::Fail);
                continue;
            }
            let paint = paint.unwrap_or_else(|| Paint::new(shader, state, pixel, tally));
            *color = paint.over(*color, state, tally);
            *redrawn += u64::from(std::mem::replace(written, true));
            watch.iter_mut().for_each(|watch| watch.written(first + (x - span.begin) as usize));
        }
        counts.failed += failed;
        counts.never_colored += if early { failed } else { 0 };
    }

    /// Pixels of a row are drawn to.
    pub(super) fn touch(&mut self, span: Span) {
        let touched = &mut self.touched[span.y as usize];
        *touched = if touched.start == touched.end {
            span.begin..span.end
        } else {
            touched.start.min(span.begin)..touched.end.max(span.end)
        };
    }

    /// Copies the depths to the frame and adds up what was counted.
    pub(super) fn finish<'s>(
        &mut self,
        frame: &mut Frame,
        states: impl Iterator<Item = &'s FragmentState> + Clone,
    ) {
        self.resolve(frame);
        let codes = self.depth.codes();
        for (y, columns) in (0..).zip(&self.touched) {
            let range = frame.index([columns.start, y])..frame.index([columns.end, y]);
            for (depth, code) in frame.depth[range.clone()].iter_mut().zip(&codes[range.clone()]) {
                *depth = stored_depth(self.state.format, *code);
            }
            if let Some(copy) = &mut frame.depth_codes {
                copy[range.clone()].copy_from_slice(&codes[range]);
            }
        }
        self.counts.add_to(&mut self.stats, states);
    }

    /// What the last image counted, from scan conversion on.
    pub(super) fn stats(&self) -> &Stats {
        &self.stats
    }
}

/// The colour of a fragment: codes at once where nothing else can happen to it.
pub(super) enum Paint<'s> {
    Codes([u8; 4]),
    Exact(Color<'s>),
}

impl<'s> Paint<'s> {
    #[inline]
    pub(super) fn new(shader: &'s Shader, state: &FragmentState, pixel: [u32; 2], tally: &mut Tally) -> Self {
        Self::at_point(shader, state, centre(pixel[0], pixel[1]), tally)
    }

    /// The same at any point of the triangle.
    #[inline]
    pub(super) fn at_point(
        shader: &'s Shader,
        state: &FragmentState,
        point: [f32; 2],
        tally: &mut Tally,
    ) -> Self {
        match (state.blend, shader.constant()) {
            (None, Some(codes)) => Self::Codes(codes),
            (None, None) => Self::Codes(shader.at(point, tally).codes(tally)),
            (Some(_), _) => Self::Exact(shader.at(point, tally)),
        }
    }

    /// The codes that are stored after it.
    #[inline]
    pub(super) fn over(&self, stored: [u8; 4], state: &FragmentState, tally: &mut Tally) -> [u8; 4] {
        match (self, &state.blend) {
            (Self::Codes(codes), _) => *codes,
            (Self::Exact(color), Some(blend)) => color.blended(blend, stored, tally),
            (Self::Exact(color), None) => color.codes(tally),
        }
    }
}
