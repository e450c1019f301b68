//! Exact signs and correctly rounded quotients: the numbers every later stage stands on.
//!
//! All inputs are finite binary32 numbers. Two kinds of question are answered without error: *on which
//! side?* ([`orient2d`], [`orient3d_homogeneous`]) and *which is the nearest f32 or unorm code?*
//! ([`rounded_ratio`], [`rounded_code`]). Both work alike:
//!
//! 1. **Filter.** Compute in f64, together with a proven bound of the error ([`Approx`]). Nearly always
//!    the bound leaves one answer.
//! 2. **Exact tail.** Otherwise compute without rounding: a sign by a floating-point [`Expansion`] on the
//!    stack, a rounding by a big-integer [`Dyadic`]. A [`Tally`] counts how often that was needed.
//!
//! So the answer is always that of real arithmetic, and the cost is nearly that of f64. Nothing here
//! fuses a multiplication with an addition, and nothing reads or writes a global: the same input gives
//! the same bits on every machine.
//!
//! ```
//! use rasterscope_core::math::{Sign, Tally, orient2d};
//!
//! let mut tally = Tally::default();
//! let huge = f32::MAX;
//! // In f32 the products overflow and the answer would be NaN.
//! assert_eq!(orient2d([-huge, -huge], [huge, huge], [0.0, 1e-45], &mut tally), Sign::Positive);
//! assert_eq!(orient2d([-huge, -huge], [huge, huge], [0.0, 0.0], &mut tally), Sign::Zero);
//! ```

pub mod approx;
pub mod arithmetic;
pub mod dyadic;
pub mod expansion;
mod nearest;
pub mod predicates;
pub mod quotient;
pub mod rounding;
pub mod sign;
pub mod tally;
pub mod ulp;

#[cfg(test)]
mod testing;

pub use approx::Approx;
pub(crate) use approx::UNIT_ROUNDOFF;
pub use arithmetic::{Arithmetic, Real};
pub use dyadic::Dyadic;
pub use expansion::Expansion;
pub use predicates::{edge_value, orient2d, orient3d_homogeneous};
pub use quotient::{Field, Quotient};
pub use rounding::{round_to_f32, rounded_code, rounded_ratio};
pub use sign::Sign;
pub use tally::Tally;
pub use ulp::{next_down, next_up, ulps_between};
