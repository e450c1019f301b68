//! Whole images by the engine: the same bytes and counts as fragment by fragment.
//!
//! Draws with the same tests are drawn together. The engine finds which piece is seen at a pixel, and that one alone
//! is coloured; where colours are blended, every fragment is that passes.

use super::{
    DrawOutputs, Frame, Skip, Stats,
    counts::Counts,
    fragments::{FragmentState, ImageState, Paint},
    frame::stored_depth,
    gradient::Gradient,
    shader::Shader,
};
use crate::{
    engine::{
        self, Canvas, Clear, Colors, DepthStore, Engine, Lanes, PaintOrder, Painter, Stencil, Threads,
        Triangles,
    },
    math::Tally,
    raster::Samples,
};

/// An image that is drawn as a whole, kept from image to image.
#[derive(Debug)]
pub(super) struct Whole {
    engine: Engine,
    /// Between images its buffers are those of the frame.
    canvas: Canvas,
    store: DepthStore,
    /// Between images the depths of the canvas, if they are codes.
    codes: Vec<f32>,
    clear: Clear,
    threads: Threads,
    /// Whether nothing was drawn yet.
    fresh: bool,
    /// The corners of all pieces that are drawn together, three each.
    soup: Vec<[f32; 3]>,
    places: Vec<Place>,
    gradients: Vec<Gradient>,
    stats: Stats,
}

/// Which piece of which draw.
#[derive(Clone, Copy, Debug)]
struct Place {
    draw: usize,
    piece: usize,
    paint: Paints,
}

/// What a piece is painted with.
#[derive(Clone, Copy, Debug)]
enum Paints {
    /// The codes of all its pixels.
    Constant([u8; 4]),
    /// Whole rows at once, as far as that is certain: one of the gradients.
    Gradient(u32),
    Shader,
}

impl Whole {
    /// Whether the engine has a way to draw such an image.
    pub(super) fn can_draw(state: &ImageState, draws: &[FragmentState]) -> bool {
        let plain = draws.iter().all(FragmentState::is_plain);
        plain && state.samples == Samples::One && DepthStore::of(state.format).is_some()
    }

    /// An image of clear values only, written to `frame`; `None` if the engine has no way to draw it.
    pub(super) fn new(state: &ImageState, frame: &mut Frame) -> Option<Self> {
        let store = DepthStore::of(state.format)?;
        let code = state.format.encode(state.clear.depth);
        let depth = match store {
            DepthStore::F32 => f32::from_bits(code),
            _ => code as f32,
        };
        let clear = Clear { color: state.clear_color(), depth, stencil: state.clear.stencil };
        let mut canvas = Canvas::new(state.size, clear, Stencil::With);
        *frame = Frame { size: state.size, ..Frame::default() };
        let mut codes = Vec::new();
        if store == DepthStore::F32 {
            canvas.swap(&mut frame.color, &mut frame.depth, &mut frame.stencil);
        } else {
            canvas.swap(&mut frame.color, &mut codes, &mut frame.stencil);
            frame.depth = vec![0.0; codes.len()];
            frame.depth_codes = Some(vec![0; codes.len()]);
        }
        let engine = Engine::default();
        let (soup, places, gradients, stats) = Default::default();
        Some(Self {
            engine,
            canvas,
            store,
            codes,
            clear,
            threads: Threads::available(),
            fresh: true,
            soup,
            places,
            gradients,
            stats,
        })
    }

    /// Whether it holds an image of the same size that is cleared to the same values.
    pub(super) fn fits(&self, state: &ImageState, frame: &Frame) -> bool {
        let clear = (self.clear.color, self.clear.stencil, self.store.format());
        let code = state.format.encode(state.clear.depth);
        let depth = if self.store == DepthStore::F32 { f32::from_bits(code) } else { code as f32 };
        frame.size == state.size
            && clear == (state.clear_color(), state.clear.stencil, state.format)
            && self.clear.depth.to_bits() == depth.to_bits()
    }

    fn swap(&mut self, frame: &mut Frame) {
        let depth = if self.store == DepthStore::F32 { &mut frame.depth } else { &mut self.codes };
        self.canvas.swap(&mut frame.color, depth, &mut frame.stencil);
    }

