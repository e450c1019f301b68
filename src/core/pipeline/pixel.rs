//! Why a pixel looks as it does: every triangle that could have touched it, in order, with what
//! became of it there.
//!
//! Computed for one pixel on demand; the image's own run keeps nothing for it. The outcomes do not
//! depend on the skips.

use super::{
    DrawOutputs, Outputs, Piece, Skips,
    evaluate::Pipeline,
    fragments::{FragmentState, ImageState},
    multisample::{Drawn, Sample},
    names::triangle_name,
    outcome::{Later, Outcome, PixelEntry, PixelHistory, Placed, SampleEntry},
    shader::{Color, Shader},
    stages::{Clipped, Point},
    visible::Visible,
};
use crate::{
    clip::polygon::Plane,
    cull::facing,
    depth::DepthPlane,
    math::{Arithmetic, Tally, edge_value},
    raster::{
        Samples, YAxis,
        edge::{Edges, centre},
    },
    scene::{Draw, Scene},
    stencil::StencilOutcome,
    transform::{DepthRange, Viewport, divide},
};

/// In a scene with at most this many triangles all are listed, else those whose box holds the pixel.
const LIST_ALL: usize = 16;

/// The history of a pixel of the image. `outputs` are those of the same scene.
pub fn pixel_history(scene: &Scene, outputs: &Outputs, pixel: [u32; 2]) -> PixelHistory {
    let image = ImageState::new(scene, Default::default(), Skips::NONE);
    let clear_depth = image.format.encode(image.clear.depth);
    let mut probe = Probe {
        pixel,
        at: centre(pixel[0], pixel[1]),
        image,
        viewport: outputs.viewport,
        list_all: outputs.draws.iter().map(|draw| draw.mesh().triangles.len()).sum::<usize>() <= LIST_ALL,
        held: vec![Sample::cleared(&image, clear_depth); image.samples.count() as usize],
        entries: Vec::new(),
        tally: Tally::default(),
    };
    for (index, (draw, stages)) in scene.draws.iter().zip(&outputs.draws).enumerate() {
        probe.draw(index, draw, stages);
    }
    let Probe { held, mut entries, .. } = probe;
    for sample in 0..held.len() {
        settle(&mut entries, sample, scene);
    }
    for entry in &mut entries {
        let decisive = entry.samples.iter().map(|sample| sample.outcome).reduce(farther);
        entry.outcome = decisive.unwrap_or(entry.outcome);
    }
    PixelHistory {
        pixel,
        samples: image.samples,
        clear_color: image.clear_color(),
        clear_depth,
        entries,
        color: Sample::mean(&held, &image),
        depth: held[0].depth,
        stencil: held[0].stencil,
    }
}

/// What later fragments did to those of a sample.
fn settle(entries: &mut [PixelEntry], sample: usize, scene: &Scene) {
    let mut fate = Later::Shown;
    for PixelEntry { draw, samples, .. } in entries.iter_mut().rev() {
        let own = samples.iter_mut().find(|own| usize::from(own.sample) == sample);
        if let Some(SampleEntry { outcome: Outcome::Written { later, .. }, .. }) = own {
            *later = fate;
            let blends = scene.draws[*draw].blend.is_some();
            fate = if blends && fate != Later::Overwritten { Later::BlendedOver } else { Later::Overwritten };
        }
    }
}

/// That of two samples' outcomes where the fragment came farther, or was seen longer; else the first.
fn farther(a: Outcome, b: Outcome) -> Outcome {
    let rank = |outcome| match outcome {
        Outcome::Written { later, .. } => (2, Some(later)),
        Outcome::Depth { .. } => (1, None),
        _ => (0, None),
    };
    if rank(b) > rank(a) { b } else { a }
}

