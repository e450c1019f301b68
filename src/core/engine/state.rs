//! How triangles are drawn.

use super::{Lanes, Threads};
use crate::{
    depth::{CompareFunction, DepthFormat, DepthState},
    pipeline::{Skip, Skips},
    raster::{self, FillRule, YAxis},
    stencil::StencilState,
};

/// How it is drawn.
#[derive(Clone, Copy, Debug)]
pub struct State {
    /// The depth test.
    pub depth: DepthState,
    /// How depths are stored.
    pub store: DepthStore,
    /// The stencil test; in canvases without stencil values these are the cleared ones, or 0, in each call.
    pub stencil: Option<StencilState>,
    /// Who draws a centre on an edge.
    pub fill_rule: FillRule,
    /// Which way the vertices' y and the rows grow.
    pub y_axis: YAxis,
    /// What is left out: `tile`, `hierarchical-z` and `clear` are looked at; front to back is part of the second.
    pub skips: Skips,
    /// The vector unit.
    pub lanes: Lanes,
    /// How many threads draw.
    pub threads: Threads,
}

impl Default for State {
    /// Nearer ones win, top-left, y down, every skip, the widest unit, one thread.
    fn default() -> Self {
        Self {
            depth: DepthState::default(),
            store: DepthStore::default(),
            stencil: None,
            fill_rule: FillRule::default(),
            y_axis: YAxis::default(),
            skips: Skips::ALL,
            lanes: Lanes::widest(),
            threads: Threads::ONE,
        }
    }
}

impl State {
    /// Whether nothing can happen to a pixel but that a lesser depth takes it over.
    pub(super) fn lowers_depths(&self) -> bool {
        let DepthState { test, compare, write } = self.depth;
        let f32 = self.store == DepthStore::F32;
        f32 && test && write && compare == CompareFunction::Less && self.stencil.is_none()
    }
}

/// How depths are stored: in the formats whose codes binary32 holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DepthStore {
    /// As they are.
    #[default]
    F32,
    /// As codes of [`DepthFormat::Unorm16`].
    Unorm16,
    /// As codes of [`DepthFormat::Unorm24`].
    Unorm24,
}

impl DepthStore {
    /// That of a format; `None` if binary32 does not hold its codes.
    pub fn of(format: DepthFormat) -> Option<Self> {
        match format {
            DepthFormat::F32 => Some(Self::F32),
            DepthFormat::Unorm16 => Some(Self::Unorm16),
            DepthFormat::Unorm24 => Some(Self::Unorm24),
            DepthFormat::Unorm32 => None,
        }
    }

    /// Its format.
    pub fn format(self) -> DepthFormat {
        match self {
            Self::F32 => DepthFormat::F32,
            Self::Unorm16 => DepthFormat::Unorm16,
            Self::Unorm24 => DepthFormat::Unorm24,
        }
    }

    pub(super) fn max_code(self) -> Option<u32> {
        self.format().max_code()
    }
}

/// What the set-up of a triangle needs of a [`State`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Rules {
    /// For the exact predicates; the size does not matter to them.
    pub(super) raster: raster::Settings,
    /// Whether the first row of a box is drawn if it meets vertices: 0 never, 1 at a horizontal edge, 2 also
    /// at a single vertex. The last row likewise.
    pub(super) first_row: f32,
    pub(super) last_row: f32,
    /// The skips.
    pub(super) tile: bool,
    pub(super) hierarchical_z: bool,
    /// Whether hidden fragments are counted.
    pub(super) counts: bool,
    /// Whether the triangles of a tile are drawn front to back.
    pub(super) sorts: bool,
}

impl Rules {
    pub(super) fn new(state: &State, size: [u32; 2], counts: bool) -> Self {
        let down = if state.y_axis == YAxis::Down { 1.0 } else { 0.0 };
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
        Self { raster, first_row, last_row, tile, hierarchical_z, counts, sorts: false }
    }
}
