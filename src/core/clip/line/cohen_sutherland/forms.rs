//! The arithmetics in which the text of the algorithm runs.

use super::super::{
    Border, End, Mistake, Mistakes, Outcode, Segment, Window,
    intersection::{intersection, side_at},
};
use crate::math::{Real, Tally};

/// The two ends while they are being cut.
pub(super) trait Form {
    /// The code of an end that has not moved yet.
    fn code(&self, end: End) -> Outcode;
    /// Moves an end that lies beyond `border` to the border; returns its new code.
    fn cut(&mut self, border: Border, end: End) -> Outcode;
    /// The ends as they stand.
    fn segment(&self) -> Segment;
}

/// Decisions and coordinates of the exact line through the original ends.
pub(super) struct Exact<'a> {
    original: Segment,
    ends: Segment,
    window: &'a Window,
    tally: &'a mut Tally,
}

impl<'a> Exact<'a> {
    pub(super) fn new(original: Segment, window: &'a Window, tally: &'a mut Tally) -> Self {
        Self { original, ends: original, window, tally }
    }
}

impl Form for Exact<'_> {
    fn code(&self, end: End) -> Outcode {
        let Window { xmin, ymin, xmax, ymax } = *self.window;
        Outcode::of(self.original[end as usize], [xmin, ymin, xmax, ymax])
    }

    fn cut(&mut self, border: Border, end: End) -> Outcode {
        self.ends[end as usize] = intersection(self.original, border, self.window, self.tally);
        // By signs from the original ends: a rounded point can fall on a border from outside.
        Outcode::from_bits(Border::ALL.map(|other| {
            other.axis() != border.axis()
                && other.outward()
                    == side_at(self.original, border, self.window, self.window.at(other), self.tally)
        }))
    }

    fn segment(&self) -> Segment {
        self.ends
    }
}

/// As taught: from the ends as they stand, in the rounded arithmetic `R`.
pub(super) struct Taught<R> {
    ends: [[R; 2]; 2],
    window: [R; 4],
    /// The same borders, by name.
    at: Window,
    /// From which end a cut is computed.
    from: End,
}

impl<R: Real> Taught<R> {
    pub(super) fn new(segment: Segment, window: &Window, mistakes: Mistakes) -> Self {
        let Window { xmin, ymin, xmax, ymax } = *window;
        Self {
            ends: segment.map(|p| p.map(R::from_f32)),
            window: [xmin, ymin, xmax, ymax].map(R::from_f32),
            at: *window,
            from: if mistakes.has(Mistake::OtherOrder) { End::P2 } else { End::P1 },
        }
    }
}

impl<R: Real> Form for Taught<R> {
    fn code(&self, end: End) -> Outcode {
        Outcode::of(self.ends[end as usize], self.window)
    }

    fn cut(&mut self, border: Border, end: End) -> Outcode {
        let (fixed, free) = (border.axis(), 1 - border.axis());
        let c = R::from_f32(self.at.at(border));
        let [p1, p2] = [self.from, self.from.other()].map(|end| self.ends[end as usize]);
        let t = (c - p1[fixed]) / (p2[fixed] - p1[fixed]);
        let moved = &mut self.ends[end as usize];
        moved[fixed] = c;
        moved[free] = p1[free] + t * (p2[free] - p1[free]);
        self.code(end)
    }

    fn segment(&self) -> Segment {
        self.ends.map(|p| p.map(R::to_f32))
    }
}
