//! An edge in the active list: where the row's centre line meets it, and the column that this means.

use super::{Entry, Event, Settings};
use crate::{
    math::{Real, Sign, Tally, orient2d},
    raster::{
        YAxis,
        edge::{centre, first_reached},
        first_centre,
    },
    trace::Tracer,
};
use std::cmp::Ordering;

/// An edge that crosses the current row.
pub(super) struct Active<R> {
    entry: Entry<R>,
    /// The crossing with the row before, to which rounded arithmetic adds the slope.
    last: Option<R>,
    /// The crossing with this row, as computed.
    x: f64,
    /// The first column whose centre is at or right of the edge.
    first: u32,
}

impl<R: Real> Active<R> {
    pub(super) fn new(entry: Entry<R>) -> Self {
        Self { entry, last: None, x: 0.0, first: 0 }
    }

    pub(super) fn name(&self) -> u32 {
        self.entry.edge
    }

    pub(super) fn direction(&self) -> i32 {
        self.entry.direction
    }

    pub(super) fn first(&self) -> u32 {
        self.first
    }

    /// Whether it crosses this line, which is not above its first.
    pub(super) fn crosses(&self, line: u32) -> bool {
        line < self.entry.end
    }

    pub(super) fn order(&self, other: &Self) -> Ordering {
        order((self.first, self.x), (other.first, other.x))
    }

    /// Finds where the centre line of row `y` meets the edge, and the first column at or right of it.
    pub(super) fn meet<T: Tracer<Event>>(
        &mut self,
        y: u32,
        settings: &Settings,
        tally: &mut Tally,
        t: &mut T,
    ) {
        let (edge, width) = (self.entry.edge, settings.size[0]);
        self.x = self.crossing(y, settings).to_f64();
        t.emit(|| Event::Crossing { edge, x: self.x });
        let guess = first_centre(self.x, false, width);
        let is_tie;
        (self.first, is_tie) = if settings.arithmetic.is_exact() {
            self.certify(guess, y, width, tally)
        } else {
            (guess, guess < width && f64::from(guess) + 0.5 == self.x)
        };
        let x = self.first;
        t.emit(|| Event::First { edge, x, corrected: x != guess });
        if is_tie {
            t.emit(|| Event::Tie { edge, x });
        }
    }

    fn crossing(&mut self, y: u32, settings: &Settings) -> R {
        let Entry { ends: [upper, _], dx_dy, .. } = self.entry;
        let [x0, y0] = upper.map(R::from_f32);
        let x = match (self.last.filter(|_| !settings.arithmetic.is_exact()), settings.y_axis) {
            (Some(last), YAxis::Down) => last + dx_dy,
            (Some(last), YAxis::Up) => last - dx_dy,
            (None, _) => x0 + (R::from_f32(y as f32 + 0.5) - y0) * dx_dy,
        };
        self.last = Some(x);
        x
    }

    /// The column by exact signs: nearly always the guess. And whether its centre lies on the edge.
    fn certify(&self, guess: u32, y: u32, width: u32, tally: &mut Tally) -> (u32, bool) {
        let [a, b] = self.entry.ends;
        // From the greater y to the lesser one, what lies to the right is positive.
        let [from, to] = if a[1] > b[1] { [a, b] } else { [b, a] };
        let mut is_tie = false;
        let first = first_reached(guess, width, |x| {
            let side = orient2d(from, to, centre(x, y), tally);
            is_tie |= side.is_zero();
            side != Sign::Negative
        });
        (first, is_tie)
    }
}

/// The order in the active list: by column, then by crossing.
pub(super) fn order(a: (u32, f64), b: (u32, f64)) -> Ordering {
    a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
}
