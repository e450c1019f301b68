//! The slope scan line: walk down two edges at once and fill the centres between them.
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 3.6; Heckbert,
//! Generic Convex Polygon Scan Conversion and Clipping, Graphics Gems, 1990. Deviation: in exact
//! arithmetic a slope only guesses where a span ends, x is never accumulated over rows, and the
//! exact sign of the edge decides.

mod bounds;
mod explain;
mod formulas;
mod sentences;

pub use explain::Snapshot;

use super::{Counts, Edges, FillRule, Mistake, Settings, Span, YAxis, first_centre};
use crate::{
    math::{Arithmetic, Real, Tally},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use bounds::Bound;
use serde::Serialize;
use std::ops::Range;

/// The two ends of a span.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// Where it begins.
    Left,
    /// Where it ends.
    Right,
}

/// An edge between vertices sorted from top to bottom.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Between {
    /// Upper short edge.
    TopMiddle,
    /// Lower short edge.
    MiddleBottom,
    /// Long edge, walked in both halves.
    TopBottom,
}

impl Between {
    /// In the order in which slopes are computed.
    pub const ALL: [Self; 3] = [Self::TopMiddle, Self::MiddleBottom, Self::TopBottom];

    /// Its ends among the sorted vertices.
    pub fn ends(self) -> [usize; 2] {
        match self {
            Self::TopMiddle => [0, 1],
            Self::MiddleBottom => [1, 2],
            Self::TopBottom => [0, 2],
        }
    }
}

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", rename_all_fields = "snake_case")]
pub enum Event {
    /// The vertices were sorted from top to bottom.
    Sorted {
        /// Their indices.
        order: [u8; 3],
    },
    /// The area is exactly zero: nothing is drawn.
    ZeroArea,
    /// The slope of an edge was computed; a horizontal edge has none.
    Slope {
        /// The edge.
        edge: Between,
        /// Change of x per unit of y.
        dx_dy: f64,
    },
    /// A half of the triangle begins.
    Half {
        /// Its short edge.
        edge: Between,
        /// The least of its rows.
        begin: u32,
        /// One past the greatest; equal if no row has its centre in this half.
        end: u32,
    },
    /// A row begins.
    Row {
        /// The row.
        y: u32,
    },
    /// The row's centre line meets an edge.
    Crossing {
        /// Which end of the span it makes.
        side: Side,
        /// The edge.
        edge: Between,
        /// Where, as computed.
        x: f64,
    },
    /// An end of the span: its first pixel, or the one past its last.
    End {
        /// Which end.
        side: Side,
        /// The column.
        x: u32,
        /// Whether the exact sign moved the end that the crossing suggested.
        corrected: bool,
    },
    /// A centre lies exactly on an edge: the fill rule decided.
    Tie {
        /// Which end of the span the edge makes.
        side: Side,
        /// The edge.
        edge: Between,
        /// The column.
        x: u32,
        /// Whether this edge draws it.
        drawn: bool,
    },
    /// The span of the row is known.
    Span {
        /// First column.
        begin: u32,
        /// One past the last column; equal if the row is empty.
        end: u32,
    },
    /// A pixel was drawn.
    Pixel {
        /// The column.
        x: u32,
    },
    /// All rows are done.
    Done,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Covers the pixels whose centres lie inside; see [`cover`](super::cover).
///
/// Cost: three divisions a triangle, then two crossings and about four signs a row, whatever its
/// length.
pub fn fill(
    vertices: [[f32; 2]; 3],
    settings: &Settings,
    tally: &mut Tally,
    emit: &mut impl FnMut(Span),
) -> Counts {
    fill_traced(vertices, settings, tally, &mut NoTrace, emit)
}

/// [`fill`] as a run that can be scrubbed.
pub fn play(vertices: [[f32; 2]; 3], settings: Settings, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(vertices, settings), budget, move |t| {
        fill_traced(vertices, &settings, &mut Tally::default(), t, &mut |_| {});
    })
}

/// The algorithm: [`fill`] and [`play`] are this with two tracers.
///
/// `F32` and `F64` compute as the lecture prints it, adding the slope from row to row: drifting
/// ends and lost ties are what they are for.
pub fn fill_traced<T: Tracer<Event>>(
    vertices: [[f32; 2]; 3],
    settings: &Settings,
    tally: &mut Tally,
    t: &mut T,
    emit: &mut impl FnMut(Span),
) -> Counts {
    match settings.arithmetic {
        Arithmetic::F32 => scan::<f32, T>(vertices, settings, tally, t, emit),
        _ if settings.mistake == Some(Mistake::AccumulatedSlopes) => {
            scan::<f32, T>(vertices, settings, tally, t, emit)
        }
        _ => scan::<f64, T>(vertices, settings, tally, t, emit),
    }
}

