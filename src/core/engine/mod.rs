//! Whole frames, fast: one more rasterizer under the contracts of [`raster`](crate::raster) and
//! [`depth`](crate::depth), for many triangles at once and not to be stepped.
//!
//! Contract: every pixel holds what drawing the triangles one by one, in order, with any rasterizer of
//! [`raster`](crate::raster), [`DepthPlane`] and [`DepthState`] leaves there, bit for bit: exact coverage of
//! the given vertices, depths rounded once. The same bytes with every skip on and off and on every vector unit.
//!
//! How: the image is cut into tiles whose colours and depths fit the first-level cache ([`Canvas`]). Triangles are
//! first sorted into the tiles that their boxes meet (`bins`); then each tile is drawn for itself, from its clear
//! values if it is to be cleared, and written out once (`tile`). A few triangles are set up at once (`setup`), a
//! few rows of a triangle are found at once (`rows`), a few pixels are tested at once (`tile`), each time one a
//! lane of the vector unit (`lanes`). What is computed is an interval around the exact number. Nearly always both
//! its ends give the same column or the same binary32 depth, which is the exact one's then; else the exact
//! predicates decide, and that is counted.
//!
//! Space: screen; x and y in pixels, centres at + 0.5, rows counted along the y axis; depth as given. Any finite
//! numbers; a triangle with another one is not drawn, nor one of zero area. Off the image nothing is drawn.
//! Stored depths are numbers.
//!
//! Cost: about 0.1 us a small triangle, 0.5 ns a drawn pixel of a large one; less where others hide it.
//!
//! *Source:* Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; Greene, Kass, Miller,
//! Hierarchical Z-Buffer Visibility, SIGGRAPH 1993; Abrash, Rasterization on Larrabee, 2009 (tiles, lanes);
//! Giesen, Optimizing Software Occlusion Culling, 2013. Deviation: no vertex is snapped; rows are found by
//! intervals instead of stepping edge functions.

mod bins;
mod canvas;
mod fill;
mod lanes;
mod rows;
mod setup;
mod test;
mod tile;

pub use canvas::{Canvas, Clear, Stencil};
pub use lanes::Lanes;

use crate::{
    depth::{CompareFunction, DepthState},
    pipeline::{Skip, Skips},
    raster::{self, FillRule, YAxis},
    stencil::StencilState,
};
use bins::{Bins, NOWHERE};
use canvas::TILE;
use fill::Job;
use tile::Tile;

#[cfg(doc)]
use crate::depth::DepthPlane;

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

    /// The vertices of one; not a number if an index is too great.
    #[inline(always)]
    fn corners(&self, triangle: usize) -> [[f32; 3]; 3] {
        match self.indices {
            None => self.positions.as_chunks().0.get(triangle).copied().unwrap_or(NOWHERE),
            Some(indices) => match indices.get(triangle) {
                Some(&[a, b, c]) => [self.vertex(a), self.vertex(b), self.vertex(c)],
                None => NOWHERE,
            },
        }
    }

    #[inline(always)]
    fn vertex(&self, index: u32) -> [f32; 3] {
        self.positions.get(index as usize).copied().unwrap_or(NOWHERE[0])
    }

    #[inline(always)]
    fn color(&self, triangle: usize) -> u32 {
        u32::from_ne_bytes(match self.colors {
            Colors::One(color) => color,
            Colors::Each(colors) => colors.get(triangle).copied().unwrap_or_default(),
        })
    }
}

/// How it is drawn.
#[derive(Clone, Copy, Debug)]
pub struct State {
    /// The depth test.
    pub depth: DepthState,
    /// The stencil test, for canvases with stencil values.
    pub stencil: Option<StencilState>,
    /// Who draws a centre on an edge.
    pub fill_rule: FillRule,
    /// Which way the vertices' y and the rows grow.
    pub y_axis: YAxis,
    /// What is left out: `tile`, `hierarchical-z` and `clear` are looked at.
    pub skips: Skips,
    /// The vector unit.
    pub lanes: Lanes,
}

impl Default for State {
    /// Nearer ones win, top-left, y down, every skip, the widest unit.
    fn default() -> Self {
        Self {
            depth: DepthState::default(),
            stencil: None,
            fill_rule: FillRule::default(),
            y_axis: YAxis::default(),
            skips: Skips::ALL,
            lanes: Lanes::widest(),
        }
    }
}

