//! Where the contours cross the border of the window, in the order around it.
//!
//! The window's sides stand at xmin + ε, ymin + ε², xmax − ε, ymax − ε². No input lies there, so
//! every comparison and every sign below has an answer other than "equal": the first term in which
//! the two differ, and each such term is the sign of an expression in the given coordinates.

use super::{
    super::outline::{Carrier, Corner, Given, Source},
    Event, ROUND,
};
use crate::{
    clip::line::{Border, Point, Segment, intersection::intersection},
    math::{Dyadic, Sign, Tally, orient2d},
    trace::Tracer,
};
use std::{
    cmp::Ordering,
    ops::{Range, RangeInclusive},
};

/// A place where an edge crosses a border.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    /// Rounded once; an end of the edge that lies on the border bit for bit.
    pub(super) at: Point,
    pub(super) source: Source,
    pub(super) edge: u32,
    pub(super) border: Border,
    /// Whether the edge comes into the window.
    pub(super) enters: bool,
}

impl Crossing {
    /// As a corner from which the ring goes along a border.
    pub(super) fn corner(&self, along: Border) -> Corner {
        Corner { at: self.at, source: self.source, next: Carrier::Border(along) }
    }
}

/// All crossings, linked in two lists: along the contours and around the window.
#[derive(Clone, Debug)]
pub(super) struct Crossings {
    /// Along the contours.
    pub(super) list: Vec<Crossing>,
    /// Which of the list belong to each contour.
    contours: Vec<Range<usize>>,
    /// Around the window: indices of the list.
    round: Vec<usize>,
    /// Where each of the list is in `round`.
    rank: Vec<usize>,
    /// How often the contours wind around the lower left corner.
    pub(super) winding: i32,
}

impl Crossings {
    pub(super) fn find<T: Tracer<Event>>(given: &Given<'_>, tally: &mut Tally, t: &mut T) -> Self {
        let mut list: Vec<Crossing> = Vec::new();
        let mut contours = Vec::new();
        for contour in 0..given.starts.len() {
            let first = list.len();
            for edge in given.contour(contour) {
                t.emit(|| Event::Edge { edge });
                let own = given.crossings(edge, tally);
                for crossing in own.into_iter().flatten() {
                    let Crossing { at, edge, border, enters, .. } = crossing;
                    t.emit(|| Event::Cross { at, edge, border, enters });
                    list.push(crossing);
                }
            }
            contours.push(first..list.len());
        }
        let winding = given.winding_at_origin(tally);
        t.emit(|| Event::Origin { winding });
        let mut round: Vec<usize> = (0..list.len()).collect();
        round.sort_by(|&i, &j| given.order_around(&list[i], &list[j], tally).then(i.cmp(&j)));
        let mut rank = vec![0; list.len()];
        round.iter().enumerate().for_each(|(place, &crossing)| rank[crossing] = place);
        let found = Self { list, contours, round, rank, winding };
        for (place, &crossing) in found.round.iter().enumerate() {
            t.emit(|| Event::Next { crossing: crossing as u32, inside: found.is_inside_after(place) });
        }
        found
    }

    /// The crossings of a contour, in its order: entering and leaving by turns.
    pub(super) fn of_contour(&self, contour: usize) -> Range<usize> {
        self.contours[contour].clone()
    }

    /// The other end of the part of the contour that is inside the window.
    pub(super) fn partner(&self, crossing: usize) -> usize {
        let own = self.contours.partition_point(|range| range.end <= crossing);
        let Range { start, end } = self.contours[own];
        if self.list[crossing].enters {
            if crossing + 1 == end { start } else { crossing + 1 }
        } else if crossing == start {
            end - 1
        } else {
            crossing - 1
        }
    }

    /// Whether the border behind the crossing at this place around the window is inside the contours.
    fn is_inside_after(&self, place: usize) -> bool {
        (self.winding % 2 != 0) != place.is_multiple_of(2)
    }

    /// Where the part of the border that is inside leads to from a crossing; the corners of the window
    /// in between, each with the border after it.
    pub(super) fn along_border(&self, crossing: usize) -> (usize, Vec<(u8, Border)>) {
        let (place, count) = (self.rank[crossing], self.round.len());
        let forward = self.is_inside_after(place);
        let next = if forward { place + 1 } else { place + count - 1 } % count;
        let (low, high) = if forward { (place, next) } else { (next, place) };
        let side = |place: usize| self.list[self.round[place]].border;
        let corners = corners_between(side(low), side(high), low < high);
        let turns = corners.map(|corner| {
            let after = if forward { corner } else { corner + 3 } % 4;
            ((corner % 4) as u8, ROUND[after])
        });
        let mut turns: Vec<_> = turns.collect();
        if !forward {
            turns.reverse();
        }
        (self.round[next], turns)
    }
}

/// The corners of the window from a crossing of one border on to one of another, counted on beyond the
/// fourth. From the last crossing around the window to the first, not in order, the way leads over the
/// corner where counting starts.
pub(super) fn corners_between(from: Border, to: Border, in_order: bool) -> RangeInclusive<usize> {
    let side = |border: Border| ROUND.iter().position(|&other| other == border).unwrap_or_default();
    side(from) + 1..=side(to) + if in_order { 0 } else { 4 }
}

