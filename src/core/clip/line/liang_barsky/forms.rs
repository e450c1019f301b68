//! The arithmetics in which the text of the algorithm runs.

use super::{
    super::{Border, End, Point, Segment, Window, intersection::intersection, parametric::difference},
    Course, Parameter,
};
use crate::math::{Approx, Dyadic, Real, Sign, Tally, orient2d, rounded_ratio};

/// The line while its parameters are put in order.
pub(super) trait Form {
    /// The sign of p.
    fn course(&self, border: Border) -> Course;
    /// Whether q < 0; only asked of a parallel border.
    fn outside(&self, border: Border) -> bool;
    /// The sign of `a - b`, without dividing; no border of them is parallel.
    fn order(&mut self, a: Parameter, b: Parameter) -> Sign;
    /// q / p.
    fn divide(&mut self, border: Border) -> f32;
    /// The point at q / p.
    fn cut(&mut self, border: Border) -> Point;
    /// The segment as it was given.
    fn given(&self) -> Segment;
}

/// -1 for a border at a minimum, +1 for one at a maximum: the sign of p if the coordinate grows.
#[inline]
fn outward(border: Border) -> Sign {
    match border {
        Border::Left | Border::Bottom => Sign::Negative,
        Border::Right | Border::Top => Sign::Positive,
    }
}

/// Decisions and numbers of the exact line.
pub(super) struct Exact<'a> {
    segment: Segment,
    window: &'a Window,
    tally: &'a mut Tally,
}

impl<'a> Exact<'a> {
    pub(super) fn new(segment: Segment, window: &'a Window, tally: &'a mut Tally) -> Self {
        Self { segment, window, tally }
    }

    /// The sign of `x2 - x1`, or of `y2 - y1`.
    #[inline]
    fn rising(&self, axis: usize) -> Sign {
        let [p1, p2] = self.segment;
        difference(p2[axis], p1[axis])
    }
}

impl Form for Exact<'_> {
    #[inline]
    fn course(&self, border: Border) -> Course {
        Course::outward(outward(border) * self.rising(border.axis()))
    }

    #[inline]
    fn outside(&self, border: Border) -> bool {
        let [p1, _] = self.segment;
        outward(border) * difference(p1[border.axis()], self.window.at(border)) == Sign::Positive
    }

    /// Across the axes, `tx - ty` has the sign of which side of the line the borders' corner is on.
    #[inline]
    fn order(&mut self, a: Parameter, b: Parameter) -> Sign {
        let [p1, p2] = self.segment;
        match (a, b) {
            (Parameter::Of(a), Parameter::Of(b)) => difference(a as u8, b as u8),
            (Parameter::At(a), Parameter::Of(end)) => {
                let axis = a.axis();
                difference(self.window.at(a), self.segment[end as usize][axis]) * self.rising(axis)
            }
            (Parameter::Of(_), Parameter::At(_)) => -self.order(b, a),
            (Parameter::At(a), Parameter::At(b)) if a.axis() == b.axis() => {
                difference(self.window.at(a), self.window.at(b)) * self.rising(a.axis())
            }
            (Parameter::At(a), Parameter::At(b)) => {
                let mut corner = [self.window.at(a); 2];
                corner[b.axis()] = self.window.at(b);
                let side = orient2d(p1, p2, corner, self.tally) * self.rising(0) * self.rising(1);
                if a.axis() == 0 { -side } else { side }
            }
        }
    }

    #[inline]
    fn divide(&mut self, border: Border) -> f32 {
        let (axis, c) = (border.axis(), self.window.at(border));
        let [a1, a2] = self.segment.map(|p| p[axis]);
        let [fa1, fa2, fc] = [a1, a2, c].map(Approx::from);
        rounded_ratio(
            (fc - fa1) / (fa2 - fa1),
            || {
                let [a1, a2, c] = [a1, a2, c].map(Dyadic::from);
                (&c - &a1, &a2 - &a1)
            },
            self.tally,
        )
    }

    #[inline]
    fn cut(&mut self, border: Border) -> Point {
        intersection(self.segment, border, self.window, self.tally)
    }

    #[inline]
    fn given(&self) -> Segment {
        self.segment
    }
}

/// p and q of a border in the arithmetic `R`.
pub(super) fn measured<R: Real>(segment: Segment, window: &Window, border: Border) -> [R; 2] {
    let [a1, a2] = segment.map(|p| R::from_f32(p[border.axis()]));
    let c = R::from_f32(window.at(border));
    match border {
        Border::Left | Border::Bottom => [a1 - a2, a1 - c],
        Border::Right | Border::Top => [a2 - a1, c - a1],
    }
}

/// Where the line meets a border that is not parallel, also beyond its ends: to be drawn.
pub(super) fn crossing(segment: Segment, window: &Window, border: Border) -> Point {
    let [p, q] = measured::<f64>(segment, window, border);
    point_at(segment, q / p)
}

/// `P1 + t (P2 - P1)`.
fn point_at<R: Real>(segment: Segment, t: R) -> Point {
    let [p1, p2] = segment.map(|p| p.map(R::from_f32));
    [0, 1].map(|axis| (p1[axis] + t * (p2[axis] - p1[axis])).to_f32())
}

/// As taught, in the rounded arithmetic `R`.
pub(super) struct Taught<R> {
    segment: Segment,
    /// p and q of each border.
    measured: [[R; 2]; 4],
}

impl<R: Real> Taught<R> {
    pub(super) fn new(segment: Segment, window: &Window) -> Self {
        Self { segment, measured: Border::ALL.map(|border| measured(segment, window, border)) }
    }

    /// Numerator and denominator, the denominator positive.
    fn fraction(&self, parameter: Parameter) -> [R; 2] {
        match parameter {
            Parameter::Of(End::P1) => [R::ZERO, R::ONE],
            Parameter::Of(End::P2) => [R::ONE, R::ONE],
            Parameter::At(border) => {
                let [p, q] = self.measured[border as usize];
                if p < R::ZERO { [-q, -p] } else { [q, p] }
            }
        }
    }

    fn quotient(&self, border: Border) -> R {
        let [p, q] = self.measured[border as usize];
        q / p
    }
}

impl<R: Real> Form for Taught<R> {
    fn course(&self, border: Border) -> Course {
        let [p, _] = self.measured[border as usize];
        Course::outward(difference(p, R::ZERO))
    }

    fn outside(&self, border: Border) -> bool {
        let [_, q] = self.measured[border as usize];
        q < R::ZERO
    }

    fn order(&mut self, a: Parameter, b: Parameter) -> Sign {
        let [[n1, d1], [n2, d2]] = [a, b].map(|parameter| self.fraction(parameter));
        difference(n1 * d2, n2 * d1)
    }

    fn divide(&mut self, border: Border) -> f32 {
        self.quotient(border).to_f32()
    }

    fn cut(&mut self, border: Border) -> Point {
        point_at(self.segment, self.quotient(border))
    }

    fn given(&self) -> Segment {
        self.segment
    }
}
