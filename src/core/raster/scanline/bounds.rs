//! Where a span begins or ends: the crossing of a row with an edge, and the pixel it means.

use super::{Between, Counts, Event, Settings, Side, YAxis};
use crate::{
    math::{Real, Sign, Tally, UNIT_ROUNDOFF},
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
    /// Whether the slope is added up, and from how near a crossing counts as lying on a centre.
    accumulates: bool,
    epsilon: Option<f64>,
}

/// Absolute error of a crossing `x0 + (y - y0) dx / dy` in binary64 relative to the magnitudes of its two
/// terms: the second goes through six roundings (three differences, quotient, product, sum), and no more
/// than (1 + u)^5 / (1 - u) - 1 < 7u is lost. Bound and comparison go through three more, so 8u will do.
const CROSSING_ERROR: f64 = 8.0 * UNIT_ROUNDOFF;

impl<R: Real> Bound<R> {
    pub(super) fn new(
        edge: Edge,
        (name, side): (Between, Side),
        start: [R; 2],
        slope: R,
        settings: &Settings,
    ) -> Self {
        let (accumulates, epsilon) = (settings.accumulates(), settings.epsilon());
        Self { edge, name, side, start, slope, last: None, accumulates, epsilon }
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
        let (crossing, error) = self.crossing(y, settings);
        let x = self.epsilon.map_or(crossing, |epsilon| near_centre(crossing, epsilon));
        t.emit(|| Event::Crossing { side, edge: name, x });
        // A tie belongs to the span if the edge draws it: then a left end begins at the tie and a
        // right end comes after it.
        let past_ties = self.edge.draws_ties == (side == Side::Right);
        let width = settings.size[0];
        let guess = super::first_centre(x, past_ties, width);
        let (end, tie) = if !self.accumulates && self.epsilon.is_none() {
            let signs = u64::from(guess > 0) + u64::from(guess < width);
            // The centre before lies before the crossing, that of the end behind it, beyond any doubt.
            let after = f64::from(guess) + 0.5;
            if (guess == 0 || x - (after - 1.0) > error) && (guess == width || after - x > error) {
                tally.calls += signs;
                counts.tested += signs;
                (guess, None)
            } else {
                self.certify(guess, y, width, tally, counts)
            }
        } else {
            (guess, centre_at(x, width))
        };
        t.emit(|| Event::End { side, x: end, corrected: end != guess });
        if let Some(x) = tie {
            let drawn = self.edge.draws_ties;
            t.emit(|| Event::Tie { side, edge: name, x, drawn });
        }
        end
    }

    /// Where the row meets the edge, and how far off that can be if it is not added up.
    #[inline]
    fn crossing(&mut self, y: u32, settings: &Settings) -> (f64, f64) {
        let [x0, y0] = self.start;
        let along = (R::from_f32(y as f32 + 0.5) - y0) * self.slope;
        let x = match (self.last, settings.y_axis) {
            (Some(last), YAxis::Down) if self.accumulates => last + self.slope,
            (Some(last), YAxis::Up) if self.accumulates => last - self.slope,
            _ => x0 + along,
        };
        self.last = Some(x);
        (x.to_f64(), CROSSING_ERROR * (x0.to_f64().abs() + along.to_f64().abs()))
    }

    /// The end itself, by exact signs where the crossing leaves a doubt: nearly always the guess, else by bisection. And the pixel
    /// whose centre lies exactly on the edge, if it is next to the end.
    #[inline(never)]
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

/// A crossing that lies nearly on a centre, moved onto it: the mistake of an epsilon.
fn near_centre(x: f64, epsilon: f64) -> f64 {
    let centre = x.floor() + 0.5;
    // Half a pixel or more would leave nothing between two centres.
    if (x - centre).abs() < epsilon.min(0.25) { centre } else { x }
}

/// The pixel, if any, whose centre has exactly this x.
fn centre_at(x: f64, width: u32) -> Option<u32> {
    let shifted = x - 0.5;
    (shifted.fract() == 0.0 && (0.0..f64::from(width)).contains(&shifted)).then_some(shifted as u32)
}
