//! How far apart two depths must be to differ in the buffer, and where two planes become one.
//!
//! All distances with one code are a stretch of the line of sight: its length is the step of depth there.
//! Two planes across the line of sight, a gap apart, can share a code where the step exceeds the gap.
//!
//! *Source:* Akeley and Su, Minimum Triangle Separation for Correct z-Buffer Occlusion, 2006; Reed, Depth
//! Precision Visualized, 2015. Deviation: nothing of the transform is rounded, only the depth to its code.

mod cell;
mod explain;
mod picture;
mod snapshot;

pub use cell::{Cell, Line};
pub use snapshot::Snapshot;

use crate::{
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use serde::Serialize;

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The last code of a range in which steps only grow was looked at.
    Range {
        /// Its place, counted from the near plane.
        place: u32,
        /// Whether its step exceeds the gap.
        merges: bool,
    },
    /// The code in the middle of what is left was looked at.
    Halve {
        /// Its place.
        place: u32,
        /// Whether its step exceeds the gap.
        merges: bool,
    },
    /// The first code whose step exceeds the gap.
    Found {
        /// Its place.
        place: u32,
    },
    /// No step exceeds the gap.
    Never,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// The first code, from the near plane on, whose step exceeds `gap`, a distance in world units: from its
/// near end on, two planes so far apart can have the same depth. `None` if no step does.
///
/// Exact for the near and far plane and the gap given. Cost: some 40 us; 1 ms for reversed floats, whose
/// steps grow in each of some 150 ranges by itself.
pub fn first_merge(line: &Line, gap: f32) -> Option<u32> {
    first_merge_traced(line, gap, &mut NoTrace)
}

/// [`first_merge`] as a run that can be scrubbed.
pub fn play(line: Line, gap: f32, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(line, gap), budget, move |t| {
        first_merge_traced(&line, gap, t);
    })
}

/// The algorithm: [`first_merge`] and [`play`] are this with two tracers.
pub fn first_merge_traced<T: Tracer<Event>>(line: &Line, gap: f32, t: &mut T) -> Option<u32> {
    for [mut first, mut last] in line.ranges() {
        let merges = line.cell(last).exceeds(gap);
        t.emit(|| Event::Range { place: last, merges });
        if !merges {
            continue;
        }
        while first < last {
            let place = first + (last - first) / 2;
            let merges = line.cell(place).exceeds(gap);
            t.emit(|| Event::Halve { place, merges });
            if merges {
                last = place;
            } else {
                first = place + 1;
            }
        }
        t.emit(|| Event::Found { place: first });
        return Some(first);
    }
    t.emit(|| Event::Never);
    None
}
