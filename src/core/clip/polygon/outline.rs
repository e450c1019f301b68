//! Outlines of polygons in the window's plane whose corners know where they come from.
//!
//! A corner is named by its source, an edge by what carries it: so every decision about a corner can
//! be made from the polygon as it was given, whatever rounding did to the coordinates in between.

use crate::{
    clip::line::{
        Border, Point, Segment, Window,
        intersection::{intersection, side_at},
    },
    math::{Sign, Tally, edge_value, orient2d},
};
use serde::Serialize;
use std::cmp::Ordering;

/// Where a corner comes from. Edge `i` runs from corner `i` of the given polygon to the next one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Source {
    /// A corner of the given polygon.
    Vertex(u32),
    /// A corner of the window: where these two borders meet.
    Window([Border; 2]),
    /// Where an edge of the given polygon crosses a border.
    Crossing {
        /// The edge.
        edge: u32,
        /// The border.
        border: Border,
    },
}

/// The line that an edge of an outline lies on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Carrier {
    /// An edge of the given polygon.
    Edge(u32),
    /// A border of the window.
    Border(Border),
}

/// A corner of an outline. `P` is a point in the arithmetic of the run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner<P = Point> {
    /// Where it is: an input corner bit for bit, or a cut rounded once.
    pub at: P,
    /// Where it comes from.
    pub source: Source,
    /// What carries the edge to the next corner.
    pub next: Carrier,
}

impl<P> Corner<P> {
    /// Corner `index` of the given polygon.
    #[inline]
    pub fn given(index: usize, at: P) -> Self {
        let index = index as u32;
        Self { at, source: Source::Vertex(index), next: Carrier::Edge(index) }
    }
}

/// On which side of a border a point lies. The window is closed: on the border is inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Place {
    /// On the inner side.
    In,
    /// Exactly on the border.
    On,
    /// Beyond the border.
    Out,
}

impl Place {
    /// From the order of a point's coordinate and the border's.
    #[inline]
    pub fn of(order: Ordering, border: Border) -> Self {
        let outward = if border.is_upper() { Ordering::Greater } else { Ordering::Less };
        match order {
            Ordering::Equal => Self::On,
            order if order == outward => Self::Out,
            _ => Self::In,
        }
    }
}

/// Closed contours as they were given, and the window: what every decision is made from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Given<'a> {
    /// The corners of all contours, one contour after the other.
    pub(super) points: &'a [Point],
    /// Where each contour starts.
    pub(super) starts: &'a [u32],
    pub(super) window: &'a Window,
}

impl<'a> Given<'a> {
    /// A single contour.
    pub(super) fn one(points: &'a [Point], window: &'a Window) -> Self {
        Self { points, starts: &[0], window }
    }

    /// The corner that follows in the same contour.
    #[inline]
    pub(super) fn next(&self, index: u32) -> u32 {
        let next = index + 1;
        let last = next as usize == self.points.len();
        match self.starts {
            [start] => {
                if last {
                    *start
                } else {
                    next
                }
            }
            starts if last || starts.binary_search(&next).is_ok() => {
                starts[starts.partition_point(|start| *start <= index) - 1]
            }
            _ => next,
        }
    }

    #[inline]
    pub(super) fn edge(&self, index: u32) -> Segment {
        [index, self.next(index)].map(|index| self.points[index as usize])
    }

    /// On which side of a border a corner lies, exactly.
    ///
    /// Rounding is monotone, so a rounded coordinate beside the border tells the side of the exact
    /// one; only of a cut that was rounded onto the border the original edge must be asked.
    #[inline]
    pub(super) fn place(&self, corner: &Corner, border: Border, tally: &mut Tally) -> Place {
        Place::of(self.compare(corner, border.axis(), self.window.at(border), tally), border)
    }

