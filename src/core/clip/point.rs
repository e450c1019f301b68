//! Point clipping: four comparisons with the borders of a window, one bit each.
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 3.12.1.
//! Deviation: all four comparisons are made, also after one has failed, so that the bits say in
//! which of the nine regions the point lies.

mod explain;

pub use explain::Snapshot;

use super::line::{Border, Outcode, Point, Window};
use crate::{
    math::{Arithmetic, Real},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use serde::Serialize;

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The point was compared with a border.
    Compare {
        /// The border.
        border: Border,
        /// Whether the point lies beyond it.
        beyond: bool,
    },
    /// All bits are 0.
    Accept,
    /// Some bit is 1.
    Reject,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Whether a point of finite coordinates lies in the closed window: on a border it does. Exact in
/// every arithmetic, since it only compares.
pub fn is_visible(point: Point, window: &Window) -> bool {
    clip_traced(point, window, Arithmetic::Exact, &mut NoTrace)
}

/// [`is_visible`] as a run that can be scrubbed.
pub fn play(point: Point, window: Window, arithmetic: Arithmetic, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(point, window), budget, move |t| {
        clip_traced(point, &window, arithmetic, t);
    })
}

/// The algorithm: [`is_visible`] and [`play`] are this with two tracers.
pub fn clip_traced<T: Tracer<Event>>(
    point: Point,
    window: &Window,
    arithmetic: Arithmetic,
    t: &mut T,
) -> bool {
    match arithmetic {
        // The given numbers are binary32, so that nothing is rounded before it is compared.
        Arithmetic::F64 => clip_taught::<f64, T>(point, window, t),
        _ => clip_taught::<f32, T>(point, window, t),
    }
}

/// The algorithm in any arithmetic: all give the same answer.
pub fn clip_taught<R: Real, T: Tracer<Event>>(point: Point, window: &Window, t: &mut T) -> bool {
    let [x, y] = point.map(R::from_f32);
    let bits = Border::ALL.map(|border| {
        let side = R::from_f32(window.at(border));
        let beyond = match border {
            Border::Top => y > side,
            Border::Bottom => y < side,
            Border::Right => x > side,
            Border::Left => x < side,
        };
        t.emit(|| Event::Compare { border, beyond });
        beyond
    });
    let visible = Outcode::from_bits(bits) == Outcode::default();
    t.emit(|| if visible { Event::Accept } else { Event::Reject });
    visible
}
