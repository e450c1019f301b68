//! Nicholl-Lee-Nicholl line clipping: know the region before computing a point of it.
//!
//! P1 is inside, beyond one border, or beyond two. Lines from it through the window's corners
//! divide the plane; in which region P2 lies, slopes tell, and that names the border E where the
//! line enters and the border F where it leaves. Only points of the answer are ever computed.
//!
//! *Source:* Nicholl, Lee and Nicholl, An Efficient New Algorithm for 2-D Line Clipping: Its
//! Development and Analysis, Computer Graphics 21(4) (SIGGRAPH 1987). Deviations: where the paper
//! turns and mirrors the picture until P1 lies inside, to the left or to the upper left, the
//! borders are renamed here (E, and F across or opposite E), which is the same and moves no number;
//! whether a border is crossed before another is one question for all three uses of a slope.

mod explain;
mod forms;
mod formulas;
mod regions;

pub use explain::Snapshot;

use super::{Border, End, Outcode, Point, Segment, Window};
use crate::{
    math::{Arithmetic, Real, Sign, Tally},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use forms::{Exact, Form, Taught};
use serde::Serialize;

/// What a slope is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Question {
    /// P1 lies beyond both borders: which is crossed last?
    Entry,
    /// The first border is E, P2 lies beyond the second: is E crossed too late?
    Miss,
    /// P2 lies beyond both borders: which is crossed first?
    Exit,
}

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// P1 was placed: inside, beyond one border, or beyond two.
    Place {
        /// Its code.
        code: Outcode,
    },
    /// P2 was compared with a border that P1 lies beyond.
    Same {
        /// The border.
        border: Border,
        /// Whether P2 lies beyond it, too.
        beyond: bool,
    },
    /// P2 was compared with a border that P1 does not lie beyond.
    Far {
        /// The border.
        border: Border,
        /// Whether P2 lies beyond it.
        beyond: bool,
    },
    /// The slope of the line was compared with that to a corner: it tells the order in which the
    /// corner's borders are crossed.
    Slope {
        /// What for.
        question: Question,
        /// The borders that meet there.
        corner: [Border; 2],
        /// Whether the first of them is crossed after the second.
        later: bool,
        /// How many of the two products had to be computed.
        products: u8,
    },
    /// An end was moved to a border.
    Cut {
        /// The border.
        border: Border,
        /// Which end.
        end: End,
        /// How many products had to be computed.
        products: u8,
        /// The new place.
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
/// The answer is exact, and bit for bit that of [`cohen_sutherland`](super::cohen_sutherland). A
/// segment of length zero is a point. Costs at most eight comparisons, three orientations, and a
/// quotient for each end that is cut; no quotient if nothing is visible.
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
/// `F32` and `F64` round differences, products and quotients, as the paper's program does; they
/// may answer wrongly or with numbers that are not finite: showing that is what they are for.
/// Fixed point belongs to scan conversion; here it is the exact form. `tally` counts exact
/// decisions.
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

/// The two borders across each axis, in the order in which they are looked at.
const PAIRS: [[Border; 2]; 2] = [[Border::Right, Border::Left], [Border::Top, Border::Bottom]];

/// The text of the algorithm, in any form of arithmetic.
fn run<F: Form, T: Tracer<Event>>(line: F, t: &mut T) -> Option<Segment> {
    let mut search = Search { line, known: Outcode::default(), t };
    let answer = search.run();
    search.t.emit(|| if answer.is_some() { Event::Accept } else { Event::Reject });
    answer
}

struct Search<'a, F, T> {
    line: F,
    /// The borders whose product is computed.
    known: Outcode,
    t: &'a mut T,
}

impl<F: Form, T: Tracer<Event>> Search<'_, F, T> {
    fn run(&mut self) -> Option<Segment> {
        let code = self.place();
        self.t.emit(|| Event::Place { code });
        let [vertical, horizontal] = [1, 0].map(|axis| PAIRS[axis].into_iter().find(|b| code.has(*b)));
        for border in [vertical, horizontal].into_iter().flatten() {
            let beyond = self.line.beyond(End::P2, border);
            self.t.emit(|| Event::Same { border, beyond });
            if beyond {
                return None;
            }
        }
        let entry = match [vertical, horizontal] {
            [Some(a), Some(b)] => {
                Some(if self.later(Question::Entry, [a, b]) == Sign::Positive { a } else { b })
            }
            [a, b] => a.or(b),
        };
        let mut exit: Option<Border> = None;
        // Across E first: there the line may miss the window.
        for axis in entry.map_or([1, 0], |entry| [1 - entry.axis(), entry.axis()]) {
            let Some(far) = self.far(axis, code) else { continue };
            exit = Some(match (exit, entry) {
                (Some(near), _) if self.later(Question::Exit, [near, far]) == Sign::Positive => far,
                (Some(near), _) => near,
                (None, Some(entry)) if entry.axis() != axis => {
                    if self.later(Question::Miss, [entry, far]) == Sign::Positive {
                        return None;
                    }
                    far
                }
                (None, _) => far,
            });
        }
        let mut visible = self.line.given();
        for (end, border) in End::ALL.into_iter().zip([entry, exit]) {
            if let Some(border) = border {
                let products = self.products([border]);
                let to = self.line.cut(border);
                self.t.emit(|| Event::Cut { border, end, products, to });
                visible[end as usize] = to;
            }
        }
        Some(visible)
    }

    /// The code of P1: a second comparison across an axis only if the first says no.
    fn place(&mut self) -> Outcode {
        PAIRS.into_iter().fold(Outcode::default(), |code, pair| {
            let beyond = pair.into_iter().find(|border| self.line.beyond(End::P1, *border));
            Outcode(code.0 | beyond.map_or(0, |border| Outcode::bit(border).0))
        })
    }

    /// The border across `axis` that P2 lies beyond, of those that are not decided by P1's code.
    fn far(&mut self, axis: usize, code: Outcode) -> Option<Border> {
        PAIRS[axis].into_iter().filter(|border| !code.has(*border)).find(|border| {
            let (border, beyond) = (*border, self.line.beyond(End::P2, *border));
            self.t.emit(|| Event::Far { border, beyond });
            beyond
        })
    }

    /// The sign of how much later the first border is crossed than the second.
    fn later(&mut self, question: Question, corner: [Border; 2]) -> Sign {
        let products = self.products(corner);
        // Where the line goes in, the coordinate moves inward; where it goes out, outward.
        let signs = corner[0].outward() * corner[1].outward();
        let signs = if question == Question::Miss { -signs } else { signs };
        let later = self.line.order(corner, signs);
        self.t.emit(|| Event::Slope { question, corner, later: later == Sign::Positive, products });
        later
    }

    /// How many of these borders' products are not known yet; now they are.
    fn products<const N: usize>(&mut self, borders: [Border; N]) -> u8 {
        let mut new = 0;
        for border in borders {
            new += u8::from(!self.known.has(border));
            self.known.0 |= Outcode::bit(border).0;
        }
        new
    }
}
