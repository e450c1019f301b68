//! Bresenham's line: one whole number, kept by additions, says when to step aside.
//!
//! *Source:* Bresenham, Algorithm for Computer Control of a Digital Plotter, IBM Systems Journal 4, 1965;
//! Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 3.2.2 (the midpoint form).
//! Deviations: all eight octants in one text; of two equally near pixels the right or lower one is taken,
//! whichever end is the first, so that a line is the same backwards.

mod explain;

pub use explain::Snapshot;

use super::{Pixel, Segment, major_axis, on_image, pixel_of};
use crate::{
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use serde::Serialize;

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", rename_all_fields = "snake_case")]
pub enum Event {
    /// The distances of the ends were taken.
    Start {
        /// Along x, not negative.
        dx: u32,
        /// Along y, not negative.
        dy: u32,
    },
    /// The decision variable has its first value.
    Decision {
        /// `2 minor - major`.
        d: i64,
    },
    /// A step along the major axis was made.
    Step {
        /// Whether it went aside as well, by one pixel along the minor axis.
        aside: bool,
        /// The decision variable for the next step.
        d: i64,
    },
    /// The pixel was drawn if it is in the image.
    Plot {
        /// Its column.
        x: i32,
        /// Its row.
        y: i32,
    },
    /// All steps are made.
    Done,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Draws the line between two pixels, both included; any pixels.
///
/// `emit` gets the pixels that are in the image, from the first end to the second: one for each column, or for
/// each row if the line is steep, each the nearest to the line between the two centres. Equal ends give one
/// pixel. Cost: an addition and a comparison for each pixel, also off the image.
pub fn draw(ends: [Pixel; 2], size: [u32; 2], emit: &mut impl FnMut([u32; 2])) {
    draw_traced(ends, size, &mut NoTrace, emit);
}

/// [`draw`] as a run that can be scrubbed; the ends are moved to the centres of their pixels.
pub fn play(given: Segment, size: [u32; 2], budget: Budget) -> Player<Snapshot> {
    let ends = given.map(pixel_of);
    Player::new(Snapshot::new(given, size), budget, move |t| draw_traced(ends, size, t, &mut |_| {}))
}

/// The algorithm: [`draw`] and [`play`] are this with two tracers.
pub fn draw_traced<T: Tracer<Event>>(
    ends: [Pixel; 2],
    size: [u32; 2],
    t: &mut T,
    emit: &mut impl FnMut([u32; 2]),
) {
    let [from, to] = ends;
    let lengths = [0, 1].map(|axis| from[axis].abs_diff(to[axis]));
    t.emit(|| Event::Start { dx: lengths[0], dy: lengths[1] });
    let major_axis = major_axis(ends);
    let minor_axis = 1 - major_axis;
    let (major, minor) = (i64::from(lengths[major_axis]), i64::from(lengths[minor_axis]));
    let towards = |axis: usize| if to[axis] > from[axis] { 1 } else { -1 };
    // d > 0: the line passes beyond the point midway between the two pixels that come into question.
    let mut d = 2 * minor - major;
    t.emit(|| Event::Decision { d });
    let tie_goes_aside = towards(minor_axis) > 0;
    let mut pixel = from;
    for step in 0..=lengths[major_axis] {
        if step > 0 {
            let aside = d > 0 || d == 0 && tie_goes_aside;
            pixel[major_axis] += towards(major_axis);
            if aside {
                pixel[minor_axis] += towards(minor_axis);
                d -= 2 * major;
            }
            d += 2 * minor;
            t.emit(|| Event::Step { aside, d });
        }
        t.emit(|| Event::Plot { x: pixel[0], y: pixel[1] });
        if let Some(pixel) = on_image(pixel, size) {
            emit(pixel);
        }
    }
    t.emit(|| Event::Done);
}