    /// The order of a corner's exact coordinate and a value.
    #[inline]
    pub(super) fn compare(&self, corner: &Corner, axis: usize, value: f32, tally: &mut Tally) -> Ordering {
        if corner.at[axis] < value {
            Ordering::Less
        } else if corner.at[axis] > value {
            Ordering::Greater
        } else {
            match corner.source {
                Source::Crossing { edge, border } if border.axis() != axis => {
                    match side_at(self.edge(edge), border, self.window, value, tally) {
                        Sign::Negative => Ordering::Less,
                        Sign::Zero => Ordering::Equal,
                        Sign::Positive => Ordering::Greater,
                    }
                }
                _ => Ordering::Equal,
            }
        }
    }

    /// Where what carries an edge meets a border that lies between the edge's ends.
    #[inline]
    pub(super) fn cut(&self, carrier: Carrier, border: Border, tally: &mut Tally) -> Point {
        match carrier {
            Carrier::Edge(edge) => intersection(self.edge(edge), border, self.window, tally),
            Carrier::Border(own) => self.window_corner([own, border]),
        }
    }

    /// Where two borders that are not parallel meet.
    pub(super) fn window_corner(&self, borders: [Border; 2]) -> Point {
        let mut at = [0.0; 2];
        borders.into_iter().for_each(|border| at[border.axis()] = self.window.at(border));
        at
    }

    /// Whether this coordinate stays the same along a carrier.
    #[inline]
    pub(super) fn is_level(&self, carrier: Carrier, axis: usize) -> bool {
        match carrier {
            Carrier::Border(border) => border.axis() == axis,
            Carrier::Edge(edge) => {
                let [p, q] = self.edge(edge);
                p[axis] == q[axis]
            }
        }
    }

    /// Whether a single given contour certainly turns at each of its corners, so that none needs to be
    /// asked whether an outline goes straight on there: one pass without a branch.
    fn turns(&self) -> bool {
        let ([_], [first, .., last]) = (self.starts, self.points) else { return false };
        let (first, last) = (*first, *last);
        let turns =
            |a: Point, b: Point, c: Point| edge_value(a, b, c).sign().is_some_and(|side| !side.is_zero());
        let inner = self.points.windows(3).fold(true, |all, p| all & turns(p[0], p[1], p[2]));
        inner && turns(self.points[self.points.len() - 2], last, first) && turns(last, first, self.points[1])
    }

    /// Whether the outline goes straight on at `b`: exact, since along an axis rounding keeps the order
    /// of different points, and elsewhere only given corners lie between two edges of one line.
    #[inline]
    fn is_straight(&self, [a, b, c]: [&Corner; 3], turns: bool, tally: &mut Tally) -> bool {
        let onward = |p: Point, q: Point, axis: usize, r: Point| {
            p[axis] < q[axis] && q[axis] < r[axis] || p[axis] > q[axis] && q[axis] > r[axis]
        };
        if let (Carrier::Edge(i), Carrier::Edge(j)) = (a.next, b.next) {
            if turns {
                return false;
            }
            // What was dropped before lies on their lines: `b` is where the first one ends, and the second
            // one starts there or further on.
            let ([p, end], [_, r]) = (self.edge(i), self.edge(j));
            return end == b.at
                && orient2d(p, b.at, r, tally).is_zero()
                && (onward(p, b.at, 0, r) || onward(p, b.at, 1, r));
        }
        (0..2).any(|level| {
            [a, b].into_iter().all(|corner| self.is_level(corner.next, level))
                && onward(a.at, b.at, 1 - level, c.at)
        })
    }

