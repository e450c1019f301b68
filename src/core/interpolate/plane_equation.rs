//! Interpolation by the plane equation: a value is a plane over the screen, so the next pixel costs one addition.
//!
//! `A x + B y + C q + D = 0` gives `q = (-A x - B y - D) / C`, and `q - A/C` for the next pixel. In perspective
//! a/w and 1/w are such planes, the attribute itself is not.
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 15.4, for the plane stepped
//! along a row; Blinn, Hyperbolic Interpolation, 1992, for a/w and 1/w. Deviation: in exact arithmetic nothing is
//! lost from pixel to pixel, since the sum of steps is a rational number.

mod explain;
mod formulas;
mod tables;

pub use explain::Snapshot;

use super::{InterpolateError, Mode, Subject, interpolate};
use crate::{
    math::{Arithmetic, Field, Quotient, Tally},
    raster::{self, Algorithm, Settings, Span, edge::centre},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use serde::Serialize;

/// What is a plane over the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// The attribute itself, affine.
    Value,
    /// The attribute over w.
    Over,
    /// One over w.
    Reciprocal,
}

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The row has these pixels.
    Row {
        /// The row.
        y: u32,
        /// First column.
        begin: u32,
        /// One past the last column.
        end: u32,
    },
    /// A component of the plane's normal: A, B or C.
    Normal {
        /// Which plane.
        quantity: Quantity,
        /// 0 is A.
        axis: u8,
        /// The component.
        value: f64,
    },
    /// D.
    Offset {
        /// Which plane.
        quantity: Quantity,
        /// The constant.
        value: f64,
    },
    /// What is added from pixel to pixel: -A/C along x, -B/C along y.
    Slope {
        /// Which plane.
        quantity: Quantity,
        /// 0 is x.
        axis: u8,
        /// The slope.
        value: f64,
    },
    /// The plane's value at the first centre of the row.
    Start {
        /// Which plane.
        quantity: Quantity,
        /// The pixel's column; images have at most 16384.
        x: u16,
        /// The value.
        value: f64,
    },
    /// The value at the next centre: one addition.
    Step {
        /// Which plane.
        quantity: Quantity,
        /// The pixel's column.
        x: u16,
        /// The sum.
        value: f64,
    },
    /// What the pixel gets, rounded to binary32; in perspective the quotient of both planes.
    Value {
        /// The pixel's column.
        x: u16,
        /// How it was made.
        mode: Mode,
        /// The value.
        value: f32,
    },
    /// There is nothing to fill in.
    Refused {
        /// Why; `Outside`: the row has no pixel.
        why: InterpolateError,
    },
    /// The row is done.
    Done,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// The pixels of the row, each with its value.
pub type Pixels = Vec<(u32, f32)>;

/// The row of pixels through the subject's point: the covered ones, from left to right, with their values.
///
/// Coordinates are finite, either winding; nothing of no area, nor off the image; in perspective nothing if a
/// w is 0. In exact arithmetic each value is correctly rounded; `F32` and `F64` add one slope a pixel. Cost:
/// about 50 ns a pixel.
pub fn fill_row(mode: Mode, subject: &Subject, arithmetic: Arithmetic, settings: &Settings) -> Pixels {
    fill_row_traced(mode, subject, arithmetic, settings, &mut Tally::default(), &mut NoTrace)
}

/// [`fill_row`] as a run that can be scrubbed.
pub fn play(
    mode: Mode,
    subject: Subject,
    arithmetic: Arithmetic,
    settings: Settings,
    budget: Budget,
) -> Player<Snapshot> {
    Player::new(Snapshot::new(mode, subject, arithmetic, settings), budget, move |t| {
        fill_row_traced(mode, &subject, arithmetic, &settings, &mut Tally::default(), t);
    })
}

/// The algorithm: [`fill_row`] and [`play`] are this with two tracers.
///
/// `tally` counts exact decisions.
pub fn fill_row_traced<T: Tracer<Event>>(
    mode: Mode,
    subject: &Subject,
    arithmetic: Arithmetic,
    settings: &Settings,
    tally: &mut Tally,
    t: &mut T,
) -> Pixels {
    let row = match row_of(mode, subject, arithmetic, settings, tally) {
        Ok(row) => row,
        Err(why) => {
            t.emit(|| Event::Refused { why });
            return Vec::new();
        }
    };
    t.emit(|| Event::Row { y: row.y, begin: row.begin, end: row.end });
    let mut pixels = Vec::with_capacity(row.len() as usize);
    match arithmetic {
        Arithmetic::F32 => run::<f32, T>(mode, subject, arithmetic, row, t, |x, value| {
            pixels.push((x, value));
            value
        }),
        Arithmetic::F64 => run::<f64, T>(mode, subject, arithmetic, row, t, |x, value| {
            pixels.push((x, value.nearest_f32()));
            value.nearest_f32()
        }),
        _ => {
            let exact = |x: u32, tally: &mut Tally| {
                let [w0, w1, w2] = subject.w();
                let [p0, p1, p2] = subject.points(arithmetic);
                let vertices = [[p0[0], p0[1], w0], [p1[0], p1[1], w1], [p2[0], p2[1], w2]];
                // A centre that the row has lies inside; its value may be infinite where w has both signs.
                interpolate(mode, vertices, subject.attribute, centre(x, row.y), Arithmetic::Exact, tally)
                    .unwrap_or(f32::INFINITY)
            };
            if T::ENABLED {
                run::<Quotient, T>(mode, subject, arithmetic, row, t, |x, rational| {
                    let value = exact(x, tally);
                    debug_assert!(value.is_infinite() || rational.nearest_f32() == value);
                    pixels.push((x, value));
                    value
                });
            } else {
                pixels.extend((row.begin..row.end).map(|x| (x, exact(x, tally))));
            }
        }
    }
    t.emit(|| Event::Done);
    pixels
}

