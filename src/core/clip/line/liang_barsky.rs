//! Liang-Barsky line clipping: four parameters along the line, put in order; divide only to cut.
//!
//! With `x = x1 + t (x2 - x1)` (and y alike), a point lies inside a border if `t p <= q`. The
//! line enters where p < 0 and leaves where p > 0, both at `t = q / p`. The visible part begins at
//! the last entry and ends at the first exit; if it would begin after its end, nothing is visible.
//!
//! *Source:* Liang and Barsky, A New Concept and Method for Line Clipping, ACM Transactions on
//! Graphics 3(1), 1984. Deviations: fractions are compared without dividing, in exact arithmetic
//! by an orientation; the borders are taken in the order of an outcode, so that a line through a
//! corner is cut at the same border as by Cohen-Sutherland.

mod explain;
mod forms;
mod formulas;

pub use super::{Course, Parameter, Visible};
pub use explain::Snapshot;

use super::{Border, End, Point, Segment, Window};
use crate::{
    math::{Arithmetic, Real, Sign, Tally},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use forms::{Exact, Form, Taught};
use serde::Serialize;

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The visible part is the whole segment so far.
    Start,
    /// The sign of p at a border was found.
    Measure {
        /// The border.
        border: Border,
        /// What the line does there.
        course: Course,
    },
    /// The line is parallel to the border: q < 0 means that it lies beyond it.
    Along {
        /// The border.
        border: Border,
        /// Whether it lies beyond.
        outside: bool,
    },
    /// The entry was compared with t0.
    Enter {
        /// The border.
        border: Border,
        /// Whether it is later, and so the new t0.
        later: bool,
    },
    /// The exit was compared with t1.
    Leave {
        /// The border.
        border: Border,
        /// Whether it is earlier, and so the new t1.
        earlier: bool,
    },
    /// t0 was compared with t1.
    Order {
        /// Whether the visible part would begin after its end.
        crossed: bool,
    },
    /// Nothing is inside.
    Reject,
    /// A quotient was computed: the only division there is.
    Divide {
        /// The border that cuts.
        border: Border,
        /// The end that it cuts off.
        end: End,
        /// q / p.
        t: f32,
    },
    /// An end was moved to the border.
    Cut {
        /// The border.
        border: Border,
        /// The end that moved.
        end: End,
        /// The new place.
        to: Point,
    },
    /// What is left is inside.
    Accept,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Clips a segment of finite coordinates against a window: `None` if no point of it is inside.
///
/// The answer is exact, and bit for bit that of [`cohen_sutherland`](super::cohen_sutherland). A
/// segment of length zero is a point. Costs at most five orientations, and for each cut two
/// quotients; none if nothing is visible.
pub fn clip(segment: Segment, window: &Window) -> Option<Segment> {
    clip_traced(segment, window, Arithmetic::Exact, &mut Tally::default(), &mut NoTrace)
        .map(|visible| visible.segment)
}

/// [`clip`] in any arithmetic as a run that can be scrubbed.
pub fn play(segment: Segment, window: Window, arithmetic: Arithmetic, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(segment, window, arithmetic), budget, move |t| {
        clip_traced(segment, &window, arithmetic, &mut Tally::default(), t);
    })
}

/// The algorithm: [`clip`] and [`play`] are this with two tracers.
///
/// `F32` and `F64` round p, q, their products and t, and compute both coordinates of a cut from t,
/// as the paper does; they may answer wrongly or with numbers that are not finite: showing that is
/// what they are for. Fixed point belongs to scan conversion; here it is the exact form, which
/// rounds t and the cut coordinate once each, so a cut has two quotients. `tally` counts exact
/// decisions.
pub fn clip_traced<T: Tracer<Event>>(
    segment: Segment,
    window: &Window,
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
    window: &Window,
    t: &mut T,
) -> Option<Visible> {
    run(Taught::<R>::new(segment, window), t)
}

/// The text of the algorithm, in any form of arithmetic.
fn run<F: Form, T: Tracer<Event>>(mut line: F, t: &mut T) -> Option<Visible> {
    let [mut t0, mut t1] = End::ALL.map(Parameter::Of);
    t.emit(|| Event::Start);
    for border in Border::ALL {
        let here = Parameter::At(border);
        let course = line.course(border);
        t.emit(|| Event::Measure { border, course });
        let shorter = match course {
            Course::Parallel => {
                let outside = line.outside(border);
                t.emit(|| Event::Along { border, outside });
                if outside {
                    t.emit(|| Event::Reject);
                    return None;
                }
                false
            }
            Course::Enters => {
                let later = line.order(here, t0) == Sign::Positive;
                t.emit(|| Event::Enter { border, later });
                t0 = if later { here } else { t0 };
                later
            }
            Course::Leaves => {
                let earlier = line.order(here, t1) == Sign::Negative;
                t.emit(|| Event::Leave { border, earlier });
                t1 = if earlier { here } else { t1 };
                earlier
            }
        };
        if shorter {
            let crossed = line.order(t0, t1) == Sign::Positive;
            t.emit(|| Event::Order { crossed });
            if crossed {
                t.emit(|| Event::Reject);
                return None;
            }
        }
    }
    let mut visible = Visible { segment: line.given(), t: [0.0, 1.0] };
    for (end, parameter) in End::ALL.into_iter().zip([t0, t1]) {
        if let Parameter::At(border) = parameter {
            let at = line.divide(border);
            t.emit(|| Event::Divide { border, end, t: at.to_f32() });
            let to = line.cut(border, at);
            t.emit(|| Event::Cut { border, end, to });
            visible.t[end as usize] = at.to_f32();
            visible.segment[end as usize] = to;
        }
    }
    t.emit(|| Event::Accept);
    Some(visible)
}
