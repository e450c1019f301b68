//! The arithmetics in which the text of the algorithm runs.

use super::super::{End, Outcode, Point, Segment, Window, meets::meets};
use crate::math::{Dyadic, Real, Tally, expansion::two_sum, ulps_between};
use std::cmp::Ordering;

/// The line while it is halved.
pub(super) trait Form {
    /// The segment as it was given.
    fn given(&self) -> Segment;
    /// The code of a given end.
    fn code(&self, end: End) -> Outcode;
    /// Begins the search towards `end`: A is the other end, E this one.
    fn search(&mut self, end: End);
    /// Puts M half-way between A and E: its place, rounded, and its code.
    fn halve(&mut self) -> (Point, Outcode);
    /// A becomes M.
    fn keep(&mut self);
    /// E becomes M.
    fn drop(&mut self);
    /// Whether A and E are neighbours in binary32, or the same.
    fn is_closed(&self) -> bool;
    /// Whether the line has a visible point although A, next to where it would be, is none.
    fn touches(&mut self) -> bool;
    /// The last visible point, once the search is closed.
    fn found(&self) -> Point;
}

/// Whether two points are neighbours in binary32, along both axes.
fn neighbours(a: Point, e: Point) -> bool {
    (0..2).all(|axis| ulps_between(a[axis], e[axis]) <= 1)
}

/// A coordinate of any precision: a binary64 number for as long as one holds it.
#[derive(Clone, Debug)]
enum Coordinate {
    Double(f64),
    Long(Dyadic),
}

impl Coordinate {
    fn half_way(&self, other: &Self, tally: &mut Tally) -> Self {
        tally.calls += 1;
        if let (Self::Double(a), Self::Double(b)) = (self, other) {
            // Far from both ends of the exponent range: 280 halvings of 2^-149 are above 2^-430.
            let (sum, tail) = two_sum(*a, *b);
            if tail == 0.0 {
                return Self::Double(sum.half());
            }
        }
        tally.exact += 1;
        Self::Long((&self.long() + &other.long()).mul_pow2(-1))
    }

    fn long(&self) -> Dyadic {
        match self {
            Self::Double(x) => Dyadic::from(*x),
            Self::Long(x) => x.clone(),
        }
    }

    fn rounded(&self) -> f32 {
        match self {
            Self::Double(x) => x.to_f32() + 0.0,
            Self::Long(x) => Dyadic::ratio_to_f32(x, &Dyadic::one()),
        }
    }

    /// Compares with `border`, given its own rounding: that is monotone, so it nearly always tells.
    fn against(&self, rounded: f32, border: f32) -> Option<Ordering> {
        match (rounded.partial_cmp(&border), self) {
            (Some(Ordering::Equal), Self::Double(x)) => x.partial_cmp(&f64::from(border)),
            (Some(Ordering::Equal), Self::Long(x)) => Some(x.cmp(&Dyadic::from(border))),
            (told, _) => told,
        }
    }
}

/// A point of any precision, and its rounding.
#[derive(Clone, Debug)]
struct Place {
    at: [Coordinate; 2],
    rounded: Point,
}

impl Place {
    fn new(at: [Coordinate; 2]) -> Self {
        let rounded = [at[0].rounded(), at[1].rounded()];
        Self { at, rounded }
    }

    fn given(point: Point) -> Self {
        Self { at: point.map(|x| Coordinate::Double(x.into())), rounded: point }
    }

    fn code(&self, window: &Window) -> Outcode {
        let is =
            |axis: usize, side: f32, order| self.at[axis].against(self.rounded[axis], side) == Some(order);
        let Window { xmin, ymin, xmax, ymax } = *window;
        let (less, greater) = (Ordering::Less, Ordering::Greater);
        Outcode::from_bits([is(1, ymax, greater), is(1, ymin, less), is(0, xmax, greater), is(0, xmin, less)])
    }
}

/// Midpoints that are never rounded: sums and halves of binary numbers are binary numbers.
pub(super) struct Exact<'a> {
    segment: Segment,
    window: &'a Window,
    near: Place,
    far: Place,
    middle: Place,
    tally: &'a mut Tally,
}

impl<'a> Exact<'a> {
    pub(super) fn new(segment: Segment, window: &'a Window, tally: &'a mut Tally) -> Self {
        let [near, far] = segment.map(Place::given);
        Self { segment, window, middle: near.clone(), near, far, tally }
    }
}

impl Form for Exact<'_> {
    fn given(&self) -> Segment {
        self.segment
    }

    fn code(&self, end: End) -> Outcode {
        Place::given(self.segment[end as usize]).code(self.window)
    }

    fn search(&mut self, end: End) {
        [self.near, self.far] = [end.other(), end].map(|end| Place::given(self.segment[end as usize]));
    }

    fn halve(&mut self) -> (Point, Outcode) {
        let half_way = |axis: usize| self.near.at[axis].half_way(&self.far.at[axis], self.tally);
        self.middle = Place::new([0, 1].map(half_way));
        (self.middle.rounded, self.middle.code(self.window))
    }

    fn keep(&mut self) {
        self.near = self.middle.clone();
    }

    fn drop(&mut self) {
        self.far = self.middle.clone();
    }

    fn is_closed(&self) -> bool {
        neighbours(self.near.rounded, self.far.rounded)
    }

    fn touches(&mut self) -> bool {
        meets(self.segment, self.window, self.tally)
    }

    /// Between neighbours A and E lies a point of the window, so that A, if it is not one itself,
    /// is at most a step away from the window.
    fn found(&self) -> Point {
        [0, 1].map(|axis| {
            let [low, high] = self.window.sides(axis);
            self.near.rounded[axis].clamp(low, high)
        })
    }
}

/// As taught, in the rounded arithmetic `R`.
pub(super) struct Taught<R> {
    segment: Segment,
    window: [R; 4],
    near: [R; 2],
    far: [R; 2],
    middle: [R; 2],
}

impl<R: Real> Taught<R> {
    pub(super) fn new(segment: Segment, window: &Window) -> Self {
        let Window { xmin, ymin, xmax, ymax } = *window;
        let [near, far] = segment.map(|p| p.map(R::from_f32));
        Self { segment, window: [xmin, ymin, xmax, ymax].map(R::from_f32), near, far, middle: near }
    }
}

impl<R: Real> Form for Taught<R> {
    fn given(&self) -> Segment {
        self.segment
    }

    fn code(&self, end: End) -> Outcode {
        Outcode::of(self.segment[end as usize].map(R::from_f32), self.window)
    }

    fn search(&mut self, end: End) {
        [self.near, self.far] = [end.other(), end].map(|end| self.segment[end as usize].map(R::from_f32));
    }

    fn halve(&mut self) -> (Point, Outcode) {
        self.middle = [0, 1].map(|axis| (self.near[axis] + self.far[axis]).half());
        (self.middle.map(R::to_f32), Outcode::of(self.middle, self.window))
    }

    fn keep(&mut self) {
        self.near = self.middle;
    }

    fn drop(&mut self) {
        self.far = self.middle;
    }

    fn is_closed(&self) -> bool {
        neighbours(self.near.map(R::to_f32), self.far.map(R::to_f32))
    }

    fn touches(&mut self) -> bool {
        false
    }

    fn found(&self) -> Point {
        self.near.map(R::to_f32)
    }
}