/// The covered pixels of the row that the point lies in.
fn row_of(
    mode: Mode,
    subject: &Subject,
    arithmetic: Arithmetic,
    settings: &Settings,
    tally: &mut Tally,
) -> Result<Span, InterpolateError> {
    let points = subject.points(arithmetic);
    let [a, b, c] = points;
    if crate::math::orient2d(a, b, c, tally).is_zero() {
        return Err(InterpolateError::ZeroArea);
    }
    if mode == Mode::Perspective && subject.w().contains(&0.0) {
        return Err(InterpolateError::ZeroW);
    }
    let settings = Settings { arithmetic: Arithmetic::Exact, ..*settings };
    let mut found = None;
    let y = subject.at[1].floor();
    raster::cover(Algorithm::Scanline, points, &settings, tally, &mut |span| {
        if span.y as f32 == y {
            found = Some(span);
        }
    });
    found.ok_or(InterpolateError::Outside)
}

/// A plane, and its value at the pixel in hand.
struct Plane<N> {
    quantity: Quantity,
    dq_dx: N,
    value: N,
}

/// The text of the algorithm, in rounded or exact numbers; `write` takes the value of each pixel, and says
/// what is stored.
fn run<N: Field, T: Tracer<Event>>(
    mode: Mode,
    subject: &Subject,
    arithmetic: Arithmetic,
    row: Span,
    t: &mut T,
    mut write: impl FnMut(u32, N) -> f32,
) {
    let points = subject.points(arithmetic).map(|point| point.map(N::of));
    let (a, w) = (subject.attribute.map(N::of), subject.w().map(N::of));
    let start = centre(row.begin, row.y).map(N::of);
    let over = |i: usize| a[i].clone() / w[i].clone();
    let reciprocal = |i: usize| N::of(1.0) / w[i].clone();
    let mut planes = match mode {
        Mode::Affine => vec![plane(Quantity::Value, &points, &a, &start, row.begin, t)],
        Mode::Perspective => vec![
            plane(Quantity::Over, &points, &[0, 1, 2].map(over), &start, row.begin, t),
            plane(Quantity::Reciprocal, &points, &[0, 1, 2].map(reciprocal), &start, row.begin, t),
        ],
    };
    for x in row.begin..row.end {
        if x > row.begin {
            for plane in &mut planes {
                plane.value = plane.value.clone() + plane.dq_dx.clone();
                let (quantity, value) = (plane.quantity, plane.value.nearest_f64());
                t.emit(|| Event::Step { quantity, x: x as u16, value });
            }
        }
        let value = match &planes[..] {
            [over, reciprocal] => over.value.clone() / reciprocal.value.clone(),
            [first, ..] => first.value.clone(),
            [] => return,
        };
        let value = write(x, value);
        t.emit(|| Event::Value { x: x as u16, mode, value });
    }
}

/// The plane through three points (x, y, q), and its value at a centre.
fn plane<N: Field, T: Tracer<Event>>(
    quantity: Quantity,
    points: &[[N; 2]; 3],
    q: &[N; 3],
    [x, y]: &[N; 2],
    column: u32,
    t: &mut T,
) -> Plane<N> {
    let [[x0, y0], [x1, y1], [x2, y2]] = points;
    let side = |from: &N, to: &N| to.clone() - from.clone();
    let [dx1, dy1, dq1] = [side(x0, x1), side(y0, y1), side(&q[0], &q[1])];
    let [dx2, dy2, dq2] = [side(x0, x2), side(y0, y2), side(&q[0], &q[2])];
    let minor = |a: &N, b: &N, c: &N, d: &N| a.clone() * d.clone() - b.clone() * c.clone();
    let normal =
        [minor(&dy1, &dq1, &dy2, &dq2), minor(&dq1, &dx1, &dq2, &dx2), minor(&dx1, &dy1, &dx2, &dy2)];
    for (component, axis) in normal.iter().zip(0..) {
        t.emit(|| Event::Normal { quantity, axis, value: component.nearest_f64() });
    }
    let [a, b, c] = normal;
    let d = -(a.clone() * x0.clone() + b.clone() * y0.clone() + c.clone() * q[0].clone());
    t.emit(|| Event::Offset { quantity, value: d.nearest_f64() });
    let slopes = [-a.clone() / c.clone(), -b.clone() / c.clone()];
    for (slope, axis) in slopes.iter().zip(0..) {
        t.emit(|| Event::Slope { quantity, axis, value: slope.nearest_f64() });
    }
    let value = (-(a * x.clone()) - b * y.clone() - d) / c;
    t.emit(|| Event::Start { quantity, x: column as u16, value: value.nearest_f64() });
    let [dq_dx, _] = slopes;
    Plane { quantity, dq_dx, value }
}