/// The text of the algorithm, for crossings of any type.
fn scan<R: Real, T: Tracer<Event>>(
    vertices: [[f32; 2]; 3],
    settings: &Settings,
    tally: &mut Tally,
    t: &mut T,
    emit: &mut impl FnMut(Span),
) -> Counts {
    let mut counts = Counts::default();
    let vertices = settings.vertices(vertices);
    let order = from_top_to_bottom(vertices, settings.y_axis);
    t.emit(|| Event::Sorted { order });
    let sorted = order.map(|i| vertices[usize::from(i)]);
    let Some(edges) = Edges::new(sorted, settings, tally) else {
        t.emit(|| Event::ZeroArea);
        return counts;
    };
    let slopes = Between::ALL.map(|edge| {
        let [[x0, y0], [x1, y1]] = edge.ends().map(|end| sorted[end].map(R::from_f32));
        // Adding zero turns -0 into 0.
        let slope = (x1 - x0) / (y1 - y0) + R::ZERO;
        if y0 != y1 {
            t.emit(|| Event::Slope { edge, dx_dy: slope.to_f64() });
        }
        slope
    });
    let bound = |edge: Between, side| {
        let [start, _] = edge.ends().map(|end| sorted[end].map(R::from_f32));
        Bound::new(edges.0[edge as usize], (edge, side), start, slopes[edge as usize], settings)
    };
    let long_is_left = edges.0[Between::TopBottom as usize].is_left();
    let (long_side, short_side) =
        if long_is_left { (Side::Left, Side::Right) } else { (Side::Right, Side::Left) };
    let mut long = bound(Between::TopBottom, long_side);
    for (edge, rows) in halves(sorted, settings) {
        t.emit(|| Event::Half { edge, begin: rows.start, end: rows.end });
        let mut short = bound(edge, short_side);
        for step in 0..rows.end - rows.start {
            let y = match settings.y_axis {
                YAxis::Down => rows.start + step,
                YAxis::Up => rows.end - 1 - step,
            };
            t.emit(|| Event::Row { y });
            let (left, right) = if long_is_left { (&mut long, &mut short) } else { (&mut short, &mut long) };
            let begin = left.find(y, settings, tally, t, &mut counts);
            // Rounded crossings can pass each other; the row is empty then.
            let end = right.find(y, settings, tally, t, &mut counts).max(begin);
            t.emit(|| Event::Span { begin, end });
            if T::ENABLED {
                (begin..end).for_each(|x| t.emit(|| Event::Pixel { x }));
            }
            if begin < end {
                counts.covered += u64::from(end - begin);
                emit(Span { y, begin, end });
            }
        }
    }
    t.emit(|| Event::Done);
    counts
}

/// Indices of the vertices, highest first; equal heights keep their order.
fn from_top_to_bottom(vertices: [[f32; 2]; 3], y_axis: YAxis) -> [u8; 3] {
    let mut order = [0, 1, 2];
    let height = |i: u8| vertices[usize::from(i)][1];
    order.sort_by(|&a, &b| match y_axis {
        YAxis::Down => height(a).total_cmp(&height(b)),
        YAxis::Up => height(b).total_cmp(&height(a)),
    });
    order
}

/// The short edge of each half that has a height, and the rows whose centres lie in it.
///
/// A row through the middle vertex belongs to the lower half, if there is one. Rows exactly
/// through the top or the bottom count if the fill rule draws horizontal edges there.
fn halves(
    [top, middle, bottom]: [[f32; 2]; 3],
    settings: &Settings,
) -> impl Iterator<Item = (Between, Range<u32>)> {
    let (draws_top, draws_bottom) = match settings.fill_rule {
        FillRule::TopLeft => (true, false),
        FillRule::RightOfPoint | FillRule::Inclusive => (true, true),
        FillRule::Strict => (false, false),
    };
    let has_upper = top[1] != middle[1];
    let has_lower = middle[1] != bottom[1];
    let rows = |from: [f32; 2], closed_from: bool, to: [f32; 2], closed_to: bool| {
        let [from, to] = [from, to].map(|vertex| f64::from(vertex[1]));
        let height = settings.size[1];
        match settings.y_axis {
            YAxis::Down => first_centre(from, !closed_from, height)..first_centre(to, closed_to, height),
            YAxis::Up => first_centre(to, !closed_to, height)..first_centre(from, closed_from, height),
        }
    };
    let upper =
        has_upper.then(|| (Between::TopMiddle, rows(top, draws_top, middle, !has_lower && draws_bottom)));
    let lower = has_lower
        .then(|| (Between::MiddleBottom, rows(middle, has_upper || draws_top, bottom, draws_bottom)));
    upper.into_iter().chain(lower)
}
