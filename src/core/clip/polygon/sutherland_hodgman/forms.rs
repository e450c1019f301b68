//! The arithmetics in which the text of the algorithm runs.

use super::{
    super::outline::{Corner, Given, Place, Why, clear},
    Buffers,
};
use crate::{
    clip::line::{Border, Point},
    math::{Real, Tally},
};
use std::cmp::Ordering;

/// What decides and cuts.
pub(super) trait Form {
    /// A point during clipping.
    type At: Copy;
    /// The given polygon, and room for what a side emits.
    fn begin(&mut self, buffers: &mut Buffers) -> [Vec<Corner<Self::At>>; 2];
    /// On which side of a border a corner lies.
    fn place(&mut self, corner: &Corner<Self::At>, border: Border) -> Place;
    /// Where the edge from `s` to `e` crosses a border; `leaves` says that `e` is beyond it.
    fn cut(&mut self, s: &Corner<Self::At>, e: &Corner<Self::At>, border: Border, leaves: bool) -> Self::At;
    /// The point as it is shown.
    fn shown(at: Self::At) -> Point;
    /// Leaves the result in `buffers`.
    fn finish(
        &mut self,
        polygon: Vec<Corner<Self::At>>,
        out: Vec<Corner<Self::At>>,
        buffers: &mut Buffers,
        dropped: impl FnMut(usize, Why),
    );
}

/// Decisions and coordinates of the exact edges of the given polygon.
pub(super) struct Exact<'a> {
    given: Given<'a>,
    tally: &'a mut Tally,
}

impl<'a> Exact<'a> {
    pub(super) fn new(given: Given<'a>, tally: &'a mut Tally) -> Self {
        Self { given, tally }
    }
}

impl Form for Exact<'_> {
    type At = Point;

    fn begin(&mut self, buffers: &mut Buffers) -> [Vec<Corner>; 2] {
        let [mut polygon, out] = [&mut buffers.polygon, &mut buffers.out].map(std::mem::take);
        polygon.clear();
        polygon.extend(self.given.points.iter().enumerate().map(|(i, &at)| Corner::given(i, at)));
        [polygon, out]
    }

    #[inline]
    fn place(&mut self, corner: &Corner, border: Border) -> Place {
        self.given.place(corner, border, self.tally)
    }

    #[inline]
    fn cut(&mut self, s: &Corner, _: &Corner, border: Border, _: bool) -> Point {
        self.given.cut(s.next, border, self.tally)
    }

    #[inline]
    fn shown(at: Point) -> Point {
        at
    }

    fn finish(
        &mut self,
        mut polygon: Vec<Corner>,
        out: Vec<Corner>,
        buffers: &mut Buffers,
        dropped: impl FnMut(usize, Why),
    ) {
        self.given.tidy(&mut polygon, self.tally, dropped);
        (buffers.polygon, buffers.out) = (polygon, out);
    }
}

/// As taught: from the corners as they stand, in the rounded arithmetic `R`. A corner on the border is
/// inside and is emitted once more as a cut.
pub(super) struct Taught<'a, R> {
    given: Given<'a>,
    /// Whether a cut is computed from the inner end, whichever way the edge runs.
    inner_first: bool,
    arithmetic: std::marker::PhantomData<R>,
}

impl<'a, R: Real> Taught<'a, R> {
    pub(super) fn new(given: Given<'a>, inner_first: bool) -> Self {
        Self { given, inner_first, arithmetic: std::marker::PhantomData }
    }
}

impl<R: Real> Form for Taught<'_, R> {
    type At = [R; 2];

    fn begin(&mut self, _: &mut Buffers) -> [Vec<Corner<[R; 2]>>; 2] {
        let corner = |(i, at): (usize, &Point)| Corner::given(i, at.map(R::from_f32));
        [self.given.points.iter().enumerate().map(corner).collect(), Vec::new()]
    }

    fn place(&mut self, corner: &Corner<[R; 2]>, border: Border) -> Place {
        let c = R::from_f32(self.given.window.at(border));
        // What is not a number is on no side; it stays.
        let order = corner.at[border.axis()].partial_cmp(&c).unwrap_or(Ordering::Equal);
        match Place::of(order, border) {
            Place::Out => Place::Out,
            Place::In | Place::On => Place::In,
        }
    }

    fn cut(&mut self, s: &Corner<[R; 2]>, e: &Corner<[R; 2]>, border: Border, leaves: bool) -> [R; 2] {
        let (fixed, free) = (border.axis(), 1 - border.axis());
        let c = R::from_f32(self.given.window.at(border));
        let (p, q) = if leaves || !self.inner_first { (s.at, e.at) } else { (e.at, s.at) };
        let t = (c - p[fixed]) / (q[fixed] - p[fixed]);
        let mut at = [c; 2];
        at[free] = p[free] + t * (q[free] - p[free]);
        at
    }

    fn shown(at: [R; 2]) -> Point {
        at.map(R::to_f32)
    }

    fn finish(
        &mut self,
        polygon: Vec<Corner<[R; 2]>>,
        _: Vec<Corner<[R; 2]>>,
        buffers: &mut Buffers,
        mut dropped: impl FnMut(usize, Why),
    ) {
        let round = |corner: &Corner<[R; 2]>| Corner {
            at: Self::shown(corner.at),
            source: corner.source,
            next: corner.next,
        };
        buffers.polygon = polygon.iter().map(round).collect();
        if polygon.len() < 3 {
            clear(&mut buffers.polygon, &mut dropped);
        }
    }
}
