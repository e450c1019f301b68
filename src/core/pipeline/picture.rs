//! From a scene to its image at once: the same bytes as the whole pipeline's, but no stage's output is kept and nothing
//! is counted.
//!
//! Vertices go through all matrices to the screen one after another; what lies inside all planes is never clipped; the
//! engine leaves out what faces away as it sorts triangles into tiles, and colours each fragment as it draws it. What
//! an error leaves open is asked of the exact stages. Scenes whose draws test, blend or light in another way go
//! through the whole pipeline.
//!
//! *Source:* as of the stages, in the order of [`pipeline`](super).

use super::{
    Frame, Pipeline, Rasterizer, Skips,
    fragments::{FragmentState, ImageState},
    lit::{Lit, Varyings},
    stages::{Clipped, CullKey, Point},
};
use crate::{
    cull::{CullMode, FrontFace, facing},
    depth::{CompareFunction, DepthFormat, DepthState},
    engine::{
        self, Arbiter, Canvas, Clear, Colors, Engine, Lanes, Mesh, Stencil, Threads, Triangles, Vertex,
    },
    interpolate::{Interpolator, unorm},
    math::Tally,
    raster::{Samples, YAxis, edge::centre},
    scene::{self, Draw, Scene, Shade},
    transform::{Chain, apply, divide},
};
use std::sync::Arc;

/// Draws images of scenes, with the memory it keeps from one to the next.
#[derive(Debug, Default)]
pub struct Picture {
    /// Between images the canvas' buffers are those of the frame.
    canvas: Option<(Canvas, Clear)>,
    frame: Frame,
    engine: Engine,
    seen: Seen,
    /// For other scenes.
    pipeline: Pipeline,
    /// Whether the last one was such a scene.
    by_stages: bool,
    /// How many threads draw.
    threads: Threads,
}

/// What is seen of one draw.
#[derive(Debug, Default)]
struct Seen {
    /// What the colours of the vertices are of, and where they lie.
    mesh: Arc<scene::Mesh>,
    range: engine::Range,
    /// The vertices, then those of what was clipped.
    screen: Vec<Vertex>,
    /// Which planes each vertex lies outside of.
    outcodes: Vec<u8>,
    /// What is left of triangles if some were clipped: indices, and of which triangle; none of a part.
    triangles: Vec<[u32; 3]>,
    whole: Vec<Option<u32>>,
}

/// A vertex in clip space, step by step as in the pipeline.
#[inline(always)]
fn clip_space(chain: &Chain, [x, y, z]: [f32; 3]) -> Point {
    apply(&chain.projection, apply(&chain.view, apply(&chain.model, [x, y, z, 1.0])))
}

impl Picture {
    /// Draws a resolved scene; a model that is not loaded draws nothing.
    pub fn draw(&mut self, scene: &Scene) -> &Frame {
        let state = ImageState::new(scene, Rasterizer::default(), Skips::ALL);
        self.by_stages = !can_draw(scene, &state);
        if self.by_stages {
            self.pipeline.update(scene, &Skips::ALL);
            return self.frame();
        }
        let mut canvas = self.canvas(&state);
        let mut clear = Some(clear_of(&state));
        let engine_state = engine::State {
            fill_rule: state.fill_rule,
            y_axis: state.y_axis,
            threads: self.threads,
            ..engine::State::default()
        };
        for draw in &scene.draws {
            if let Some(mesh) = draw.geometry.mesh() {
                self.draw_mesh(&mut canvas, &mut clear, (scene, draw, mesh), &engine_state);
            }
        }
        if clear.is_some() {
            let nothing = Triangles { positions: &[], indices: None, colors: Colors::One([0; 4]) };
            self.engine.draw(&mut canvas, clear, &nothing, &engine_state);
        }
        let Frame { color, depth, .. } = &mut self.frame;
        canvas.swap(color, depth, &mut Vec::new());
        self.canvas = Some((canvas, clear_of(&state)));
        self.frame()
    }

    /// The last image; what the stages counted is known only where it went through the whole pipeline.
    pub fn frame(&self) -> &Frame {
        if self.by_stages { &self.pipeline.outputs().frame } else { &self.frame }
    }

    /// How many threads draw; one unless told.
    pub fn set_threads(&mut self, threads: Threads) {
        self.threads = threads;
    }

    /// The canvas of the last image with its buffers, or a new one.
    fn canvas(&mut self, state: &ImageState) -> Canvas {
        let clear = clear_of(state);
        let Frame { color, depth, .. } = &mut self.frame;
        match self.canvas.take() {
            Some((mut canvas, last)) if canvas.size() == state.size && last == clear => {
                canvas.swap(color, depth, &mut Vec::new());
                canvas
            }
            _ => {
                let pixels = state.size[0] as usize * state.size[1] as usize;
                let stencil = vec![state.clear.stencil; pixels];
                self.frame = Frame { size: state.size, stencil, ..Frame::default() };
                Canvas::new(state.size, clear, Stencil::Without)
            }
        }
    }

