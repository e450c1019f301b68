//! The arithmetics in which the text of the algorithm runs.

use super::{
    super::{
        Border, End, Point, Segment, Window,
        intersection::intersection,
        parametric::{difference, point_at},
    },
    Course, Parameter,
};
use crate::math::{Approx, Dyadic, Real, Sign, Tally, orient2d, rounded_ratio};

/// The line while its parameters are put in order.
pub(super) trait Form {
    /// What q / p is kept in.
    type Quotient: Real;
    /// The sign of p.
    fn course(&mut self, border: Border) -> Course;
    /// Whether q < 0; only asked of a parallel border.
    fn outside(&self, border: Border) -> bool;
    /// The sign of `a - b`, without dividing; no border of them is parallel.
    fn order(&mut self, a: Parameter, b: Parameter) -> Sign;
    /// q / p.
    fn divide(&mut self, border: Border) -> Self::Quotient;
    /// The point at q / p.
    fn cut(&mut self, border: Border, t: Self::Quotient) -> Point;
    /// The segment as it was given.
    fn given(&self) -> Segment;
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
    type Quotient = f32;

    #[inline]
    fn course(&mut self, border: Border) -> Course {
        Course::outward(border.outward() * self.rising(border.axis()))
    }

    #[inline]
    fn outside(&self, border: Border) -> bool {
        let [p1, _] = self.segment;
        border.outward() * difference(p1[border.axis()], self.window.at(border)) == Sign::Positive
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
    fn cut(&mut self, border: Border, _: f32) -> Point {
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

/// As taught, in the rounded arithmetic `R`.
pub(super) struct Taught<R> {
    segment: Segment,
    /// p and q of each border.
    measured: [[R; 2]; 4],
    /// Numerator and denominator of each border's t, the denominator positive, once p was looked at.
    fractions: [[R; 2]; 4],
}

impl<R: Real> Taught<R> {
    pub(super) fn new(segment: Segment, window: &Window) -> Self {
        let measured = Border::ALL.map(|border| measured(segment, window, border));
        Self { segment, measured, fractions: [[R::ZERO, R::ONE]; 4] }
    }

    fn fraction(&self, parameter: Parameter) -> [R; 2] {
        match parameter {
            Parameter::Of(End::P1) => [R::ZERO, R::ONE],
            Parameter::Of(End::P2) => [R::ONE, R::ONE],
            Parameter::At(border) => self.fractions[border as usize],
        }
    }
}

impl<R: Real> Form for Taught<R> {
    type Quotient = R;

    fn course(&mut self, border: Border) -> Course {
        let [p, q] = self.measured[border as usize];
        let course = Course::outward(difference(p, R::ZERO));
        self.fractions[border as usize] = if course == Course::Enters { [-q, -p] } else { [q, p] };
        course
    }

    fn outside(&self, border: Border) -> bool {
        let [_, q] = self.measured[border as usize];
        q < R::ZERO
    }

    fn order(&mut self, a: Parameter, b: Parameter) -> Sign {
        let [[n1, d1], [n2, d2]] = [a, b].map(|parameter| self.fraction(parameter));
        difference(n1 * d2, n2 * d1)
    }

    fn divide(&mut self, border: Border) -> R {
        let [p, q] = self.measured[border as usize];
        q / p
    }

    fn cut(&mut self, _: Border, t: R) -> Point {
        point_at(self.segment, t)
    }

    fn given(&self) -> Segment {
        self.segment
    }
}
