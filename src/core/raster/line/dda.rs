//! The DDA (digital differential analyser): add a constant step to x and y, round, draw.
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 3.2.1; Hearn and Baker,
//! Computer Graphics, 2nd ed., section 3-2. Deviation: in exact arithmetic nothing is accumulated, each
//! position is the start plus k steps as a ratio of whole numbers.

mod explain;

pub use explain::Snapshot;

use super::{Pixel, Segment, major_axis, on_image, pixel_of};
use crate::{
    math::{Arithmetic, Real},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use serde::Serialize;

/// What the algorithm did. At most 16 bytes. Whole coordinates are the centres of pixels here.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", rename_all_fields = "snake_case")]
pub enum Event {
    /// The differences of the ends were taken.
    Start {
        /// Of x, in pixels.
        dx: i32,
        /// Of y.
        dy: i32,
    },
    /// The greater one is the number of steps.
    Steps {
        /// How many.
        steps: u32,
    },
    /// What one step adds to a coordinate was computed.
    Increment {
        /// 0: x, 1: y.
        axis: u8,
        /// How much.
        by: f64,
    },
    /// A step was made: the coordinate that does not change by whole pixels is now this.
    Advance {
        /// As computed.
        to: f64,
    },
    /// The position was rounded to a pixel, and it was drawn if it is in the image.
    Plot {
        /// Its column.
        x: i32,
        /// Its row.
        y: i32,
        /// Whether the position lay exactly between two pixels.
        tie: bool,
    },
    /// All steps are made.
    Done,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Draws the line between two pixels, both included, within +-[`FARTHEST`](super::FARTHEST).
///
/// `emit` gets the pixels that are in the image, from the first end to the second. Equal ends give one pixel.
/// Cost: two additions and two roundings for each pixel, also off the image.
pub fn draw(ends: [Pixel; 2], size: [u32; 2], arithmetic: Arithmetic, emit: &mut impl FnMut([u32; 2])) {
    draw_traced(ends, size, arithmetic, &mut NoTrace, emit);
}

/// [`draw`] as a run that can be scrubbed; the ends are moved to the centres of their pixels.
pub fn play(given: Segment, size: [u32; 2], arithmetic: Arithmetic, budget: Budget) -> Player<Snapshot> {
    let ends = given.map(pixel_of);
    Player::new(Snapshot::new(given, size, arithmetic), budget, move |t| {
        draw_traced(ends, size, arithmetic, t, &mut |_| {});
    })
}

/// The algorithm: [`draw`] and [`play`] are this with two tracers.
///
/// `F32` and `F64` add as taught; rounding then decides ties, and drifts on a long line.
pub fn draw_traced<T: Tracer<Event>>(
    ends: [Pixel; 2],
    size: [u32; 2],
    arithmetic: Arithmetic,
    t: &mut T,
    emit: &mut impl FnMut([u32; 2]),
) {
    match arithmetic {
        Arithmetic::F32 => walk::<Taught<f32>, T>(ends, size, t, emit),
        Arithmetic::F64 => walk::<Taught<f64>, T>(ends, size, t, emit),
        _ => walk::<Exact, T>(ends, size, t, emit),
    }
}

/// The text of the algorithm, for coordinates of any kind.
fn walk<C: Coordinate, T: Tracer<Event>>(
    ends: [Pixel; 2],
    size: [u32; 2],
    t: &mut T,
    emit: &mut impl FnMut([u32; 2]),
) {
    let [[x0, y0], [x1, y1]] = ends;
    let (dx, dy) = (x1 - x0, y1 - y0);
    t.emit(|| Event::Start { dx, dy });
    let steps = dx.unsigned_abs().max(dy.unsigned_abs());
    t.emit(|| Event::Steps { steps });
    let mut position = [C::new(x0, dx, steps), C::new(y0, dy, steps)];
    if steps > 0 {
        t.emit(|| Event::Increment { axis: 0, by: position[0].increment() });
        t.emit(|| Event::Increment { axis: 1, by: position[1].increment() });
    }
    let minor = 1 - major_axis(ends);
    for step in 0..=steps {
        if step > 0 {
            position.iter_mut().for_each(C::advance);
            t.emit(|| Event::Advance { to: position[minor].value() });
        }
        let pixel = [position[0].rounded(), position[1].rounded()];
        t.emit(|| Event::Plot { x: pixel[0], y: pixel[1], tie: position[minor].is_tie() });
        if let Some(pixel) = on_image(pixel, size) {
            emit(pixel);
        }
    }
    t.emit(|| Event::Done);
}

/// A coordinate that grows by the same amount at each step; a half is rounded up.
trait Coordinate {
    /// From `start`, changing by `delta` in `steps` steps.
    fn new(start: i32, delta: i32, steps: u32) -> Self;
    /// What one step adds.
    fn increment(&self) -> f64;
    /// Makes a step.
    fn advance(&mut self);
    fn value(&self) -> f64;
    fn rounded(&self) -> i32;
    /// Whether it lies exactly between two whole numbers.
    fn is_tie(&self) -> bool;
}

/// As taught: the step is added, and every addition rounds.
struct Taught<R> {
    at: R,
    increment: R,
}

impl<R: Real> Coordinate for Taught<R> {
    fn new(start: i32, delta: i32, steps: u32) -> Self {
        // Whole and at most 2^17: exact. Adding zero turns -0 into 0.
        let increment = R::from_f32(delta as f32) / R::from_f32(steps as f32) + R::ZERO;
        Self { at: R::from_f32(start as f32), increment }
    }

    fn increment(&self) -> f64 {
        self.increment.to_f64()
    }

    fn advance(&mut self) {
        self.at = self.at + self.increment;
    }

    fn value(&self) -> f64 {
        self.at.to_f64()
    }

    fn rounded(&self) -> i32 {
        (self.at + R::ONE.half()).to_f64().floor() as i32
    }

    fn is_tie(&self) -> bool {
        self.value() - self.value().floor() == 0.5
    }
}

/// Exactly `start + step delta / steps`.
struct Exact {
    start: i32,
    delta: i32,
    steps: u32,
    step: u32,
}

impl Exact {
    /// Twice the distance from the start, times `steps`.
    fn twice(&self) -> i64 {
        2 * i64::from(self.step) * i64::from(self.delta)
    }
}

impl Coordinate for Exact {
    fn new(start: i32, delta: i32, steps: u32) -> Self {
        // Equal ends: no step is made.
        Self { start, delta, steps: steps.max(1), step: 0 }
    }

    fn increment(&self) -> f64 {
        f64::from(self.delta) / f64::from(self.steps) + 0.0
    }

    fn advance(&mut self) {
        self.step += 1;
    }

    fn value(&self) -> f64 {
        let moved = self.twice() as f64 / (2.0 * f64::from(self.steps));
        f64::from(self.start) + moved
    }

    fn rounded(&self) -> i32 {
        let steps = i64::from(self.steps);
        self.start + (self.twice() + steps).div_euclid(2 * steps) as i32
    }

    fn is_tie(&self) -> bool {
        (self.twice() + i64::from(self.steps)).rem_euclid(2 * i64::from(self.steps)) == 0
    }
}