    /// Drops corners that repeat the one before them, and those at which the outline goes straight on.
    /// Nothing is left of an outline that lies on one line, nor of one with fewer than three places.
    ///
    /// `dropped` hears of each corner's index among those that are left at that time.
    pub(super) fn tidy(
        &self,
        corners: &mut Vec<Corner>,
        tally: &mut Tally,
        mut dropped: impl FnMut(usize, Why),
    ) {
        let turns = self.turns();
        if self.is_on_one_line(corners, turns, tally) {
            return clear(corners, &mut dropped);
        }
        let mut kept = 0;
        for read in 0..corners.len() {
            let corner = corners[read];
            if kept > 0 && corners[kept - 1].at == corner.at {
                corners[kept - 1].absorb(&corner);
                dropped(kept, Why::Repeats);
                continue;
            }
            if kept > 1 && self.is_straight([&corners[kept - 2], &corners[kept - 1], &corner], turns, tally) {
                kept -= 1;
                corners[kept - 1].next = corners[kept].next;
                dropped(kept, Why::Straight);
            }
            corners[kept] = corner;
            kept += 1;
        }
        corners.truncate(kept);
        self.close(corners, turns, tally, &mut dropped);
        // Rounding can lay what is left on a border.
        let flat = |axis: usize| corners.iter().all(|corner| corner.at[axis] == corners[0].at[axis]);
        if corners.len() < 3 || flat(0) || flat(1) {
            clear(corners, &mut dropped);
        }
    }

    /// The same where the end of the list meets its start.
    fn close(
        &self,
        corners: &mut Vec<Corner>,
        turns: bool,
        tally: &mut Tally,
        dropped: &mut impl FnMut(usize, Why),
    ) {
        while corners.len() > 2 {
            let last = corners.len() - 1;
            let (index, why) = if corners[last].at == corners[0].at {
                (last, Why::Repeats)
            } else if self.is_straight([&corners[last - 1], &corners[last], &corners[0]], turns, tally) {
                (last, Why::Straight)
            } else if self.is_straight([&corners[last], &corners[0], &corners[1]], turns, tally) {
                (0, Why::Straight)
            } else {
                return;
            };
            drop_corner(corners, index, why);
            dropped(index, why);
        }
    }

    /// Whether the whole outline lies on one line, exactly.
    fn is_on_one_line(&self, corners: &[Corner], turns: bool, tally: &mut Tally) -> bool {
        let level = |axis: usize| corners.iter().all(|corner| self.is_level(corner.next, axis));
        if level(0) || level(1) {
            return true;
        }
        if turns {
            return false;
        }
        let first = self.points[0];
        let Some(&second) = self.points.iter().find(|&&point| point != first) else { return true };
        self.points.iter().all(|&third| orient2d(first, second, third, tally).is_zero())
    }
}

/// Drops every corner, the last one first.
pub(super) fn clear<P>(corners: &mut Vec<Corner<P>>, dropped: &mut impl FnMut(usize, Why)) {
    (0..corners.len()).rev().for_each(|index| dropped(index, Why::NoArea));
    corners.clear();
}

/// Why a corner of the result is dropped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Why {
    /// It is where the one before it is, or was rounded there.
    Repeats,
    /// The outline goes straight on.
    Straight,
    /// The whole result lies on one line, or less than three places are left of it.
    NoArea,
}

/// Drops one corner from an outline. A corner at the same place takes over its edge; where the outline
/// goes straight on, the corner before it does.
pub(super) fn drop_corner(corners: &mut Vec<Corner>, index: usize, why: Why) {
    let corner = corners.remove(index);
    if corners.is_empty() {
        return;
    }
    let before = index.checked_sub(1).unwrap_or(corners.len() - 1);
    match why {
        Why::Repeats if corners[before].at == corner.at => corners[before].absorb(&corner),
        Why::Repeats => {
            let after = index % corners.len();
            let twin = &mut corners[after];
            let next = twin.next;
            twin.absorb(&corner);
            twin.next = next;
        }
        Why::Straight => corners[before].next = corner.next,
        Why::NoArea => {}
    }
}

impl Corner {
    /// Takes the place of `later`, which is at the same point. A given corner keeps its bits, and of two
    /// that differ in the sign of a zero one is chosen by its bits: the direction cannot matter.
    fn absorb(&mut self, later: &Self) {
        let rank = |corner: &Self| {
            let given = !matches!(corner.source, Source::Vertex(_));
            let [x, y] = corner.at.map(f32::to_bits);
            (given, x, y, corner.source)
        };
        if rank(later) < rank(self) {
            (self.at, self.source) = (later.at, later.source);
        }
        self.next = later.next;
    }
}
