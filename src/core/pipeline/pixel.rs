//! Why a pixel looks as it does: every triangle that could have touched it, in order, with what
//! became of it there.
//!
//! Computed for one pixel on demand; the image's own run keeps nothing for it. The outcomes do not
//! depend on the skips.

use super::{
    DrawOutputs, Outputs, Piece, Skips,
    evaluate::Pipeline,
    fragments::{FragmentState, ImageState, Paint},
    names::triangle_name,
    outcome::{Later, Outcome, PixelEntry, PixelHistory, Placed},
    shader::Shader,
    stages::{Clipped, Point},
    visible::Visible,
};
use crate::{
    clip::polygon::Plane,
    cull::facing,
    depth::{DepthBuffer, DepthPlane},
    math::{Arithmetic, Tally, edge_value},
    raster::{
        Settings, YAxis,
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
    let state = ImageState::new(scene, Default::default(), Skips::NONE);
    let depth = DepthBuffer::new([1, 1], scene.depth_format, scene.clear.depth);
    let clear_color = state.clear_color();
    let mut probe = Probe {
        pixel,
        at: centre(pixel[0], pixel[1]),
        settings: state.settings(),
        viewport: outputs.viewport,
        list_all: outputs.draws.iter().map(|draw| draw.mesh().triangles.len()).sum::<usize>() <= LIST_ALL,
        color: clear_color,
        stencil: scene.clear.stencil,
        depth,
        entries: Vec::new(),
        tally: Tally::default(),
    };
    let clear_depth = probe.depth.code([0, 0]);
    for (index, (draw, stages)) in scene.draws.iter().zip(&outputs.draws).enumerate() {
        probe.draw(index, draw, stages);
    }
    let Probe { color, stencil, depth, mut entries, .. } = probe;
    let mut fate = Later::Shown;
    for entry in entries.iter_mut().rev() {
        if let Outcome::Written { later, .. } = &mut entry.outcome {
            *later = fate;
            let blends = scene.draws[entry.draw].blend.is_some();
            fate = if blends && fate != Later::Overwritten { Later::BlendedOver } else { Later::Overwritten };
        }
    }
    PixelHistory { pixel, clear_color, clear_depth, entries, color, depth: depth.code([0, 0]), stencil }
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
    at: [f32; 2],
    settings: Settings,
    viewport: Viewport,
    list_all: bool,
    color: [u8; 4],
    stencil: u8,
    depth: DepthBuffer,
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
                    placed: None,
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
                placed: None,
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
                            let Seen { outcome, placed, source, .. } = seen;
                            self.entries.push(PixelEntry { placed, source, ..entry(part, outcome) });
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
        let would_cover = pieces.iter().any(|corners| self.miss(corners).is_none());
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
        let unseen = |outcome, near| Seen { outcome, near, placed: None, source: None };
        if let Some(miss) = self.miss(&corners) {
            let cut_off = self.cut_off(clip).filter(|plane| visible.clips_at(*plane));
            return unseen(cut_off.map_or(miss, Outcome::CutOff), near || cut_off.is_some());
        }
        let Some(shader) = Shader::new(stages, piece, state.texture, &mut self.tally) else {
            return unseen(Outcome::ZeroArea, near);
        };
        if let Some(outcome) = self.cut(&shader, state) {
            return unseen(outcome, near);
        }
        let format = self.depth.format();
        let bare = DepthPlane::new(corners.map(|[x, y, z, _]| [x, y, z]), Arithmetic::Exact, &mut self.tally);
        let plane = bare.placed(&state.placement, format);
        let placed = (!state.placement.is_plain())
            .then(|| Placed { plane: bare.depth(self.pixel, &mut self.tally).into(), bias: plane.bias() });
        let new = plane.code(self.pixel, format, &mut self.tally);
        let (stored, stencil) = (self.depth.code([0, 0]), self.stencil);
        let depth = &mut self.depth;
        let tested = state.test(&mut self.stencil, || depth.test(state.depth, [0, 0], new));
        let stencil = [stencil, self.stencil];
        let outcome = match tested {
            StencilOutcome::Fail => Outcome::Stencil { stored: stencil },
            StencilOutcome::DepthFail => Outcome::Depth { new, stored, stencil },
            StencilOutcome::Pass => {
                let paint = Paint::new(&shader, state, self.pixel, &mut self.tally);
                let before = self.color;
                self.color = paint.over(before, state, &mut self.tally);
                let depth = state.depth.test.then_some(new);
                Outcome::Written { depth, stored, color: [before, self.color], stencil, later: Later::Shown }
            }
        };
        let written = tested == StencilOutcome::Pass;
        let source = written.then(|| shader.at(self.at, &mut self.tally).values(&mut self.tally));
        Seen { outcome, near, placed, source }
    }

    /// What keeps a covered pixel from the tests.
    fn cut(&mut self, shader: &Shader, state: &FragmentState) -> Option<Outcome> {
        if state.is_plain() {
            return None;
        }
        if let Some(scissor) = state.scissor.filter(|scissor| !scissor.holds(self.pixel)) {
            return Some(Outcome::Scissored(scissor));
        }
        let color = shader.at(self.at, &mut self.tally);
        let kept = color.is_kept(state.alpha_test, &mut self.tally);
        (!kept).then(|| Outcome::Discarded { alpha: color.values(&mut self.tally)[3] })
    }

    /// Whether the box around a piece holds the pixel's centre.
    fn is_near(&self, corners: &[Point; 3]) -> bool {
        [0, 1].into_iter().all(|axis| {
            let low = corners.iter().map(|corner| corner[axis]).fold(f32::INFINITY, f32::min);
            let high = corners.iter().map(|corner| corner[axis]).fold(f32::NEG_INFINITY, f32::max);
            (low..=high).contains(&self.at[axis])
        })
    }

    /// Why a piece does not cover the pixel's centre; `None` if it does.
    fn miss(&mut self, corners: &[Point; 3]) -> Option<Outcome> {
        let vertices = corners.map(|[x, y, ..]| [x, y]);
        let Some(Edges(edges)) = Edges::new(vertices, &self.settings, &mut self.tally) else {
            return Some(Outcome::ZeroArea);
        };
        let sides = edges.map(|edge| edge.side(self.at, &mut self.tally));
        if let Some(edge) = sides.iter().position(|side| side.is_negative()) {
            let [a, b] = edges[edge].ends;
            return Some(Outcome::OutsideEdge { edge: edge as u8, value: edge_value(a, b, self.at).value });
        }
        let lost = (0..3).find(|&i| !edges[i].draws(sides[i]))?;
        Some(Outcome::LostTie { edge: lost as u8 })
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
    placed: Option<Placed>,
    source: Option<[f32; 4]>,
}

fn wide(clip: [Point; 3]) -> [[f64; 4]; 3] {
    clip.map(|point| point.map(f64::from))
}

/// That of (x, y, w), in binary64; for the explanation only.
fn determinant([[ax, ay, _, aw], [bx, by, _, bw], [cx, cy, _, cw]]: [[f64; 4]; 3]) -> f64 {
    ax * (by * cw - bw * cy) + ay * (bw * cx - bx * cw) + aw * (bx * cy - by * cx)
}
