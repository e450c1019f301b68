//! Cohen-Sutherland line clipping: give each end a 4-bit code, then cut at one border at a time.
//!
//! *Source:* Newman and Sproull, Principles of Interactive Computer Graphics, 2nd ed. 1979,
//! section 5-1; Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 3.12.3.
//! Deviations: the first differing bit is cut first; in exact arithmetic codes and cuts come from
//! the original ends, so that nothing accumulates and the loop cannot run on.

mod explain;
mod forms;
mod formulas;

pub use explain::Snapshot;

use super::{Border, End, Mistake, Mistakes, Outcode, Point, Segment, Window};
use crate::{
    math::{Arithmetic, Real, Tally},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use forms::{Exact, Form, Taught};
use serde::Serialize;

/// In exact arithmetic each border is cut at most once, so four cuts are enough. Rounded
/// arithmetic can put a point back outside; after this many cuts it gives up.
pub const MOST_CUTS: usize = 8;

/// In what, and how wrongly, the algorithm computes; the default is exactly and rightly.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    /// What codes and cuts are computed in.
    pub arithmetic: Arithmetic,
    /// What is got wrong on purpose.
    pub mistakes: Mistakes,
}

impl From<Arithmetic> for Settings {
    fn from(arithmetic: Arithmetic) -> Self {
        Self { arithmetic, mistakes: Mistakes::NONE }
    }
}

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The outcode of one end was computed.
    Code {
        /// Which end.
        end: End,
        /// Its code.
        code: Outcode,
    },
    /// The codes were joined by OR: 0 means that both ends are inside.
    Or {
        /// The joined code.
        code: Outcode,
    },
    /// Both codes are 0: what is left is inside.
    Accept,
    /// The codes were joined by AND: anything but 0 means that both ends lie beyond one border.
    /// With [`Mistake::OrForAnd`] it is OR once more.
    And {
        /// The shared bits.
        code: Outcode,
    },
    /// The codes share a bit: nothing is inside.
    Reject,
    /// Rounding kept an end outside for [`MOST_CUTS`] cuts. Never in exact arithmetic.
    GiveUp,
    /// The first bit that differs names the border to cut at and the end beyond it.
    Choose {
        /// The border.
        border: Border,
        /// The end beyond it.
        end: End,
    },
    /// An end was moved to the border and got its new code.
    Cut {
        /// The border.
        border: Border,
        /// The end that moved.
        end: End,
        /// The code at the new place.
        code: Outcode,
        /// The new place.
        to: Point,
    },
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Clips a segment of finite coordinates against a window: `None` if no point of it is inside.
///
/// The answer is exact: decided by exact signs, each cut coordinate correctly rounded. A segment
/// of length zero is a point. This is the text that [`play`] plays, without a tracer;
/// [`line::clip`](super::clip) answers the same at once.
pub fn clip(segment: Segment, window: &Window) -> Option<Segment> {
    clip_traced(segment, window, Settings::default(), &mut Tally::default(), &mut NoTrace)
}

/// [`clip`] in any arithmetic as a run that can be scrubbed.
pub fn play(
    segment: Segment,
    window: Window,
    settings: impl Into<Settings>,
    budget: Budget,
) -> Player<Snapshot> {
    let settings = settings.into();
    Player::new(Snapshot::new(segment, window, settings), budget, move |t| {
        clip_traced(segment, &window, settings, &mut Tally::default(), t);
    })
}

/// The algorithm: [`clip`] and [`play`] are this with two tracers.
///
/// `F32` and `F64` compute as the lecture prints it, from the ends as they stand, and may answer
/// wrongly or with coordinates that are not finite: showing that is what they are for. Fixed point
/// belongs to scan conversion; here it is the exact form. `tally` counts exact decisions.
pub fn clip_traced<T: Tracer<Event>>(
    segment: Segment,
    window: &Window,
    settings: impl Into<Settings>,
    tally: &mut Tally,
    t: &mut T,
) -> Option<Segment> {
    let Settings { arithmetic, mistakes } = settings.into();
    match arithmetic {
        Arithmetic::F32 => clip_taught::<f32, T>(segment, window, mistakes, t),
        Arithmetic::F64 => clip_taught::<f64, T>(segment, window, mistakes, t),
        _ => run(Exact::new(segment, window, tally), mistakes, t),
    }
}

/// As taught, in any rounded arithmetic: what [`clip_traced`] does for `F32` and `F64`.
pub fn clip_taught<R: Real, T: Tracer<Event>>(
    segment: Segment,
    window: &Window,
    mistakes: Mistakes,
    t: &mut T,
) -> Option<Segment> {
    run(Taught::<R>::new(segment, window, mistakes), mistakes, t)
}

/// The text of the algorithm, in any form of arithmetic.
fn run<F: Form, T: Tracer<Event>>(mut ends: F, mistakes: Mistakes, t: &mut T) -> Option<Segment> {
    let mut codes = End::ALL.map(|end| {
        let code = ends.code(end);
        t.emit(|| Event::Code { end, code });
        code
    });
    if is_rejected(codes, mistakes, t) {
        return None;
    }
    for _ in 0..=MOST_CUTS {
        let [c1, c2] = codes;
        // Codes without a common bit that do not differ are both 0.
        let Some(border) = Outcode(c1.0 ^ c2.0).first() else {
            t.emit(|| Event::Accept);
            return Some(ends.segment());
        };
        let end = End::beyond(border, codes);
        t.emit(|| Event::Choose { border, end });
        let code = ends.cut(border, end);
        codes[end as usize] = code;
        t.emit(|| Event::Cut { border, end, code, to: ends.segment()[end as usize] });
        if is_rejected(codes, mistakes, t) {
            return None;
        }
    }
    t.emit(|| Event::GiveUp);
    None
}

/// Whether both ends lie beyond one border.
fn is_rejected<T: Tracer<Event>>([c1, c2]: [Outcode; 2], mistakes: Mistakes, t: &mut T) -> bool {
    let [or, and] = [Outcode(c1.0 | c2.0), Outcode(c1.0 & c2.0)];
    let and = if mistakes.has(Mistake::OrForAnd) { or } else { and };
    t.emit(|| Event::Or { code: or });
    if or.0 != 0 {
        t.emit(|| Event::And { code: and });
    }
    if and.0 != 0 {
        t.emit(|| Event::Reject);
    }
    and.0 != 0
}
