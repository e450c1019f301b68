//! A point primitive: the pixels whose centres lie in a square around it.
//!
//! Coordinates are pixels, centres at + 0.5, y down. The left and the upper side of the square count, the
//! right and the lower side do not: so a point of size 1 draws exactly one pixel, wherever it lies.
//!
//! *Source:* Direct3D 11.3 functional specification, section 3.4.4 (points, as squares under the top-left
//! rule); Vulkan specification, Basic Point Rasterization. Deviation: nothing is snapped, every side is the
//! exact sum of the point and half the size.

mod explain;

pub use explain::Snapshot;

use super::{Span, edge::first_reached, first_centre};
use crate::{
    math::{Arithmetic, Expansion, Sign, Tally},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use serde::Serialize;

/// A side of the square.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// Of least x.
    Left,
    /// Of greatest x.
    Right,
    /// Of least y.
    Upper,
    /// Of greatest y.
    Lower,
}

impl Side {
    /// All sides, in the order in which they are looked at.
    pub const ALL: [Self; 4] = [Self::Left, Self::Right, Self::Upper, Self::Lower];

    /// 0: it is at an x, 1: at a y.
    pub fn axis(self) -> usize {
        usize::from(matches!(self, Self::Upper | Self::Lower))
    }

    /// Whether it is the one of greatest x or y.
    pub fn is_far(self) -> bool {
        matches!(self, Self::Right | Self::Lower)
    }
}

/// The conventions of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Settings {
    /// Width and height of the image in pixels, each in `1..=16384`; pixels outside are left out.
    pub size: [u32; 2],
    /// What the sides are computed in; `F32` and `F64` round them, fixed point is exact here.
    pub arithmetic: Arithmetic,
}

impl Settings {
    /// Exact.
    pub fn new(size: [u32; 2]) -> Self {
        Self { size, arithmetic: Arithmetic::Exact }
    }
}

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", rename_all_fields = "snake_case")]
pub enum Event {
    /// The place of a side was computed.
    Side {
        /// The side.
        side: Side,
        /// Where.
        at: f64,
    },
    /// The first column or row whose centre is at or beyond the side.
    First {
        /// The side.
        side: Side,
        /// The column or row; the image's size if there is none.
        index: u32,
        /// Whether the exact sign moved what the place suggested.
        corrected: bool,
    },
    /// Centres lie exactly on the side: in at the left and the upper one, out at the right and the lower one.
    Tie {
        /// The side.
        side: Side,
        /// Their column or row.
        index: u32,
    },
    /// The pixels of a row were drawn.
    Row {
        /// The row.
        y: u32,
    },
    /// All rows are done.
    Done,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Finds the pixels of a point, as one span a row, from top to bottom.
///
/// Any finite place, on or off the image; a finite size in pixels, of which 0 or less draws nothing. `tally`
/// counts the signs asked for. Cost: about 50 ns, and the rows.
pub fn draw(at: [f32; 2], width: f32, settings: &Settings, tally: &mut Tally, emit: &mut impl FnMut(Span)) {
    draw_traced((at, width), settings, tally, &mut NoTrace, emit);
}

/// [`draw`] as a run that can be scrubbed.
pub fn play(at: [f32; 2], width: f32, settings: Settings, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new((at, width), settings), budget, move |t| {
        draw_traced((at, width), &settings, &mut Tally::default(), t, &mut |_| {});
    })
}

/// The algorithm, for a point and its size: [`draw`] and [`play`] are this with two tracers.
pub fn draw_traced<T: Tracer<Event>>(
    (at, width): ([f32; 2], f32),
    settings: &Settings,
    tally: &mut Tally,
    t: &mut T,
    emit: &mut impl FnMut(Span),
) {
    let [begin, end, first, last] = Side::ALL.map(|side| {
        let (middle, limit) = (at[side.axis()], settings.size[side.axis()]);
        // Half the size is exact as a double.
        let half = f64::from(width) / if side.is_far() { 2.0 } else { -2.0 };
        let place = match settings.arithmetic {
            Arithmetic::F32 => (middle + half as f32).into(),
            _ => f64::from(middle) + half,
        };
        t.emit(|| Event::Side { side, at: place });
        let guess = first_centre(place, false, limit);
        let mut tie = None;
        let beyond = |n: u32| {
            tally.calls += 1;
            let sign = Expansion::sum_of([f64::from(n) + 0.5, -f64::from(middle), -half]).sign();
            if sign.is_zero() {
                tie = Some(n);
            }
            sign != Sign::Negative
        };
        let index = if settings.arithmetic.is_exact() {
            first_reached(guess, limit, beyond)
        } else {
            if guess < limit && f64::from(guess) + 0.5 == place {
                tie = Some(guess);
            }
            guess
        };
        t.emit(|| Event::First { side, index, corrected: index != guess });
        if let Some(index) = tie {
            t.emit(|| Event::Tie { side, index });
        }
        index
    });
    if begin < end {
        for y in first..last {
            t.emit(|| Event::Row { y });
            emit(Span { y, begin, end });
        }
    }
    t.emit(|| Event::Done);
}