/// [`pixel_history`] of a scene that has not been drawn.
pub fn pixel_history_of(scene: &Scene, pixel: [u32; 2]) -> PixelHistory {
    let mut pipeline = Pipeline::default();
    pipeline.update_geometry(scene, Skips::ALL);
    pixel_history(scene, pipeline.outputs(), pixel)
}

/// One pixel while the scene is drawn.
struct Probe {
    pixel: [u32; 2],
    /// Its centre.
    at: [f32; 2],
    image: ImageState,
    viewport: Viewport,
    list_all: bool,
    /// What its samples hold.
    held: Vec<Sample>,
    entries: Vec<PixelEntry>,
    tally: Tally,
}

impl Probe {
    fn draw(&mut self, index: usize, draw: &Draw, stages: &DrawOutputs) {
        let mesh = stages.mesh();
        if let Some(plane) = stages.outside() {
            if self.list_all {
                self.entries.push(PixelEntry {
                    name: draw.name.clone(),
                    draw: index,
                    triangle: None,
                    part: None,
                    outcome: Outcome::ObjectOutside(plane),
                    samples: Vec::new(),
                    at: None,
                    source: None,
                });
            }
            return;
        }
        let state = FragmentState::new(draw);
        let visible = Visible { range: self.viewport.depth_range, unclipped: draw.placement.unclipped };
        let mut pieces = &stages.clipped().pieces[..];
        for (triangle, indices) in (0..).zip(&mesh.triangles) {
            let own = pieces.iter().take_while(|piece| piece.triangle == triangle).count();
            let (these, rest) = pieces.split_at(own);
            pieces = rest;
            let clip = indices.map(|i| stages.clip()[i as usize]);
            let entry = |part: Option<u32>, outcome: Outcome| PixelEntry {
                name: triangle_name((index, draw), triangle, part),
                draw: index,
                triangle: Some(triangle),
                part,
                outcome,
                samples: Vec::new(),
                at: None,
                source: None,
            };
            match self.before_screen(clip, draw, stages, (triangle, visible)) {
                Some((outcome, near)) => {
                    if near || self.list_all {
                        self.entries.push(entry(None, outcome));
                    }
                }
                None if these.is_empty() => {
                    if self.list_all {
                        let removed = visible.removed(clip, &mut self.tally);
                        self.entries.push(entry(None, Outcome::ClippedAway(removed)));
                    }
                }
                None => {
                    for piece in these {
                        let seen = self.piece(piece, (clip, visible), stages, &state);
                        if seen.near || self.list_all {
                            let part = (these.len() > 1).then_some(piece.part);
                            let Seen { outcome, samples, at, source, .. } = seen;
                            self.entries.push(PixelEntry { samples, at, source, ..entry(part, outcome) });
                        }
                    }
                }
            }
        }
    }

    /// Why a triangle did not come to the screen, and whether it would have been near the pixel.
    fn before_screen(
        &mut self,
        clip: [Point; 3],
        draw: &Draw,
        stages: &DrawOutputs,
        (triangle, visible): (u32, Visible),
    ) -> Option<(Outcome, bool)> {
        if let Some(plane) = visible.outside(clip) {
            return Some((Outcome::Outside(plane), false));
        }
        let facing = facing(clip, draw.front, &mut self.tally);
        if !draw.cull.drops(facing) {
            return None;
        }
        let mut clipped = Clipped::default();
        clipped.push(triangle, false, stages.clip(), &stages.varyings(), visible);
        let place = |i: u32| self.viewport.to_screen(divide(clipped.corners[i as usize]));
        let pieces: Vec<_> = clipped.pieces.iter().map(|piece| piece.corners.map(place)).collect();
        let near = pieces.iter().any(|corners| self.is_near(corners));
        let would_cover = pieces.iter().any(|corners| self.coverage(corners).is_ok());
        Some((Outcome::Culled { facing, determinant: determinant(wide(clip)), would_cover }, near))
    }

