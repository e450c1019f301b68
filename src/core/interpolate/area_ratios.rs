//! Interpolation by area ratios: what each vertex weighs, then the value, in perspective by one division.
//!
//! *Source:* Möbius, Der barycentrische Calcul, 1827; Heckbert and Moreton, Interpolation for Polygon
//! Texture Mapping and Shading, State of the Art in Computer Graphics, 1991, for `(a/w) / (1/w)`.
//! Deviation: whether there is a value at all is decided by exact signs in every arithmetic.

mod explain;
mod formulas;
mod picture;

pub use explain::Snapshot;

use super::{Barycentric, InterpolateError, Mode};
use crate::{
    explain::View,
    math::{Arithmetic, Field, Quotient, Tally},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use serde::Serialize;

/// A triangle with an attribute, and a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subject {
    /// Vertices (x, y, w): x and y in pixels, w of clip space.
    pub vertices: [[f32; 3]; 3],
    /// What the attribute is at each vertex.
    pub attribute: [f32; 3],
    /// The point, in pixels.
    pub at: [f32; 2],
}

impl Subject {
    /// The corners as they are weighed: snapped in fixed point.
    pub(super) fn points(&self, arithmetic: Arithmetic) -> [[f32; 2]; 3] {
        self.vertices.map(|[x, y, _]| [x, y].map(|coordinate| arithmetic.snap(coordinate)))
    }

    /// w at each vertex.
    pub(super) fn w(&self) -> [f32; 3] {
        self.vertices.map(|[_, _, w]| w)
    }
}

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// Twice the signed area of the triangle.
    Whole {
        /// In square pixels; positive if the vertices turn from x to y.
        area: f64,
    },
    /// Twice the signed area of the point and the edge opposite to a vertex.
    Part {
        /// Which vertex.
        vertex: u8,
        /// In square pixels.
        area: f64,
    },
    /// The ratio of both: what the vertex weighs.
    Share {
        /// Which vertex.
        vertex: u8,
        /// From 0 to 1 inside; all three add up to 1.
        l: f64,
    },
    /// The attribute over w at a vertex.
    Over {
        /// Which vertex.
        vertex: u8,
        /// a / w.
        value: f64,
    },
    /// One over w at a vertex.
    Reciprocal {
        /// Which vertex.
        vertex: u8,
        /// 1 / w.
        value: f64,
    },
    /// a/w at the point: it changes evenly on the screen.
    SumOver {
        /// The weighted sum.
        value: f64,
    },
    /// 1/w at the point: so does this.
    SumReciprocal {
        /// The weighted sum.
        value: f64,
    },
    /// The value: the weighted sum of the attribute, or in perspective the quotient of both sums.
    Value {
        /// How it was made.
        mode: Mode,
        /// What the attribute is at the point, rounded to binary32.
        value: f32,
    },
    /// There is none.
    Refused {
        /// Why.
        why: InterpolateError,
    },
}
const _: () = assert!(size_of::<Event>() <= 16);

/// What the attribute is at the point, or why it is nothing.
pub type Outcome = Result<f32, InterpolateError>;

/// Interpolates an attribute at a point of the closed triangle.
///
/// Coordinates are finite, and w is not 0 in perspective. Either winding. In exact arithmetic the
/// result is correctly rounded; it may be infinite only if w has both signs. `F32` and `F64` compute as
/// taught; fixed point snaps x and y and is exact then. Cost: about 50 ns, a few us in the
/// exact tail.
pub fn interpolate(mode: Mode, subject: &Subject, arithmetic: Arithmetic, tally: &mut Tally) -> Outcome {
    interpolate_traced(mode, subject, arithmetic, tally, &mut NoTrace)
}

/// [`interpolate`] as a run that can be scrubbed.
///
/// The drawing shows `view`.
pub fn play(
    mode: Mode,
    subject: Subject,
    arithmetic: Arithmetic,
    view: View,
    budget: Budget,
) -> Player<Snapshot> {
    Player::new(Snapshot::new(mode, subject, arithmetic, view), budget, move |t| {
        interpolate_traced(mode, &subject, arithmetic, &mut Tally::default(), t).ok();
    })
}