    fn draw_mesh(
        &mut self,
        canvas: &mut Canvas,
        clear: &mut Option<Clear>,
        (scene, draw, mesh): (&Scene, &Draw, &Arc<scene::Mesh>),
        state: &engine::State,
    ) {
        let chain = Chain::of(scene, draw);
        let key = CullKey::new(draw, scene.depth_range, Skips::ALL);
        let seen = &mut self.seen;
        seen.transform(mesh, &chain, &key);
        let is_clipped = seen.outcodes.iter().any(|&outcode| outcode != 0);
        if is_clipped {
            seen.clip(mesh, &chain, &key);
        }
        let triangles = if is_clipped { &seen.triangles } else { &mesh.triangles };
        let stages = Stages { seen, mesh, triangles, is_clipped, chain, key };
        let front = if draw.front == FrontFace::Ccw { 1.0 } else { -1.0 };
        let up = if scene.y_axis == YAxis::Up { front } else { -front };
        let mesh = Mesh {
            vertices: &seen.screen,
            triangles,
            turn: match draw.cull {
                CullMode::None => None,
                CullMode::Back => Some(up),
                CullMode::Front => Some(-up),
            },
            blur: 2.0 * f32::EPSILON * scene.size[0].max(scene.size[1]) as f32,
            range: seen.range,
            arbiter: &stages,
        };
        self.engine.draw_mesh(canvas, clear.take(), &mesh, state);
    }
}

/// Whether the engine draws all of a scene.
fn can_draw(scene: &Scene, state: &ImageState) -> bool {
    let nearer = |depth: DepthState| depth.test && depth.write && depth.compare == CompareFunction::Less;
    let plain = |draw: &Draw| {
        let FragmentState { depth, stencil, blend, texture, .. } = FragmentState::new(draw);
        FragmentState::new(draw).is_plain()
            && nearer(depth)
            && stencil.is_none()
            && blend.is_none()
            && texture.is_none()
            && draw.shade == Shade::None
    };
    state.format == DepthFormat::F32 && state.samples == Samples::One && scene.draws.iter().all(plain)
}

fn clear_of(state: &ImageState) -> Clear {
    let depth = f32::from_bits(state.format.encode(state.clear.depth));
    Clear { color: state.clear_color(), depth, stencil: state.clear.stencil }
}

impl Seen {
    /// All vertices to the screen.
    fn transform(&mut self, mesh: &Arc<scene::Mesh>, chain: &Chain, key: &CullKey) {
        self.screen.resize(mesh.positions.len(), Vertex::default());
        self.outcodes.resize(mesh.positions.len(), 0);
        if !Arc::ptr_eq(mesh, &self.mesh) {
            self.mesh = Arc::clone(mesh);
            self.range = engine::Range::of(&mesh.colors);
            let colors = self.screen.iter_mut().zip(&mesh.colors);
            colors.for_each(|(vertex, color)| vertex.color = *color);
        }
        Lanes::widest().run(
            #[inline(always)]
            || {
                let out = self.screen.iter_mut().zip(&mut self.outcodes);
                for ((screen, outcode), position) in out.zip(&mesh.positions) {
                    let clip = clip_space(chain, *position);
                    *outcode = key.visible.outcode(clip);
                    screen.place = chain.viewport.to_screen(divide(clip));
                }
            },
        );
    }

    /// What is left of all triangles, in order.
    fn clip(&mut self, mesh: &scene::Mesh, chain: &Chain, key: &CullKey) {
        let Self { screen, outcodes, triangles, whole, .. } = self;
        triangles.clear();
        whole.clear();
        let (lit, tally) = (Lit::default(), &mut Tally::default());
        let varyings = Varyings::new(mesh, &lit);
        let clip: Vec<_> = mesh.positions.iter().map(|position| clip_space(chain, *position)).collect();
        for (index, triangle) in (0..).zip(&mesh.triangles) {
            let [a, b, c] = triangle.map(|i| outcodes[i as usize]);
            if a | b | c == 0 {
                triangles.push(*triangle);
                whole.push(Some(index));
                continue;
            }
            let corners = triangle.map(|i| clip[i as usize]);
            if a & b & c != 0 || key.mode.drops(facing(corners, key.front, tally)) {
                continue;
            }
            let mut left = Clipped::default();
            left.push(index, false, &clip, &varyings, key.visible);
            let first = screen.len() as u32;
            screen.extend(left.corners.iter().zip(&left.colors).map(|(corner, color)| Vertex {
                place: chain.viewport.to_screen(divide(*corner)),
                color: *color,
            }));
            triangles.extend(left.pieces.iter().map(|piece| piece.corners.map(|corner| first + corner)));
            whole.extend(left.pieces.iter().map(|_| None));
        }
    }
}

/// The exact stages, for what is asked of them.
struct Stages<'a> {
    seen: &'a Seen,
    mesh: &'a scene::Mesh,
    triangles: &'a [[u32; 3]],
    is_clipped: bool,
    chain: Chain,
    key: CullKey,
}

impl Arbiter for Stages<'_> {
    fn faces(&self, triangle: u32) -> bool {
        let triangle = if self.is_clipped { self.seen.whole[triangle as usize] } else { Some(triangle) };
        // What was clipped faced the eye.
        let Some(triangle) = triangle else { return true };
        let vertices = self.mesh.triangles[triangle as usize].map(|i| self.mesh.positions[i as usize]);
        let clip = vertices.map(|vertex| clip_space(&self.chain, vertex));
        !self.key.mode.drops(facing(clip, self.key.front, &mut Tally::default()))
    }

    fn color(&self, triangle: u32, [x, y]: [u32; 2]) -> [u8; 4] {
        let corners = self.triangles[triangle as usize].map(|i| self.seen.screen[i as usize]);
        let tally = &mut Tally::default();
        let vertices = corners.map(|Vertex { place: [x, y, _, r], .. }| [x, y, r]);
        // What covers a pixel has an area.
        let Some(interpolator) = Interpolator::new(vertices, tally) else { return [0; 4] };
        let weights = interpolator.at_point(centre(x, y), tally);
        [0, 1, 2, 3].map(|channel| {
            let [a, b, c] = corners.map(|corner| corner.color[channel]);
            if a == b && b == c { unorm(a, 255) as u8 } else { weights.code8([a, b, c], tally) }
        })
    }
}