impl State {
    /// Whether nothing can happen to a pixel but that a lesser depth takes it over.
    fn lowers_depths(&self) -> bool {
        let DepthState { test, compare, write } = self.depth;
        test && write && compare == CompareFunction::Less && self.stencil.is_none()
    }
}

/// What one call did and left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    /// Triangles asked for.
    pub triangles: u64,
    /// Those with no pixel's centre in their box, or a coordinate that is no number.
    pub culled: u64,
    /// Pairs of a triangle and a tile that its box meets.
    pub binned: u64,
    /// Those of them where the triangle lies beside the tile: the skip `tile`.
    pub beside: u64,
    /// Those of them where it lies behind all that is drawn: the skip `hierarchical-z`.
    pub behind: u64,
    /// Blocks of 16 x 8 pixels where a triangle lies behind all that is drawn: the same skip.
    pub hidden: u64,
    /// Blocks of that size, or narrower ones around small triangles, whose pixels were looked at.
    pub blocks: u64,
    /// Tiles that needed no clearing, since nothing was drawn there: the skip `clear`.
    pub clean: u64,
    /// Areas, centres and depths that intervals did not decide.
    pub exact_turns: u64,
    /// Signs of edges asked for at centres.
    pub exact_signs: u64,
    /// Depths rounded exactly.
    pub exact_depths: u64,
}

impl std::ops::AddAssign for Stats {
    fn add_assign(&mut self, other: Self) {
        self.triangles += other.triangles;
        self.culled += other.culled;
        self.binned += other.binned;
        self.beside += other.beside;
        self.behind += other.behind;
        self.hidden += other.hidden;
        self.blocks += other.blocks;
        self.clean += other.clean;
        self.exact_turns += other.exact_turns;
        self.exact_signs += other.exact_signs;
        self.exact_depths += other.exact_depths;
    }
}

/// What the set-up of a triangle needs of a [`State`].
#[derive(Clone, Copy, Debug)]
struct Rules {
    /// For the exact predicates; the size does not matter to them.
    raster: raster::Settings,
    /// Whether the first row of a box is drawn if it meets vertices: 0 never, 1 at a horizontal edge, 2 also
    /// at a single vertex. The last row likewise.
    first_row: f64,
    last_row: f64,
    /// The skips.
    tile: bool,
    hierarchical_z: bool,
}

impl Rules {
    fn new(state: &State, size: [u32; 2]) -> Self {
        let down = f64::from(state.y_axis == YAxis::Down);
        let [first_row, last_row] = match state.fill_rule {
            FillRule::TopLeft => [down, 1.0 - down],
            FillRule::RightOfPoint => [1.0; 2],
            FillRule::Inclusive => [2.0; 2],
            FillRule::Strict => [0.0; 2],
        };
        let raster = raster::Settings {
            fill_rule: state.fill_rule,
            y_axis: state.y_axis,
            ..raster::Settings::new(size)
        };
        let tile = state.skips.has(Skip::Tile);
        let hierarchical_z = state.skips.has(Skip::HierarchicalZ) && state.lowers_depths();
        Self { raster, first_row, last_row, tile, hierarchical_z }
    }
}

/// The rasterizer, with the memory it keeps from call to call.
#[derive(Debug, Default)]
pub struct Engine {
    bins: Bins,
    tile: Tile,
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
        let mut stats = Stats { triangles: triangles.len() as u64, ..Stats::default() };
        let size = canvas.size;
        let rules = Rules::new(state, size);
        let bins = &mut self.bins;
        bins.reset(size);
        state.lanes.run(
            #[inline(always)]
            || bins.fill(triangles, size, &mut stats),
        );
        if let Some(clear) = &clear {
            canvas.expect(clear);
        }
        let [columns, _] = canvas::tiles(size);
        let keep = state.skips.has(Skip::Clear);
        for index in 0..canvas.clean.len() {
            let list = bins.list(index);
            let origin = [index % columns, index / columns].map(|tile| (tile * TILE) as u32);
            if list.is_empty() {
                if let Some(clear) = &clear {
                    if canvas.clean[index] && keep {
                        stats.clean += 1;
                    } else {
                        self.tile.clear(clear);
                        self.tile.store(canvas, origin);
                    }
                    canvas.clean[index] = true;
                }
                continue;
            }
            stats.binned += list.len() as u64;
            match &clear {
                Some(clear) => self.tile.clear(clear),
                None => self.tile.load(canvas, origin),
            }
            self.tile.draw(Job { origin, state, rules: &rules }, list, &mut stats);
            self.tile.store(canvas, origin);
            canvas.clean[index] = false;
        }
        stats
    }
}
