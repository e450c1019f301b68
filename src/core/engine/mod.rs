//! Whole frames, fast: one more rasterizer under the contracts of [`raster`](crate::raster) and
//! [`depth`](crate::depth), for many triangles at once and not to be stepped.
//!
//! Contract: every pixel holds what drawing the triangles one by one, in order, with any rasterizer of
//! [`raster`](crate::raster), [`DepthPlane`] and [`DepthState`] leaves there, bit for bit: exact coverage of
//! the given vertices, depths rounded once. The same bytes with every skip on and off and on every vector unit.
//!
//! How: the image is cut into tiles whose colours and depths fit the first-level cache ([`Canvas`]). Triangles, or those
//! of a mesh that are seen from the right side (`source`), are first sorted into the tiles that their boxes meet
//! (`bins`); then each tile is drawn for itself, from its clear values if it is to be cleared, and written out once
//! (`tile`); where much is hidden, front to back (`foremost`). A few triangles are set up at once (`setup`). From then on
//! it goes by stamps of 4 x 4 pixels (`stamp`). Those that a small triangle may meet are held against its edges (`small`, `noted`);
//! of other triangles a few rows are found at once (`sides`, `rows`). The depths of a stamp's pixels are found (`depths`),
//! tested (`pixels`) and, in a mesh, coloured (`smooth`) at once, each one a lane of the vector unit (`lanes`). What is
//! computed is an interval around the exact number. Nearly always both its ends give the same answer, the same binary32
//! depth or the same code, which is the exact one's then; else the exact predicates decide, and that is counted.
//!
//! Space: screen; x and y in pixels, centres at + 0.5, rows counted along the y axis; depth as given. Any finite
//! numbers; a triangle with another one is not drawn, nor one of zero area. Off the image nothing is drawn.
//! Stored depths are numbers.
//!
//! Cost: about 0.05 us a small triangle, 0.5 ns a drawn pixel of a large one; less where others hide it.
//!
//! *Source:* Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; Greene, Kass, Miller,
//! Hierarchical Z-Buffer Visibility, SIGGRAPH 1993; Abrash, Rasterization on Larrabee, 2009 (tiles, lanes);
//! Giesen, Optimizing Software Occlusion Culling, 2013. Deviation: no vertex is snapped; edge functions are not
//! stepped from stamp to stamp but computed anew, with an error, and rows of large triangles are found by intervals.

mod bins;
mod canvas;
mod depths;
mod fill;
mod foremost;
mod group;
mod ink;
mod lanes;
mod noted;
mod paint;
mod pixels;
mod rows;
mod setup;
mod sides;
mod small;
mod smooth;
mod source;
mod stamp;
mod state;
mod stats;
mod test;
mod threads;
mod tile;
mod way;

pub use canvas::{Canvas, Clear, Stencil};
pub use lanes::Lanes;
pub(crate) use lanes::{greatest, least};
pub use paint::{PaintOrder, Painter};
pub(crate) use source::{Arbiter, Mesh, Range, Vertex};
pub use state::{DepthStore, State};
pub use stats::Stats;
pub use threads::Threads;

use crate::pipeline::Skip;
use bins::Bins;
use canvas::{Strip, TILE};
use fill::Job;
use source::Source;
use state::Rules;
use tile::Tile;
use way::{Meshed, Painted, Plain, Way};

#[cfg(doc)]
use crate::depth::{DepthPlane, DepthState};

/// What is drawn by one call.
#[derive(Clone, Copy, Debug)]
pub struct Triangles<'a> {
    /// Vertices: x and y in pixels, depth.
    pub positions: &'a [[f32; 3]],
    /// Three indices into `positions` for each triangle; without them, three vertices after another make one.
    /// Where an index is too great, the triangle is not drawn.
    pub indices: Option<&'a [[u32; 3]]>,
    /// Their colours.
    pub colors: Colors<'a>,
}

/// Colours of triangles: red, green, blue, alpha codes.
#[derive(Clone, Copy, Debug)]
pub enum Colors<'a> {
    /// All have this one.
    One([u8; 4]),
    /// Each has its own; those beyond the last colour are not drawn.
    Each(&'a [[u8; 4]]),
}

