//! Polygon fill with an edge table: a list of the edges that cross the row, sorted by x, from row to row.
//!
//! Coordinates are pixels, centres at + 0.5, y as the settings say. Which centres are inside, the
//! [`WindingRule`] decides; a centre exactly on an edge belongs to the side to its right, and where the edge
//! is horizontal to the side below it. So polygons that share edges draw each pixel once, and a triangle
//! covers what every rasterizer of this stage covers under the top-left rule.
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 3.6; Heckbert, Concave
//! Polygon Scan Conversion, Graphics Gems, 1990; Direct3D 11.3 functional specification, section 3.4.2
//! (top-left rule). Deviations: the buckets are one list sorted by first row; in exact arithmetic x is never
//! accumulated over rows, the exact sign of the edge decides between two columns, and edges that cross
//! within a row are sorted by the column that they reach, which needs no comparison of crossings.

mod active;
mod explain;
mod formulas;
mod names;
mod picture;
mod sentences;
mod snapshot;
mod winding;

pub use snapshot::Snapshot;
pub use winding::WindingRule;

use super::{Counts, Span, YAxis, first_centre};
use crate::{
    math::{Arithmetic, Real, Tally},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use active::Active;
use serde::Serialize;
use std::{ops::Range, sync::Arc};

/// A corner, in pixels.
pub type Point = [f32; 2];

/// The conventions of a fill.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Settings {
    /// Width and height of the image in pixels, each in `1..=16384`; pixels outside are left out.
    pub size: [u32; 2],
    /// What is inside.
    pub winding: WindingRule,
    /// Which way the corners' y and the rows grow.
    pub y_axis: YAxis,
    /// What crossings are computed in. Fixed point snaps the corners, then is exact.
    pub arithmetic: Arithmetic,
}

impl Settings {
    /// Exact, even-odd, y down.
    pub fn new(size: [u32; 2]) -> Self {
        Self {
            size,
            winding: WindingRule::default(),
            y_axis: YAxis::default(),
            arithmetic: Arithmetic::default(),
        }
    }

    /// The corner that is used: as given, or snapped by fixed point.
    pub fn corner(&self, at: Point) -> Point {
        at.map(|coordinate| self.arithmetic.snap(coordinate))
    }

    /// The row that the walk from the top comes to as number `line`.
    fn row(&self, line: u32) -> u32 {
        match self.y_axis {
            YAxis::Down => line,
            YAxis::Up => self.size[1] - 1 - line,
        }
    }

    /// The rows with their centres between two heights, the first of which is higher; the upper end counts,
    /// the lower one does not.
    fn lines(&self, upper: f32, lower: f32) -> Range<u32> {
        let height = self.size[1];
        let row = |y: f32, open| first_centre(y.into(), open, height);
        match self.y_axis {
            YAxis::Down => row(upper, false)..row(lower, false),
            YAxis::Up => height - row(upper, true)..height - row(lower, true),
        }
    }
}

/// What the algorithm did. At most 16 bytes. Edges are numbered contour by contour.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", rename_all_fields = "snake_case")]
pub enum Event {
    /// An edge crosses no row's centre line, so it stays out of the table.
    LeftOut {
        /// The edge.
        edge: u32,
    },
    /// An edge was put into the bucket of its first row.
    Edge {
        /// The edge.
        edge: u32,
        /// The highest row that it crosses.
        first: u32,
        /// The lowest one.
        last: u32,
    },
    /// Its slope was computed.
    Slope {
        /// The edge.
        edge: u32,
        /// Change of x per unit of y.
        dx_dy: f64,
    },
    /// The table is complete.
    Built {
        /// How many edges are in it.
        edges: u32,
    },
    /// A row begins.
    Row {
        /// The row.
        y: u32,
    },
    /// An edge of the row's bucket was taken into the active list.
    Take {
        /// The edge.
        edge: u32,
    },
    /// The row's centre line meets an active edge.
    Crossing {
        /// The edge.
        edge: u32,
        /// Where, as computed.
        x: f64,
    },
    /// The first column whose centre is at or right of the edge.
    First {
        /// The edge.
        edge: u32,
        /// The column; the image's width if there is none.
        x: u32,
        /// Whether the exact sign moved what the crossing suggested.
        corrected: bool,
    },
    /// The centre of that column lies exactly on the edge, so it belongs to the right.
    Tie {
        /// The edge.
        edge: u32,
        /// The column.
        x: u32,
    },
    /// The active edges were out of order, and were sorted.
    Sorted,
    /// The next active edge was stepped over, from left to right.
    Across {
        /// The edge.
        edge: u32,
        /// How often the contours wind around the points to its right.
        winding: i32,
    },
    /// What lies between two active edges is inside.
    Span {
        /// First column.
        begin: u32,
        /// One past the last column; equal if no centre lies between.
        end: u32,
    },
    /// The row is done.
    RowDone,
    /// An active edge ends above the next row, and was dropped.
    Drop {
        /// The edge.
        edge: u32,
    },
    /// All rows are done.
    Done,
}
const _: () = assert!(size_of::<Event>() <= 16);