impl Given<'_> {
    /// What a crossing is: an end of the edge that lies on the border, or a new corner.
    pub(super) fn source_at(&self, edge: u32, border: Border) -> Source {
        let on_border = |corner: &u32| self.points[*corner as usize][border.axis()] == self.window.at(border);
        let end = [edge, self.next(edge)].into_iter().find(on_border);
        end.map_or(Source::Crossing { edge, border }, Source::Vertex)
    }

    /// The corners of a contour, which are also its edges.
    pub(super) fn contour(&self, index: usize) -> Range<u32> {
        let end = self.starts.get(index + 1).copied().unwrap_or(self.points.len() as u32);
        self.starts[index]..end
    }

    /// Whether a given corner is inside the window; on a border it is not.
    pub(super) fn is_inside(&self, corner: u32) -> bool {
        Border::ALL.into_iter().all(|border| self.is_within(self.points[corner as usize], border))
    }

    /// Whether a given point is on the inner side of a border.
    fn is_within(&self, point: Point, border: Border) -> bool {
        let (value, c) = (point[border.axis()], self.window.at(border));
        if border.is_upper() { value < c } else { value > c }
    }

    /// On which side of an edge a corner of the window lies, counted counter-clockwise.
    ///
    /// `(q − p) × (c − p)`, where `c` is moved inward by (ε, ε²): if it vanishes, its derivative by
    /// ε decides, which is -dy or dy, then that by ε², dx or -dx.
    fn side_of_corner(&self, [p, q]: Segment, corner: usize, tally: &mut Tally) -> Sign {
        let exact = orient2d(p, q, self.window.corners()[corner], tally);
        if !exact.is_zero() {
            return exact;
        }
        let [right, top] = [[1, 2].contains(&corner), [2, 3].contains(&corner)];
        let delta = |axis: usize| Sign::of(f64::from(q[axis]) - f64::from(p[axis]));
        match (delta(1), delta(0)) {
            (Sign::Zero, dx) => {
                if top {
                    -dx
                } else {
                    dx
                }
            }
            (dy, _) => {
                if right {
                    dy
                } else {
                    -dy
                }
            }
        }
    }

    /// Where an edge crosses the border: nowhere, once or, entering first, twice.
    fn crossings(&self, edge: u32, tally: &mut Tally) -> [Option<Crossing>; 2] {
        let segment = self.edge(edge);
        let [p, q] = segment;
        let mut found = [None; 2];
        for (side, border) in ROUND.into_iter().enumerate() {
            let enters = match [p, q].map(|point| self.is_within(point, border)) {
                [false, true] => true,
                [true, false] => false,
                _ => continue,
            };
            let ends = [side, (side + 1) % 4].map(|corner| self.side_of_corner(segment, corner, tally));
            if ends[0] == ends[1] {
                continue;
            }
            let source = self.source_at(edge, border);
            let at = match source {
                Source::Vertex(corner) => self.points[corner as usize],
                _ => intersection(segment, border, self.window, tally),
            };
            found[usize::from(!enters)] = Some(Crossing { at, source, edge, border, enters });
        }
        found
    }

    /// How often the contours wind around the lower left corner: along a ray from it to the left.
    fn winding_at_origin(&self, tally: &mut Tally) -> i32 {
        let mut winding = 0;
        for edge in 0..self.points.len() as u32 {
            let [p, q] = self.edge(edge);
            let above = [p, q].map(|point| point[1] > self.window.ymin);
            let turn = match above {
                [false, true] => Sign::Negative,
                [true, false] => Sign::Positive,
                _ => continue,
            };
            if self.side_of_corner([p, q], 0, tally) == turn {
                winding += if above[1] { -1 } else { 1 };
            }
        }
        winding
    }

    /// Which of two crossings comes first around the window.
    fn order_around(&self, a: &Crossing, b: &Crossing, tally: &mut Tally) -> Ordering {
        let side = |crossing: &Crossing| ROUND.iter().position(|border| *border == crossing.border);
        side(a).cmp(&side(b)).then_with(|| {
            let along = self.order_along(a, b, tally);
            if matches!(a.border, Border::Top | Border::Left) { along.reverse() } else { along }
        })
    }

    /// The order of two crossings of one border: by place, of equal places by the slope.
    fn order_along(&self, a: &Crossing, b: &Crossing, tally: &mut Tally) -> Ordering {
        let (fixed, free) = (a.border.axis(), 1 - a.border.axis());
        if a.at[free] != b.at[free] {
            return a.at[free].total_cmp(&b.at[free]); // rounding keeps the order
        }
        tally.calls += 1;
        tally.exact += 1;
        let c = Dyadic::from(self.window.at(a.border));
        let [(place_a, slope_a, run_a), (place_b, slope_b, run_b)] = [a, b].map(|crossing| {
            let [p, q] = self.edge(crossing.edge).map(|point| [point[fixed], point[free]].map(Dyadic::from));
            let run = &q[0] - &p[0];
            let place = &p[1] * &(&q[0] - &c) + &q[1] * &(&c - &p[0]);
            let slope = &q[1] - &p[1];
            if run.sign().is_negative() { (-place, -slope, -run) } else { (place, slope, run) }
        });
        let inward = |order: Ordering| if a.border.is_upper() { order.reverse() } else { order };
        (&place_a * &run_b)
            .cmp(&(&place_b * &run_a))
            .then_with(|| inward((&slope_a * &run_b).cmp(&(&slope_b * &run_a))))
    }
}