impl Triangles<'_> {
    /// How many there are.
    pub fn len(&self) -> usize {
        let triangles = self.indices.map_or(self.positions.len() / 3, <[_]>::len);
        match self.colors {
            Colors::One(_) => triangles,
            Colors::Each(colors) => triangles.min(colors.len()),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    #[inline(always)]
    fn color(&self, triangle: usize) -> u32 {
        u32::from_ne_bytes(match self.colors {
            Colors::One(color) => color,
            Colors::Each(colors) => colors.get(triangle).copied().unwrap_or_default(),
        })
    }
}

/// The rasterizer, with the memory it keeps from call to call.
#[derive(Debug, Default)]
pub struct Engine {
    bins: Bins,
    /// One for each thread that was needed so far.
    tiles: Vec<Tile>,
}

impl Engine {
    /// Draws triangles over what the canvas holds, or over clear values.
    pub fn draw(
        &mut self,
        canvas: &mut Canvas,
        clear: Option<Clear>,
        triangles: &Triangles<'_>,
        state: &State,
    ) -> Stats {
        self.frame(canvas, clear, triangles, state, &Plain)
    }

    /// Draws triangles whose colours a painter gives; theirs do not matter. Fragments are counted.
    pub fn paint<P: Painter>(
        &mut self,
        canvas: &mut Canvas,
        clear: Option<Clear>,
        triangles: &Triangles<'_>,
        state: &State,
        painter: &P,
    ) -> Stats {
        self.frame(canvas, clear, triangles, state, &Painted(painter))
    }

    /// Draws a mesh with a colour at each vertex. The state must be one in which nothing can happen to a pixel but that
    /// a lesser depth takes it over; else nothing is drawn.
    pub(crate) fn draw_mesh<A: Arbiter>(
        &mut self,
        canvas: &mut Canvas,
        clear: Option<Clear>,
        mesh: &Mesh<'_, A>,
        state: &State,
    ) -> Stats {
        self.frame(canvas, clear, mesh, state, &Meshed(mesh))
    }

    fn frame<W: Way>(
        &mut self,
        canvas: &mut Canvas,
        clear: Option<Clear>,
        triangles: &impl Source,
        state: &State,
        way: &W,
    ) -> Stats {
        let mut stats = Stats { triangles: triangles.count() as u64, ..Stats::default() };
        let size = canvas.size;
        let mut rules = Rules::new(state, size, W::COUNTS);
        let Self { bins, tiles } = self;
        bins.reset(size);
        state.lanes.run(
            #[inline(always)]
            || bins.fill(triangles, size, &rules, &mut stats),
        );
        rules.sorts = rules.hierarchical_z && !rules.counts && bins.are_deep(size);
        if let Some(clear) = &clear {
            canvas.expect(clear);
        }
        let frame = FrameJob { bins, clear, state, rules: &rules };
        let strips = canvas.strips();
        let threads = state.threads.worth(strips.len(), triangles.count());
        if tiles.len() < threads {
            tiles.resize_with(threads, Tile::default);
        }
        stats += threads::share(strips, &mut tiles[..threads], |strips, tile| {
            let (mut kit, mut stats) = (way.kit(), Stats::default());
            strips.for_each(|mut strip| frame.strip::<W>(&mut strip, tile, &mut kit, &mut stats));
            stats
        });
        stats
    }
}

/// What all tiles of a frame share.
struct FrameJob<'f> {
    bins: &'f Bins,
    clear: Option<Clear>,
    state: &'f State,
    rules: &'f Rules,
}

impl FrameJob<'_> {
    /// Draws a row of tiles.
    fn strip<W: Way>(&self, strip: &mut Strip<'_>, tile: &mut Tile, kit: &mut W::Kit<'_>, stats: &mut Stats) {
        let Self { bins, clear, state, rules } = *self;
        let keep = state.skips.has(Skip::Clear);
        let columns = strip.clean.len();
        let unasked = strip.stencil.is_empty() && state.stencil.is_none();
        let stencil = if unasked { Stencil::Without } else { Stencil::With };
        for index in 0..columns {
            let list = bins.list(strip.top as usize / TILE * columns + index);
            let left = (index * TILE) as u32;
            if clear.is_some() {
                strip.painted[index] = [0; TILE];
            }
            if list.is_empty() {
                if let Some(clear) = &clear {
                    if strip.clean[index] && keep {
                        stats.clean += 1;
                        stats.clean_pixels += strip.pixels(left);
                    } else {
                        tile.clear(clear, stencil);
                        tile.fill_colors(clear.color);
                        tile.store(strip, left);
                    }
                    strip.clean[index] = true;
                }
                continue;
            }
            stats.binned += list.len() as u64;
            match &clear {
                Some(clear) => tile.clear(clear, stencil),
                None => tile.load(strip, left),
            }
            let job = Job { origin: [left, strip.top], state, rules };
            W::draw(kit, tile, clear.map(|clear| clear.color), job, list, stats);
            W::store(kit, tile, strip, (index, left), clear.as_ref(), stats);
            strip.clean[index] = false;
        }
    }
}