impl Event {
    /// The edge that it is about.
    fn edge(&self) -> Option<u32> {
        match *self {
            Self::LeftOut { edge }
            | Self::Edge { edge, .. }
            | Self::Slope { edge, .. }
            | Self::Take { edge }
            | Self::Crossing { edge, .. }
            | Self::First { edge, .. }
            | Self::Tie { edge, .. }
            | Self::Across { edge, .. }
            | Self::Drop { edge } => Some(edge),
            _ => None,
        }
    }
}

/// An edge of the table.
#[derive(Clone, Copy, Debug)]
struct Entry<R> {
    edge: u32,
    /// Upper end first.
    ends: [Point; 2],
    /// The first of the lines that it crosses, and the one past the last.
    first: u32,
    end: u32,
    dx_dy: R,
    /// What stepping over it from left to right adds to the winding number.
    direction: i32,
}

/// Finds the pixels whose centres are inside, as spans from top to bottom and from left to right that neither
/// touch nor overlap.
///
/// Any number of closed contours of any number of finite corners, in either direction; convex, concave,
/// self-crossing, nested, degenerate; on or off the image. What has no area covers nothing. `tally` counts
/// the signs asked for, two for an edge and row. Cost: about 10 ns for each edge and row that it crosses,
/// whatever the length of the spans, and the sorting of the edges.
pub fn fill(
    contours: &[Vec<Point>],
    settings: &Settings,
    tally: &mut Tally,
    emit: &mut impl FnMut(Span),
) -> Counts {
    fill_traced(contours, settings, tally, &mut NoTrace, emit)
}

/// [`fill`] as a run that can be scrubbed.
pub fn play(contours: &[Vec<Point>], settings: Settings, budget: Budget) -> Player<Snapshot> {
    let contours: Arc<[Vec<Point>]> = contours.into();
    Player::new(Snapshot::new(contours.clone(), settings), budget, move |t| {
        fill_traced(&contours, &settings, &mut Tally::default(), t, &mut |_| {});
    })
}

/// The algorithm: [`fill`] and [`play`] are this with two tracers.
///
/// `F32` and `F64` compute as taught, adding the slope from row to row: drifting ends are what they are for.
pub fn fill_traced<T: Tracer<Event>>(
    contours: &[Vec<Point>],
    settings: &Settings,
    tally: &mut Tally,
    t: &mut T,
    emit: &mut impl FnMut(Span),
) -> Counts {
    match settings.arithmetic {
        Arithmetic::F32 => scan::<f32, T>(contours, settings, tally, t, emit),
        _ => scan::<f64, T>(contours, settings, tally, t, emit),
    }
}

