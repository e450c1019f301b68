//! Midpoint subdivision: halve towards each end of the visible part; no product, no quotient.
//!
//! Towards an end that lies outside, the last visible point is sought between A, the other end,
//! and E, the end itself. Of the two halves, the far one is dropped if both its ends lie beyond
//! one border: then nothing in it is visible. Else the search goes on in it.
//!
//! *Source:* Sproull and Sutherland, A Clipping Divider, AFIPS Fall Joint Computer Conference
//! 1968; Rogers, Procedural Elements for Computer Graphics, 2nd ed. 1998, section 3-4. Deviations:
//! both searches start from the given ends, so that the order of the ends cannot matter; a search
//! ends when A and E are neighbours in binary32, not pixels; and in exact arithmetic a midpoint
//! is never rounded, and a line that has not shown a visible point by then is decided by exact
//! signs.

mod explain;
mod forms;

pub use explain::Snapshot;

use super::{End, Outcode, Point, Segment, Window};
use crate::{
    math::{Arithmetic, Real, Tally},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use forms::{Exact, Form, Taught};
use serde::Serialize;

/// No search needs more halvings: a difference of two binary32 numbers is below 2^129, and after
/// 280 halvings below 2^-151. That is a quarter of the smallest step, 2^-149, so that A and E
/// cannot round to numbers further apart than neighbours. Rounded arithmetic stops here, too.
pub const MOST_HALVINGS: usize = 280;

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
    /// The codes were joined by AND: anything but 0 means that both ends lie beyond one border.
    And {
        /// The shared bits.
        code: Outcode,
    },
    /// The last visible point towards an end is sought: A is the other end, E this one.
    Search {
        /// The end that will move.
        end: End,
    },
    /// M was put half-way between A and E.
    Halve {
        /// Its code.
        code: Outcode,
        /// Where it is, rounded.
        to: Point,
    },
    /// M and E lie beyond one border: the half between them is dropped, E becomes M.
    Drop,
    /// The half from M to E may hold the last visible point: A becomes M.
    Keep,
    /// What is left between A and E lies beyond one border.
    Lost {
        /// The shared bits.
        code: Outcode,
    },
    /// A and E are neighbours.
    Close {
        /// Whether there is a visible point.
        visible: bool,
    },
    /// An end was moved to the last visible point.
    Move {
        /// Which end.
        end: End,
        /// Its new place.
        to: Point,
    },
    /// What is left is inside.
    Accept,
    /// Nothing is inside.
    Reject,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Clips a segment of finite coordinates against a window: `None` if no point of it is inside.
///
/// Whether something is visible is decided exactly; ends that lie inside stay bit for bit; each
/// coordinate of a cut end lies in the window and within one step of binary32 of the exact one.
/// The order of the ends does not matter. A segment of length zero is a point. Costs about 25
/// halvings for an end that is cut, at most [`MOST_HALVINGS`].
pub fn clip(segment: Segment, window: &Window) -> Option<Segment> {
    clip_traced(segment, window, Arithmetic::Exact, &mut Tally::default(), &mut NoTrace)
}

/// [`clip`] in any arithmetic as a run that can be scrubbed.
pub fn play(segment: Segment, window: Window, arithmetic: Arithmetic, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(segment, window, arithmetic), budget, move |t| {
        clip_traced(segment, &window, arithmetic, &mut Tally::default(), t);
    })
}

/// The algorithm: [`clip`] and [`play`] are this with two tracers.
///
/// `F32` and `F64` round every midpoint, as taught: the halves bend, a touched corner is missed,
/// and a sum that overflows loses the line. Fixed point belongs to scan conversion; here it is the
/// exact form. `tally` counts midpoints, and those that no binary64 number holds.
pub fn clip_traced<T: Tracer<Event>>(
    segment: Segment,
    window: &Window,
    arithmetic: Arithmetic,
    tally: &mut Tally,
    t: &mut T,
) -> Option<Segment> {
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
) -> Option<Segment> {
    run(Taught::<R>::new(segment, window), t)
}

/// The text of the algorithm, in any form of arithmetic.
fn run<F: Form, T: Tracer<Event>>(mut line: F, t: &mut T) -> Option<Segment> {
    let codes = End::ALL.map(|end| {
        let code = line.code(end);
        t.emit(|| Event::Code { end, code });
        code
    });
    let [c1, c2] = codes.map(|code| code.0);
    t.emit(|| Event::Or { code: Outcode(c1 | c2) });
    if c1 | c2 == 0 {
        t.emit(|| Event::Accept);
        return Some(line.given());
    }
    t.emit(|| Event::And { code: Outcode(c1 & c2) });
    if c1 & c2 != 0 {
        t.emit(|| Event::Reject);
        return None;
    }
    let mut visible = line.given();
    for end in [End::P2, End::P1] {
        let [mut near, mut far] = [end.other(), end].map(|end| codes[end as usize].0);
        if far == 0 {
            continue;
        }
        t.emit(|| Event::Search { end });
        line.search(end);
        for _ in 0..MOST_HALVINGS {
            if line.is_closed() {
                break;
            }
            let (to, code) = line.halve();
            t.emit(|| Event::Halve { code, to });
            if code.0 & far == 0 {
                near = code.0;
                line.keep();
                t.emit(|| Event::Keep);
                continue;
            }
            far = code.0;
            line.drop();
            t.emit(|| Event::Drop);
            if near & far != 0 {
                t.emit(|| Event::Lost { code: Outcode(near & far) });
                t.emit(|| Event::Reject);
                return None;
            }
        }
        let found = near == 0 || line.touches();
        t.emit(|| Event::Close { visible: found });
        if !found {
            t.emit(|| Event::Reject);
            return None;
        }
        let to = line.found();
        t.emit(|| Event::Move { end, to });
        visible[end as usize] = to;
    }
    t.emit(|| Event::Accept);
    Some(visible)
}