    /// Draws an image.
    pub(super) fn draw(
        &mut self,
        state: &ImageState,
        draws: &[DrawOutputs],
        states: &[FragmentState],
        frame: &mut Frame,
    ) {
        self.swap(frame);
        let mut counts = Counts::default();
        let mut sum = engine::Stats::default();
        let mut clear = Some(self.clear);
        let alike = |a: &FragmentState, b: &FragmentState| {
            (a.depth, a.stencil, a.blend) == (b.depth, b.stencil, b.blend)
        };
        let mut first = 0;
        for group in states.chunk_by(alike) {
            self.gather(first, (&draws[first..first + group.len()], group), state, &mut counts);
            first += group.len();
            if self.places.is_empty() {
                continue;
            }
            sum += self.draw_group(state, &group[0], (draws, states), clear.take());
        }
        if clear.is_some() {
            let nothing = Triangles { positions: &[], indices: None, colors: Colors::One([0; 4]) };
            let state = engine::State { skips: state.skips, ..engine::State::default() };
            sum += self.engine.draw(&mut self.canvas, clear, &nothing, &state);
        }
        self.swap(frame);
        self.copy_codes(state, frame);
        self.count(state, counts, &sum, states);
        self.fresh = false;
    }

    /// Takes the pieces that are drawn; counts those that are not.
    fn gather(
        &mut self,
        first: usize,
        (draws, states): (&[DrawOutputs], &[FragmentState]),
        image: &ImageState,
        counts: &mut Counts,
    ) {
        self.soup.clear();
        self.places.clear();
        self.gradients.clear();
        let lanes = Lanes::widest();
        for ((draw, outputs), state) in (first..).zip(draws).zip(states) {
            let (screen, pieces) = (outputs.screen(), &outputs.clipped().pieces);
            counts.pieces += pieces.len() as u64;
            self.soup.reserve(3 * pieces.len());
            self.places.reserve(pieces.len());
            for (index, piece) in pieces.iter().enumerate() {
                let [a, b, c] = piece.corners.map(|i| screen[i as usize]);
                if piece.carried {
                    counts.carry([a, b, c].map(|[x, y, ..]| [x, y]), image);
                    continue;
                }
                let place = |[x, y, z, _]: [f32; 4]| [x, y, z];
                self.soup.extend_from_slice(&[place(a), place(b), place(c)]);
                // All that a gradient needs is at hand now; when a pixel asks, it would be fetched from afar.
                let paint = match state.blend {
                    Some(_) => Paints::Shader,
                    None => match Shader::constant_of(outputs, piece, state.texture, &mut counts.tally) {
                        Some(codes) => Paints::Constant(codes),
                        None => match Shader::gradient_of(outputs, piece, state.texture, lanes) {
                            Some(gradient) => {
                                self.gradients.push(gradient);
                                Paints::Gradient(self.gradients.len() as u32 - 1)
                            }
                            None => Paints::Shader,
                        },
                    },
                };
                self.places.push(Place { draw, piece: index, paint });
            }
        }
    }

    fn draw_group(
        &mut self,
        image: &ImageState,
        group: &FragmentState,
        (draws, states): (&[DrawOutputs], &[FragmentState]),
        clear: Option<Clear>,
    ) -> engine::Stats {
        let order = match (image.skips.has(Skip::EarlyZ), group.blend) {
            (false, _) => PaintOrder::EachCovered,
            (true, None) if image.skips.has(Skip::Deferred) => PaintOrder::Last,
            (true, _) => PaintOrder::EachPassing,
        };
        let state = engine::State {
            depth: group.depth,
            store: self.store,
            stencil: group.stencil,
            fill_rule: image.fill_rule,
            y_axis: image.y_axis,
            skips: image.skips,
            threads: self.threads,
            ..engine::State::default()
        };
        let triangles = Triangles { positions: &self.soup, indices: None, colors: Colors::One([0; 4]) };
        let (places, gradients) = (&self.places, &self.gradients);
        let palette = Palette { draws, states, places, gradients, order, lanes: state.lanes };
        self.engine.paint(&mut self.canvas, clear, &triangles, &state, &palette)
    }

