//! The arithmetics in which the text of the algorithm runs.

use super::super::{Border, End, Point, Segment, Window, intersection::intersection, parametric::difference};
use crate::math::{Real, Sign, Tally, orient2d};

/// The line whose regions are found.
pub(super) trait Form {
    /// The segment as it was given.
    fn given(&self) -> Segment;
    /// Whether an end lies beyond a border.
    fn beyond(&self, end: End, border: Border) -> bool;
    /// The sign of t of the first border minus t of the second, which meets it in a corner; `signs`
    /// is the sign of `(x2 - x1) (y2 - y1)`.
    fn order(&mut self, corner: [Border; 2], signs: Sign) -> Sign;
    /// Where the line crosses a border.
    fn cut(&mut self, border: Border) -> Point;
}

/// Whether `x` lies beyond a border at `side`.
fn is_beyond<R: PartialOrd>(x: R, side: R, border: Border) -> bool {
    match border {
        Border::Top | Border::Right => x > side,
        Border::Bottom | Border::Left => x < side,
    }
}

/// Decisions and coordinates of the exact line.
pub(super) struct Exact<'a> {
    segment: Segment,
    window: &'a Window,
    tally: &'a mut Tally,
}

impl<'a> Exact<'a> {
    pub(super) fn new(segment: Segment, window: &'a Window, tally: &'a mut Tally) -> Self {
        Self { segment, window, tally }
    }
}

impl Form for Exact<'_> {
    fn given(&self) -> Segment {
        self.segment
    }

    fn beyond(&self, end: End, border: Border) -> bool {
        is_beyond(self.segment[end as usize][border.axis()], self.window.at(border), border)
    }

    fn order(&mut self, [a, b]: [Border; 2], signs: Sign) -> Sign {
        let [p1, p2] = self.segment;
        let mut corner = [self.window.at(a); 2];
        corner[b.axis()] = self.window.at(b);
        let side = orient2d(p1, p2, corner, self.tally) * signs;
        if a.axis() == 0 { -side } else { side }
    }

    fn cut(&mut self, border: Border) -> Point {
        intersection(self.segment, border, self.window, self.tally)
    }
}

/// `(c - x1) (y2 - y1)` of a border at x = c, and the like of one at y = c: the product that its
/// slope comparisons and its cut share.
pub(super) fn product<R: Real>([p1, p2]: [[R; 2]; 2], at: R, border: Border) -> R {
    let (fixed, free) = (border.axis(), 1 - border.axis());
    (at - p1[fixed]) * (p2[free] - p1[free])
}

/// As taught, in the rounded arithmetic `R`.
pub(super) struct Taught<R> {
    segment: Segment,
    ends: [[R; 2]; 2],
    window: Window,
    /// The product of each border, once computed.
    products: [Option<R>; 4],
}

impl<R: Real> Taught<R> {
    pub(super) fn new(segment: Segment, window: &Window) -> Self {
        let ends = segment.map(|p| p.map(R::from_f32));
        Self { segment, ends, window: *window, products: [None; 4] }
    }

    fn at(&self, border: Border) -> R {
        R::from_f32(self.window.at(border))
    }

    fn product(&mut self, border: Border) -> R {
        let (ends, at) = (self.ends, self.at(border));
        *self.products[border as usize].get_or_insert_with(|| product(ends, at, border))
    }
}

impl<R: Real> Form for Taught<R> {
    fn given(&self) -> Segment {
        self.segment
    }

    fn beyond(&self, end: End, border: Border) -> bool {
        is_beyond(self.ends[end as usize][border.axis()], self.at(border), border)
    }

    fn order(&mut self, [a, b]: [Border; 2], signs: Sign) -> Sign {
        difference(self.product(a), self.product(b)) * signs
    }

    fn cut(&mut self, border: Border) -> Point {
        let (fixed, free) = (border.axis(), 1 - border.axis());
        let product = self.product(border);
        let [p1, p2] = self.ends;
        let mut point = [self.at(border); 2];
        point[free] = p1[free] + product / (p2[fixed] - p1[fixed]);
        point.map(R::to_f32)
    }
}
