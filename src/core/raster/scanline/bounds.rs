//! Where a span begins or ends: the crossing of a row with an edge, and the pixel it means.

use super::{Between, Counts, Event, Settings, Side, YAxis};
use crate::{
    math::{Arithmetic, Real, Sign, Tally},
    raster::{
        Edge,
        edge::{bisect, centre},
    },
    trace::Tracer,
};

/// An edge that is walked down, row by row.
pub(super) struct Bound<R> {
    edge: Edge,
    name: Between,
    side: Side,
    start: [R; 2],
    slope: R,
    /// The crossing with the row before, to which rounded arithmetic adds the slope.
    last: Option<R>,
}

impl<R: Real> Bound<R> {
    pub(super) fn new(edge: Edge, name: Between, side: Side, start: [R; 2], slope: R) -> Self {
        Self { edge, name, side, start, slope, last: None }
    }

    /// The first pixel of the span of row `y`, or the one past its last.
    pub(super) fn find<T: Tracer<Event>>(
        &mut self,
        y: u32,
        settings: &Settings,
        tally: &mut Tally,
        t: &mut T,
        counts: &mut Counts,
    ) -> u32 {
        let (name, side) = (self.name, self.side);
        let x = self.crossing(y, settings);
        t.emit(|| Event::Crossing { side, edge: name, x });
        // A tie belongs to the span if the edge draws it: then a left end begins at the tie and a
        // right end comes after it.
        let past_ties = self.edge.draws_ties == (side == Side::Right);
        let guess = super::first_centre(x, past_ties, settings.size[0]);
        let (end, tie) = match settings.arithmetic {
            Arithmetic::Exact | Arithmetic::Fixed8 => self.certify(guess, y, settings.size[0], tally, counts),
            Arithmetic::F32 | Arithmetic::F64 => (guess, centre_at(x, settings.size[0])),
        };
        t.emit(|| Event::End { side, x: end, corrected: end != guess });
        if let Some(x) = tie {
            let drawn = self.edge.draws_ties;
            t.emit(|| Event::Tie { side, edge: name, x, drawn });
        }
        end
    }

    fn crossing(&mut self, y: u32, settings: &Settings) -> f64 {
        let along = |this: &Self| this.start[0] + (R::from_f32(y as f32 + 0.5) - this.start[1]) * this.slope;
        let x = match (settings.arithmetic, self.last) {
            (Arithmetic::F32 | Arithmetic::F64, Some(last)) => match settings.y_axis {
                YAxis::Down => last + self.slope,
                YAxis::Up => last - self.slope,
            },
            _ => along(self),
        };
        self.last = Some(x);
        x.to_f64()
    }

    /// The end itself, by exact signs: nearly always the guess, else by bisection. And the pixel
    /// whose centre lies exactly on the edge, if it is next to the end.
    fn certify(
        &self,
        guess: u32,
        y: u32,
        width: u32,
        tally: &mut Tally,
        counts: &mut Counts,
    ) -> (u32, Option<u32>) {
        let mut sign = |x: u32| {
            counts.tested += u64::from(x < width);
            (x < width).then(|| self.edge.side(centre(x, y), tally))
        };
        // From the end on, pixels are inside of a left edge and outside of a right one.
        let reached = |sign: Sign| self.edge.draws(sign) == (self.side == Side::Left);
        let mut end = guess;
        let (mut before, mut at) = (end.checked_sub(1).and_then(&mut sign), sign(end));
        if before.is_some_and(reached) || at.is_some_and(|sign| !reached(sign)) {
            end = bisect(width, |x| sign(x).is_none_or(reached));
            (before, at) = (end.checked_sub(1).and_then(&mut sign), sign(end));
        }
        let zero = |sign: Option<Sign>| sign.is_some_and(Sign::is_zero);
        (end, if zero(before) { Some(end - 1) } else { zero(at).then_some(end) })
    }
}

/// The pixel, if any, whose centre has exactly this x.
fn centre_at(x: f64, width: u32) -> Option<u32> {
    let shifted = x - 0.5;
    (shifted.fract() == 0.0 && (0.0..f64::from(width)).contains(&shifted)).then_some(shifted as u32)
}