    /// The frame's depths, if the canvas has codes.
    fn copy_codes(&self, state: &ImageState, frame: &mut Frame) {
        let Some(copy) = &mut frame.depth_codes else { return };
        for ((depth, copy), code) in frame.depth.iter_mut().zip(copy).zip(&self.codes) {
            *copy = *code as u32;
            *depth = stored_depth(state.format, *copy);
        }
    }

    fn count(
        &mut self,
        state: &ImageState,
        mut counts: Counts,
        sum: &engine::Stats,
        states: &[FragmentState],
    ) {
        counts.spans += sum.spans;
        counts.fragments += sum.fragments;
        counts.stencil_failed = sum.stencil_failed;
        counts.failed = sum.fragments - sum.passed;
        counts.redrawn = sum.passed - sum.pixels;
        let early = state.skips.has(Skip::EarlyZ);
        counts.never_colored = if early { counts.failed } else { 0 };
        counts.tally += sum.tally;
        counts.tally.calls += sum.triangles + sum.fragments;
        counts.tally.exact += sum.exact_turns + sum.exact_signs + sum.exact_depths;
        let mut stats = Stats::default();
        counts.add_to(&mut stats, states.iter());
        stats.skip(Skip::Tile, sum.beside);
        stats.skip(Skip::HierarchicalZ, sum.behind + sum.hidden);
        stats.skip(Skip::Deferred, if early { sum.passed - sum.painted } else { 0 });
        stats.skip(Skip::Clear, if self.fresh { 0 } else { sum.clean_pixels });
        self.stats = stats;
    }

    /// What the last image counted, from scan conversion on.
    pub(super) fn stats(&self) -> &Stats {
        &self.stats
    }
}

/// The colours of pieces that are drawn together.
struct Palette<'w> {
    draws: &'w [DrawOutputs],
    states: &'w [FragmentState],
    places: &'w [Place],
    gradients: &'w [Gradient],
    order: PaintOrder,
    lanes: Lanes,
}

/// The colour of one piece.
enum Brush<'w> {
    Constant([u8; 4]),
    Gradient(&'w Gradient, Place),
    Shader(Box<Shader>, &'w FragmentState),
}

impl Palette<'_> {
    fn shader(&self, place: Place, tally: &mut Tally) -> Option<Shader> {
        let outputs = &self.draws[place.draw];
        let piece = &outputs.clipped().pieces[place.piece];
        Shader::new(outputs, piece, self.states[place.draw].texture, tally)
    }
}

impl<'w> Painter for Palette<'w> {
    type Brush = Brush<'w>;

    fn brush(&self, triangle: u32, tally: &mut Tally) -> Brush<'w> {
        let place = self.places[triangle as usize];
        match place.paint {
            Paints::Constant(codes) => return Brush::Constant(codes),
            Paints::Gradient(index) => {
                // The sign of its area.
                tally.calls += 1;
                return Brush::Gradient(&self.gradients[index as usize], place);
            }
            Paints::Shader => {}
        }
        let state = &self.states[place.draw];
        // What covers a pixel has an area.
        let Some(shader) = self.shader(place, tally) else { return Brush::Constant([0; 4]) };
        Brush::Shader(Box::new(shader), state)
    }

    fn paint(&self, brush: &mut Brush<'w>, [x, y]: [u32; 2], colors: &mut [[u8; 4]], tally: &mut Tally) {
        let mut each = |shader: &Shader, state: &FragmentState, i: usize, color: &mut [u8; 4]| {
            *color = Paint::new(shader, state, [x + i as u32, y], tally).over(*color, state, tally);
        };
        match brush {
            Brush::Constant(codes) => colors.fill(*codes),
            Brush::Shader(shader, state) => {
                colors.iter_mut().enumerate().for_each(|(i, color)| each(shader, state, i, color));
            }
            Brush::Gradient(gradient, place) => {
                let mut uncertain = gradient.row(self.lanes, [x, y], colors);
                while uncertain != 0 {
                    let i = uncertain.trailing_zeros() as usize;
                    uncertain &= uncertain - 1;
                    if let (Some(shader), Some(color)) =
                        (self.shader(*place, &mut Tally::default()), colors.get_mut(i))
                    {
                        each(&shader, &self.states[place.draw], i, color);
                    }
                }
            }
        }
    }

    fn order(&self) -> PaintOrder {
        self.order
    }
}