/// The algorithm: [`interpolate`] and [`play`] are this with two tracers.
///
/// `tally` counts exact decisions.
pub fn interpolate_traced<T: Tracer<Event>>(
    mode: Mode,
    subject: &Subject,
    arithmetic: Arithmetic,
    tally: &mut Tally,
    t: &mut T,
) -> Outcome {
    let exact = decide(mode, subject, arithmetic, tally);
    let refused = exact.err();
    let outcome = match arithmetic {
        Arithmetic::F32 => {
            run::<f32, T>(mode, subject, arithmetic, refused, t).map(|value| value.nearest_f32())
        }
        Arithmetic::F64 => {
            run::<f64, T>(mode, subject, arithmetic, refused, t).map(|value| value.nearest_f32())
        }
        _ => {
            if T::ENABLED {
                let rational = run::<Quotient, T>(mode, subject, arithmetic, refused, t);
                debug_assert_eq!(rational.map(|value| value.nearest_f32()), exact);
            }
            exact
        }
    };
    if let Ok(value) = outcome {
        t.emit(|| Event::Value { mode, value });
    }
    outcome
}

/// The exact value rounded once, or why there is none: nearly always found in binary64.
fn decide(mode: Mode, subject: &Subject, arithmetic: Arithmetic, tally: &mut Tally) -> Outcome {
    let (points, w) = (subject.points(arithmetic), subject.w());
    let Subject { attribute, at, .. } = *subject;
    let mut triangle = Barycentric::new(points, tally).ok_or(InterpolateError::ZeroArea)?;
    if !triangle.contains(at, tally) {
        return Err(InterpolateError::Outside);
    }
    if mode == Mode::Perspective {
        if w.contains(&0.0) {
            return Err(InterpolateError::ZeroW);
        }
        triangle = triangle.perspective(w);
        if triangle.at(at, tally).sum_sign(tally).is_zero() {
            return Err(InterpolateError::Infinite);
        }
    }
    Ok(match points.iter().position(|point| *point == at) {
        Some(vertex) => attribute[vertex],
        None => triangle.at(at, tally).value(attribute, tally),
    })
}

/// The text of the algorithm, in rounded or exact numbers; `refused` is what exact signs say.
fn run<N: Field, T: Tracer<Event>>(
    mode: Mode,
    subject: &Subject,
    arithmetic: Arithmetic,
    refused: Option<InterpolateError>,
    t: &mut T,
) -> Result<N, InterpolateError> {
    let stop_if = |why: InterpolateError, t: &mut T| {
        if refused != Some(why) {
            return Ok(());
        }
        t.emit(|| Event::Refused { why });
        Err(why)
    };
    let [v0, v1, v2] = subject.points(arithmetic).map(|point| point.map(N::of));
    let (a, p) = (subject.attribute.map(N::of), subject.at.map(N::of));
    let sum = |[x, y, z]: [N; 3]| x + y + z;
    let weigh = |l: &[N; 3], values: &[N; 3]| sum([0, 1, 2].map(|i| l[i].clone() * values[i].clone()));

    let whole = doubled_area(&v0, &v1, &v2);
    t.emit(|| Event::Whole { area: whole.nearest_f64() });
    stop_if(InterpolateError::ZeroArea, t)?;
    let parts = [doubled_area(&v1, &v2, &p), doubled_area(&v2, &v0, &p), doubled_area(&v0, &v1, &p)];
    for (part, vertex) in parts.iter().zip(0..) {
        t.emit(|| Event::Part { vertex, area: part.nearest_f64() });
    }
    stop_if(InterpolateError::Outside, t)?;
    let l = parts.map(|part| part / whole.clone());
    for (l, vertex) in l.iter().zip(0..) {
        t.emit(|| Event::Share { vertex, l: l.nearest_f64() });
    }
    if mode == Mode::Affine {
        return Ok(weigh(&l, &a));
    }
    stop_if(InterpolateError::ZeroW, t)?;
    let w = subject.w().map(N::of);
    let over = [0, 1, 2].map(|i| a[i].clone() / w[i].clone());
    for (over, vertex) in over.iter().zip(0..) {
        t.emit(|| Event::Over { vertex, value: over.nearest_f64() });
    }
    let reciprocal = w.map(|w| N::of(1.0) / w);
    for (reciprocal, vertex) in reciprocal.iter().zip(0..) {
        t.emit(|| Event::Reciprocal { vertex, value: reciprocal.nearest_f64() });
    }
    let over = weigh(&l, &over);
    t.emit(|| Event::SumOver { value: over.nearest_f64() });
    let reciprocal = weigh(&l, &reciprocal);
    t.emit(|| Event::SumReciprocal { value: reciprocal.nearest_f64() });
    stop_if(InterpolateError::Infinite, t)?;
    Ok(over / reciprocal)
}

/// Twice the signed area of a triangle.
fn doubled_area<N: Field>([ax, ay]: &[N; 2], [bx, by]: &[N; 2], [cx, cy]: &[N; 2]) -> N {
    let side = |from: &N, to: &N| to.clone() - from.clone();
    side(ax, bx) * side(ay, cy) - side(ay, by) * side(ax, cx)
}