/// The text of the algorithm, for crossings of any type.
fn scan<R: Real, T: Tracer<Event>>(
    contours: &[Vec<Point>],
    settings: &Settings,
    tally: &mut Tally,
    t: &mut T,
    emit: &mut impl FnMut(Span),
) -> Counts {
    let mut counts = Counts::default();
    let asked = tally.calls;
    let table = table::<R, T>(contours, settings, t);
    let mut waiting = &table[..];
    let mut active: Vec<Active<R>> = Vec::new();
    let mut line = 0;
    loop {
        if active.is_empty() {
            // Rows that no edge crosses are passed over.
            let Some(next) = waiting.first() else { break };
            line = next.first;
        }
        let y = settings.row(line);
        t.emit(|| Event::Row { y });
        let (bucket, later) = waiting.split_at(waiting.partition_point(|entry| entry.first == line));
        waiting = later;
        for &entry in bucket {
            t.emit(|| Event::Take { edge: entry.edge });
            active.push(Active::new(entry));
        }
        for edge in &mut active {
            edge.meet(y, settings, tally, t);
        }
        if !active.is_sorted_by(|a, b| a.order(b).is_le()) {
            active.sort_by(Active::order);
            t.emit(|| Event::Sorted);
        }
        walk(&active, settings.winding, t, &mut |begin, end| {
            counts.covered += u64::from(end - begin);
            emit(Span { y, begin, end });
        });
        t.emit(|| Event::RowDone);
        line += 1;
        active.retain(|edge| {
            let stays = edge.crosses(line);
            if !stays {
                t.emit(|| Event::Drop { edge: edge.name() });
            }
            stays
        });
    }
    t.emit(|| Event::Done);
    counts.tested = tally.calls - asked;
    counts
}

/// The edge table: every edge that crosses a row's centre line, sorted by first row.
fn table<R: Real, T: Tracer<Event>>(
    contours: &[Vec<Point>],
    settings: &Settings,
    t: &mut T,
) -> Vec<Entry<R>> {
    let mut table = Vec::new();
    for (edge, ends) in (0..).zip(edges(contours)) {
        let [a, b] = ends.map(|end| settings.corner(end));
        let down = (a[1] < b[1]) == (settings.y_axis == YAxis::Down);
        let ends = if down { [a, b] } else { [b, a] };
        let lines = settings.lines(ends[0][1], ends[1][1]);
        // So is every horizontal edge: the edges at its ends decide.
        if lines.is_empty() {
            t.emit(|| Event::LeftOut { edge });
            continue;
        }
        let [first, last] = [lines.start, lines.end - 1].map(|line| settings.row(line));
        t.emit(|| Event::Edge { edge, first, last });
        let [[x0, y0], [x1, y1]] = ends.map(|end| end.map(R::from_f32));
        // Adding zero turns -0 into 0.
        let dx_dy = (x1 - x0) / (y1 - y0) + R::ZERO;
        t.emit(|| Event::Slope { edge, dx_dy: dx_dy.to_f64() });
        let direction = if down { 1 } else { -1 };
        table.push(Entry { edge, ends, first: lines.start, end: lines.end, dx_dy, direction });
    }
    table.sort_by_key(|entry| entry.first);
    t.emit(|| Event::Built { edges: table.len() as u32 });
    table
}

/// The edges of closed contours.
fn edges(contours: &[Vec<Point>]) -> impl Iterator<Item = [Point; 2]> {
    contours.iter().flat_map(|corners| {
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).map(|(&a, &b)| [a, b])
    })
}

/// Walks from left to right over the sorted active edges of a row; `emit` gets the spans that are inside.
fn walk<R: Real, T: Tracer<Event>>(
    active: &[Active<R>],
    rule: WindingRule,
    t: &mut T,
    emit: &mut impl FnMut(u32, u32),
) {
    let (mut winding, mut begin) = (0, 0);
    // Where edges meet in a column, a span can end and the next begin: they are one.
    let mut pending = 0..0;
    for edge in active {
        let was_inside = rule.is_inside(winding);
        winding += edge.direction();
        t.emit(|| Event::Across { edge: edge.name(), winding });
        let first = edge.first();
        match (was_inside, rule.is_inside(winding)) {
            (false, true) => begin = first,
            (true, false) => {
                t.emit(|| Event::Span { begin, end: first });
                if begin < first && begin == pending.end {
                    pending.end = first;
                } else if begin < first {
                    if !pending.is_empty() {
                        emit(pending.start, pending.end);
                    }
                    pending = begin..first;
                }
            }
            _ => {}
        }
    }
    if !pending.is_empty() {
        emit(pending.start, pending.end);
    }
}
