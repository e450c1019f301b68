//! The arithmetics in which the text of the algorithm runs.

use super::super::{
    Border, End, Mistake, Mistakes, Outcode, Segment, Window,
    intersection::{code_at, intersection},
};
use crate::math::{Real, Tally};

/// The two ends while they are being cut.
pub(super) trait Form {
    /// The code of an end that has not moved yet.
    fn code(&self, end: End) -> Outcode;
    /// Moves `end`, which lies beyond `border`, to the border; returns its new code.
    fn cut(&mut self, end: End, border: Border) -> Outcode;
    /// The ends as they stand.
    fn segment(&self) -> Segment;
}

/// Decisions and coordinates of the exact line through the original ends.
pub(super) struct Exact<'a> {
    original: Segment,
    current: Segment,
    window: &'a Window,
    tally: &'a mut Tally,
}

impl<'a> Exact<'a> {
    pub(super) fn new(segment: Segment, window: &'a Window, tally: &'a mut Tally) -> Self {
        Self { original: segment, current: segment, window, tally }
    }
}

impl Form for Exact<'_> {
    #[inline]
    fn code(&self, end: End) -> Outcode {
        let Window { xmin, ymin, xmax, ymax } = *self.window;
        Outcode::of(self.original[end as usize], [xmin, ymin, xmax, ymax])
    }

    #[inline]
    fn cut(&mut self, end: End, border: Border) -> Outcode {
        self.current[end as usize] = intersection(self.original, border, self.window, self.tally);
        code_at(self.original, border, self.window, self.tally)
    }

    #[inline]
    fn segment(&self) -> Segment {
        self.current
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

    fn cut(&mut self, end: End, border: Border) -> Outcode {
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
