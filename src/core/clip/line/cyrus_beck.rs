//! Cyrus-Beck line clipping: against any convex window, edge by edge, by the inward normal.
//!
//! With D = P2 - P1 and w = P1 - a, for an edge with the corner a and the inward normal n, a point
//! `P1 + t D` lies inside if `w.n + t D.n >= 0`. The line enters where D.n > 0 and leaves where
//! D.n < 0, both at `t = -w.n / D.n`. The visible part runs from the last entry tE to the first
//! exit tL.
//!
//! *Source:* Cyrus and Beck, Generalized Two- and Three-Dimensional Clipping, Computers and
//! Graphics 3(1), 1978; Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section
//! 3.12.4. Deviation: in exact arithmetic the quotients are shown rounded, but compared as exact
//! fractions.

mod explain;
mod forms;
mod formulas;

pub use super::{Course, Parameter, Quotient, Visible};
pub use explain::Snapshot;

use super::{ConvexWindow, End, Point, Segment};
use crate::{
    math::{Arithmetic, Real, Sign, Tally},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use forms::{Exact, Form, Taught};
use serde::Serialize;

/// An edge of the window, by its index.
pub type Edge = u8;

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The visible part is the whole segment so far.
    Start,
    /// D.n and w.n of an edge were computed.
    Measure {
        /// The edge.
        edge: Edge,
        /// What the line does there.
        course: Course,
    },
    /// The line is parallel to the edge: w.n < 0 means that it lies beyond it.
    Along {
        /// The edge.
        edge: Edge,
        /// Whether it lies beyond.
        outside: bool,
    },
    /// A quotient was computed.
    Divide {
        /// The edge.
        edge: Edge,
        /// -w.n / D.n.
        t: Quotient,
    },
    /// The entry was compared with tE.
    Enter {
        /// The edge.
        edge: Edge,
        /// Whether it is later, and so the new tE.
        later: bool,
    },
    /// The exit was compared with tL.
    Leave {
        /// The edge.
        edge: Edge,
        /// Whether it is earlier, and so the new tL.
        earlier: bool,
    },
    /// tE was compared with tL.
    Order {
        /// Whether the visible part would begin after its end.
        crossed: bool,
    },
    /// Nothing is inside.
    Reject,
    /// An end was moved to the edge that cuts it off.
    Cut {
        /// The edge.
        edge: Edge,
        /// The end that moved.
        end: End,
        /// The new place.
        to: Point,
    },
    /// What is left is inside.
    Accept,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Clips a segment of finite coordinates against a convex window: `None` if no point of it is
/// inside.
///
/// The answer is exact: decided by exact signs, each cut coordinate correctly rounded. On an edge
/// that is parallel to an axis a cut end has the edge's coordinate bit for bit, and a cut end that
/// is a corner has the corner's bits; so with a rectangle the answer is bit for bit that of
/// [`cohen_sutherland`](super::cohen_sutherland). A segment of length zero is a point. Costs two
/// orientations and a quotient an edge.
pub fn clip(segment: Segment, window: &ConvexWindow) -> Option<Segment> {
    clip_traced(segment, window, Arithmetic::Exact, &mut Tally::default(), &mut NoTrace)
        .map(|visible| visible.segment)
}

/// [`clip`] in any arithmetic as a run that can be scrubbed.
pub fn play(
    segment: Segment,
    window: ConvexWindow,
    arithmetic: Arithmetic,
    budget: Budget,
) -> Player<Snapshot> {
    Player::new(Snapshot::new(segment, window.clone(), arithmetic), budget, move |t| {
        clip_traced(segment, &window, arithmetic, &mut Tally::default(), t);
    })
}

/// The algorithm: [`clip`] and [`play`] are this with two tracers.
///
/// `F32` and `F64` round the scalar products, t and both coordinates of a cut, as taught; they may
/// answer wrongly or with numbers that are not finite: showing that is what they are for. Fixed
/// point belongs to scan conversion; here it is the exact form. `tally` counts exact decisions.
pub fn clip_traced<T: Tracer<Event>>(
    segment: Segment,
    window: &ConvexWindow,
    arithmetic: Arithmetic,
    tally: &mut Tally,
    t: &mut T,
) -> Option<Visible> {
    match arithmetic {
        Arithmetic::F32 => clip_taught::<f32, T>(segment, window, t),
        Arithmetic::F64 => clip_taught::<f64, T>(segment, window, t),
        _ => run(Exact::new(segment, window, tally), t),
    }
}

/// As taught, in any rounded arithmetic: what [`clip_traced`] does for `F32` and `F64`.
pub fn clip_taught<R: Real, T: Tracer<Event>>(
    segment: Segment,
    window: &ConvexWindow,
    t: &mut T,
) -> Option<Visible> {
    run(Taught::<R>::new(segment, window), t)
}

/// The text of the algorithm, in any form of arithmetic.
fn run<F: Form, T: Tracer<Event>>(mut line: F, t: &mut T) -> Option<Visible> {
    let [mut enter, mut leave] = End::ALL.map(Parameter::Of);
    let mut visible = Visible { segment: line.given(), t: [0.0, 1.0] };
    t.emit(|| Event::Start);
    for edge in line.edges() {
        let here = Parameter::At(edge);
        let course = line.course(edge);
        t.emit(|| Event::Measure { edge, course });
        if course == Course::Parallel {
            let outside = line.outside(edge);
            t.emit(|| Event::Along { edge, outside });
            if outside {
                t.emit(|| Event::Reject);
                return None;
            }
            continue;
        }
        let at = line.divide(edge);
        t.emit(|| Event::Divide { edge, t: Quotient(at) });
        if course == Course::Enters {
            let later = line.order(here, enter) == Sign::Positive;
            t.emit(|| Event::Enter { edge, later });
            if later {
                (enter, visible.t[0]) = (here, at);
            }
        } else {
            let earlier = line.order(here, leave) == Sign::Negative;
            t.emit(|| Event::Leave { edge, earlier });
            if earlier {
                (leave, visible.t[1]) = (here, at);
            }
        }
    }
    let crossed = line.order(enter, leave) == Sign::Positive;
    t.emit(|| Event::Order { crossed });
    if crossed {
        t.emit(|| Event::Reject);
        return None;
    }
    for (end, parameter) in End::ALL.into_iter().zip([enter, leave]) {
        if let Parameter::At(edge) = parameter {
            let to = line.cut(edge);
            t.emit(|| Event::Cut { edge, end, to });
            visible.segment[end as usize] = to;
        }
    }
    t.emit(|| Event::Accept);
    Some(visible)
}
