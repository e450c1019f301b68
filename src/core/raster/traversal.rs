//! Ways over the centres around a triangle: which of them are looked at, in which order.
//!
//! All ask the same three edge functions about a centre (see [`probe`]); they differ in what they
//! leave out. One file holds one way. A run of each can be stepped.
//!
//! *Source:* Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988 (edge functions and
//! ways to traverse them); the ways' own files. Deviation: the sign of an edge function is exact, so that
//! no vertex needs snapping.

pub(super) mod cells;
mod explain;
mod formulas;
mod marks;
pub(super) mod probe;
mod tables;
mod visits;

pub use explain::Snapshot;
pub use visits::{Visits, of_each_way, visits};

use super::{Counts, Edges, Settings, Span, YAxis, first_centre};
use crate::{
    math::{Arithmetic, Tally},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use probe::{Exact, Probe, Taught};
use serde::{Deserialize, Serialize};
use std::{fmt::Debug, ops::Range};

/// Where a walker turns to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Direction {
    /// Towards smaller x.
    Left,
    /// Towards greater x.
    Right,
}

/// What the drawing shows of the centres.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Show {
    /// Which are drawn, and which were tested more than once.
    #[default]
    Pixels,
    /// In which order they were tested: a heat map.
    Visits,
}

/// What is known of a whole tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Every centre of it lies outside one edge.
    Outside {
        /// The edge.
        edge: u8,
    },
    /// Every centre of it lies inside all edges.
    Inside,
    /// An edge passes through: its parts are looked at.
    Split,
}

/// What a traversal did. At most 16 bytes; images have at most 16384 columns and rows.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", rename_all_fields = "snake_case")]
pub enum Event {
    /// The area is exactly zero: nothing is drawn.
    ZeroArea,
    /// The centres of the bounding box that lie in the image.
    Box {
        /// First column, and one past the last.
        columns: [u16; 2],
        /// First row, and one past the last.
        rows: [u16; 2],
    },
    /// A row begins.
    Row {
        /// The row.
        y: u16,
    },
    /// A walker goes on from here.
    Turn {
        /// Column where it stands.
        x: u16,
        /// Where it goes.
        to: Direction,
    },
    /// A tile was compared with the edges.
    Tile {
        /// Its first column.
        x: u16,
        /// Its first row.
        y: u16,
        /// Pixels a side.
        size: u8,
        /// What is known of it.
        verdict: Verdict,
    },
    /// A centre was compared with the edges.
    Test {
        /// Its column.
        x: u16,
        /// Its row.
        y: u16,
        /// One bit for each edge that keeps it out, the first lowest; 0 draws it.
        keeps_out: u8,
    },
    /// The rest of the row lies behind the triangle and is left out.
    Skip {
        /// How many centres.
        centres: u16,
    },
    /// All is done.
    Done,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// One way over the centres. Its listing stands beside it.
pub trait Traversal: Clone + Debug + Default + PartialEq + Send + 'static {
    /// Its name on the command line.
    const NAME: &'static str;
    /// Pseudocode, one line each.
    const LISTING: &'static [&'static str];

    /// The listing line that an event executes.
    fn line(event: &Event) -> usize;

    /// Finds the covered centres of an area. Spans are emitted once a row at most.
    fn walk<P: Probe, T: Tracer<Event>>(
        area: &Area,
        probe: &mut P,
        t: &mut T,
        emit: &mut impl FnMut(Span),
    ) -> Counts;
}

/// The centres of the bounding box that lie in the image, and where to begin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Area {
    /// Columns, in the image.
    pub columns: Range<u32>,
    /// Rows, in the image.
    pub rows: Range<u32>,
    /// The column nearest to the highest vertex.
    pub start: u32,
    /// Which way rows grow.
    pub y_axis: YAxis,
    /// Whether the rest of a row behind the triangle is left out.
    pub skip_row: bool,
}

impl Area {
    fn new(vertices: [[f32; 2]; 3], settings: &Settings) -> Self {
        let [columns, rows] = [0, 1].map(|axis| {
            let [a, b, c] = vertices.map(|vertex| f64::from(vertex[axis]));
            let limit = settings.size[axis];
            first_centre(a.min(b).min(c), false, limit)..first_centre(a.max(b).max(c), true, limit)
        });
        let height = |vertex: &[f32; 2]| match settings.y_axis {
            YAxis::Down => -vertex[1],
            YAxis::Up => vertex[1],
        };
        let [a, b, c] = vertices;
        let higher = |p: [f32; 2], q: [f32; 2]| if height(&q) > height(&p) { q } else { p };
        let [top, _] = higher(higher(a, b), c);
        // `as` saturates: a vertex far off the image is beside the first or the last column.
        let start = (f64::from(top) as u32).clamp(columns.start, columns.end.max(columns.start + 1) - 1);
        Self { columns, rows, start, y_axis: settings.y_axis, skip_row: settings.skip_row }
    }