    /// What became of a piece on the screen.
    fn piece(
        &mut self,
        piece: &Piece,
        (clip, visible): ([Point; 3], Visible),
        stages: &DrawOutputs,
        state: &FragmentState,
    ) -> Seen {
        let corners = piece.corners.map(|i| stages.screen()[i as usize]);
        let near = self.is_near(&corners);
        let unseen = |outcome, near| Seen { outcome, near, samples: Vec::new(), at: None, source: None };
        let mask = match self.coverage(&corners) {
            Ok(mask) => mask,
            Err(miss) => {
                let cut_off = self.cut_off(clip).filter(|plane| visible.clips_at(*plane));
                return unseen(cut_off.map_or(miss, Outcome::CutOff), near || cut_off.is_some());
            }
        };
        let Some(shader) = Shader::new(stages, piece, state.texture, &mut self.tally) else {
            return unseen(Outcome::ZeroArea, near);
        };
        let bare = DepthPlane::new(corners.map(|[x, y, z, _]| [x, y, z]), Arithmetic::Exact, &mut self.tally);
        let depths = bare.placed(&state.placement, self.image.format);
        let drawn = Drawn { shader: &shader, state, depths, image: self.image };
        let at = drawn.point(self.pixel, mask);
        let color = shader.at(at, &mut self.tally);
        if let Some(outcome) = self.cut(&color, state) {
            return unseen(outcome, near);
        }
        let covered = (0..self.image.samples.count() as u8).filter(|sample| mask & 1 << sample != 0);
        let samples: Vec<_> = covered.map(|sample| self.sample(sample, mask, &drawn, &bare)).collect();
        let written = samples.iter().any(|sample| matches!(sample.outcome, Outcome::Written { .. }));
        let source = written.then(|| color.values(&mut self.tally));
        Seen { outcome: samples[0].outcome, near, samples, at: Some(at), source }
    }

    /// The tests of one sample, and what they leave there. `bare` is the plane without a bias.
    fn sample(&mut self, sample: u8, mask: u8, drawn: &Drawn<'_>, bare: &DepthPlane) -> SampleEntry {
        let Self { pixel, image, held, tally, .. } = self;
        let (pixel, index) = (*pixel, usize::from(sample));
        let Drawn { state, depths, .. } = drawn;
        let before = held[index];
        let held = &mut held[index];
        let (tested, _) = drawn.test(pixel, index, held, tally);
        let point = image.samples.point(pixel, index, image.y_axis);
        let new = depths.code_at(point, image.format, tally);
        let placed = (!state.placement.is_plain())
            .then(|| Placed { plane: bare.depth_at(point, tally).into(), bias: depths.bias() });
        let (stored, stencil) = (before.depth, [before.stencil, held.stencil]);
        let outcome = match tested {
            StencilOutcome::Fail => Outcome::Stencil { stored: stencil },
            StencilOutcome::DepthFail => Outcome::Depth { new, stored, stencil },
            StencilOutcome::Pass => {
                held.color = drawn.paint(pixel, mask, tally).over(before.color, state, tally);
                let depth = state.depth.test.then_some(new);
                let color = [before.color, held.color];
                Outcome::Written { depth, stored, color, stencil, later: Later::Shown }
            }
        };
        SampleEntry { sample, outcome, placed }
    }

    /// What keeps a covered pixel from the tests.
    fn cut(&mut self, color: &Color<'_>, state: &FragmentState) -> Option<Outcome> {
        if let Some(scissor) = state.scissor.filter(|scissor| !scissor.holds(self.pixel)) {
            return Some(Outcome::Scissored(scissor));
        }
        let kept = color.is_kept(state.alpha_test, &mut self.tally);
        (!kept).then(|| Outcome::Discarded { alpha: color.values(&mut self.tally)[3] })
    }