    /// Whether there is no centre to look at.
    pub fn is_empty(&self) -> bool {
        self.columns.is_empty() || self.rows.is_empty()
    }

    /// The rows from the highest to the lowest.
    pub fn from_top(&self) -> impl Iterator<Item = u32> + use<> {
        let Range { start, end } = self.rows;
        let y_axis = self.y_axis;
        (start..end).map(move |y| match y_axis {
            YAxis::Down => y,
            YAxis::Up => end - 1 - (y - start),
        })
    }
}

/// Covers the pixels whose centres lie inside, on the way `A`; see [`cover`](super::cover).
pub fn fill<A: Traversal>(
    vertices: [[f32; 2]; 3],
    settings: &Settings,
    tally: &mut Tally,
    emit: &mut impl FnMut(Span),
) -> Counts {
    fill_traced::<A, _>(vertices, settings, tally, &mut NoTrace, emit)
}

/// [`fill`] as a run that can be scrubbed.
pub fn play<A: Traversal>(
    vertices: [[f32; 2]; 3],
    settings: Settings,
    budget: Budget,
) -> Player<Snapshot<A>> {
    play_shown(vertices, settings, Show::Pixels, budget)
}

/// [`play`] with another drawing of the centres.
pub fn play_shown<A: Traversal>(
    vertices: [[f32; 2]; 3],
    settings: Settings,
    show: Show,
    budget: Budget,
) -> Player<Snapshot<A>> {
    Player::new(Snapshot::new(vertices, settings, show), budget, move |t| {
        fill_traced::<A, _>(vertices, &settings, &mut Tally::default(), t, &mut |_| {});
    })
}

/// The algorithm: [`fill`] and [`play`] are this with two tracers.
///
/// `F32` and `F64` compute edge functions as the lecture prints them, `n . (p - v)`: wrong pixels are what
/// they are for.
pub fn fill_traced<A: Traversal, T: Tracer<Event>>(
    vertices: [[f32; 2]; 3],
    settings: &Settings,
    tally: &mut Tally,
    t: &mut T,
    emit: &mut impl FnMut(Span),
) -> Counts {
    let vertices = settings.vertices(vertices);
    let Some(edges) = Edges::new(vertices, settings, tally) else {
        t.emit(|| Event::ZeroArea);
        return Counts::default();
    };
    let area = Area::new(vertices, settings);
    t.emit(|| {
        let ends = |range: &Range<u32>| [range.start as u16, range.end.max(range.start) as u16];
        Event::Box { columns: ends(&area.columns), rows: ends(&area.rows) }
    });
    let counts = if area.is_empty() {
        Counts::default()
    } else {
        let epsilon = settings.epsilon();
        match settings.arithmetic {
            Arithmetic::F32 => A::walk(&area, &mut Taught::<f32>::new(edges, epsilon), t, emit),
            // Who has an epsilon does not ask for exact signs.
            arithmetic if arithmetic == Arithmetic::F64 || epsilon.is_some() => {
                A::walk(&area, &mut Taught::<f64>::new(edges, epsilon), t, emit)
            }
            _ => A::walk(&area, &mut Exact::new(edges, area.columns.end, tally), t, emit),
        }
    };
    t.emit(|| Event::Done);
    counts
}

/// Looks at one centre: the edges that keep it out.
#[inline]
pub(super) fn test<P: Probe, T: Tracer<Event>>(
    (probe, row): (&mut P, &P::Row),
    [x, y]: [u32; 2],
    counts: &mut Counts,
    t: &mut T,
) -> u8 {
    counts.tested += 1;
    let keeps_out = probe.keeps_out(row, x, y);
    t.emit(|| Event::Test { x: x as u16, y: y as u16, keeps_out });
    keeps_out
}

/// The covered centres of one row, which are neighbours since a triangle is convex.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Run {
    begin: u32,
    end: u32,
}

impl Run {
    #[inline]
    pub(super) fn is_empty(self) -> bool {
        self.begin == self.end
    }

    /// Takes in the centres `begin..end`.
    #[inline]
    pub(super) fn add(&mut self, begin: u32, end: u32) {
        *self = if self.is_empty() {
            Self { begin, end }
        } else {
            Self { begin: self.begin.min(begin), end: self.end.max(end) }
        };
    }

    /// A centre in the middle of it.
    #[inline]
    pub(super) fn middle(self) -> u32 {
        self.begin + (self.end - self.begin) / 2
    }

    /// Hands it over, if there is any.
    #[inline]
    pub(super) fn emit(self, y: u32, counts: &mut Counts, emit: &mut impl FnMut(Span)) {
        if !self.is_empty() {
            counts.covered += u64::from(self.end - self.begin);
            emit(Span { y, begin: self.begin, end: self.end });
        }
    }
}