    /// Whether the box around a piece holds the pixel's centre or, of several samples, something of the pixel.
    fn is_near(&self, corners: &[Point; 3]) -> bool {
        let around = if self.image.samples == Samples::One { 0.0 } else { 0.5 };
        [0, 1].into_iter().all(|axis| {
            let low = corners.iter().map(|corner| corner[axis]).fold(f32::INFINITY, f32::min);
            let high = corners.iter().map(|corner| corner[axis]).fold(f32::NEG_INFINITY, f32::max);
            (low - around..=high + around).contains(&self.at[axis])
        })
    }

    /// Which samples a piece covers, or why none.
    fn coverage(&mut self, corners: &[Point; 3]) -> Result<u8, Outcome> {
        let vertices = corners.map(|[x, y, ..]| [x, y]);
        let Some(edges) = Edges::new(vertices, &self.image.settings(), &mut self.tally) else {
            return Err(Outcome::ZeroArea);
        };
        let mask = self.image.samples.mask(&edges, self.pixel, self.image.y_axis, &mut self.tally);
        if mask != 0 {
            return Ok(mask);
        }
        let Edges(edges) = edges;
        let sides = edges.map(|edge| edge.side(self.at, &mut self.tally));
        if let Some(edge) = sides.iter().position(|side| side.is_negative()) {
            let [a, b] = edges[edge].ends;
            return Err(Outcome::OutsideEdge { edge: edge as u8, value: edge_value(a, b, self.at).value });
        }
        let lost = (0..3).find(|&i| !edges[i].draws(sides[i]));
        let lost = lost.filter(|_| self.image.samples == Samples::One);
        Err(lost.map_or(Outcome::NoSample, |edge| Outcome::LostTie { edge: edge as u8 }))
    }

    /// The depth plane that cut off what the unclipped triangle would show here.
    ///
    /// In binary64, for the explanation only. *Source:* Olano and Greer 1997, section 3: edge functions
    /// of homogeneous vertices hold before clipping.
    fn cut_off(&self, clip: [Point; 3]) -> Option<Plane> {
        let [half_width, half_height] = self.viewport.size.map(|n| f64::from(n) / 2.0);
        let x = f64::from(self.at[0]) / half_width - 1.0;
        let up = f64::from(self.at[1]) / half_height - 1.0;
        let y = if self.viewport.y_axis == YAxis::Down { -up } else { up };
        let v = wide(clip);
        let minor = |j: usize, k: usize| {
            let ([ax, ay, _, aw], [bx, by, _, bw]) = (v[j], v[k]);
            (ay * bw - aw * by) * x + (aw * bx - ax * bw) * y + (ax * by - ay * bx)
        };
        let weights = [minor(1, 2), minor(2, 0), minor(0, 1)];
        let determinant = determinant(v);
        let seen = determinant != 0.0 && weights.iter().all(|weight| weight * determinant.signum() >= 0.0);
        if !seen {
            return None;
        }
        let sum = |axis: usize| -> f64 {
            weights.iter().zip(v).map(|(weight, point)| weight * determinant.signum() * point[axis]).sum()
        };
        let (z, w) = (sum(2), sum(3));
        let low = if self.viewport.depth_range == DepthRange::ZeroToOne { 0.0 } else { -w };
        if z < low {
            return Some(Plane::Near);
        }
        (z > w).then_some(Plane::Far)
    }
}

/// What became of a piece on the screen.
struct Seen {
    outcome: Outcome,
    /// Whether it was near the pixel.
    near: bool,
    samples: Vec<SampleEntry>,
    at: Option<[f32; 2]>,
    source: Option<[f32; 4]>,
}

fn wide(clip: [Point; 3]) -> [[f64; 4]; 3] {
    clip.map(|point| point.map(f64::from))
}

/// That of (x, y, w), in binary64; for the explanation only.
fn determinant([[ax, ay, _, aw], [bx, by, _, bw], [cx, cy, _, cw]]: [[f64; 4]; 3]) -> f64 {
    ax * (by * cw - bw * cy) + ay * (bw * cx - bx * cw) + aw * (bx * cy - by * cx)
}
