//! Where nobody watches: what lies inside is copied, and only the detours around it are clipped.
//!
//! A side looks at one edge after the other and keeps what is not beyond it. So a corner that is inside
//! all sides comes through all of them, and what becomes of the corners between two such corners, a
//! detour, depends on these alone. Most detours lead beyond one side, which gives two cuts, or around one
//! corner of the window. The others, and whatever needs more than outcodes to decide, go through the text
//! of the algorithm. The laws compare both, bit for bit.

use super::{
    super::outline::{Carrier, Corner, Given, Source},
    Exact, SideOrder, clip_side,
};
use crate::{
    clip::line::{Border, Outcode, Point, Window, intersection::intersection},
    math::{Sign, Tally, orient2d},
    trace::NoTrace,
};
use std::array::from_fn;
use wide::{f32x4, f32x8};

/// Lists that are used again.
#[derive(Clone, Debug, Default)]
pub(super) struct Room {
    /// The sides beyond which some corner of the last polygon was: the others change nothing.
    pub(super) some: Outcode,
    codes: Vec<u8>,
    tail: Vec<Point>,
    polygon: Vec<Corner>,
    out: Vec<Corner>,
}

/// Clips a polygon; `None` where the text must do it: if no corner is inside, if the outline may go
/// straight on at one, or if corners fall together. What is in `out` then means nothing.
pub(super) fn clip(polygon: &[Point], window: &Window, room: &mut Room, out: &mut Vec<Point>) -> Option<()> {
    let [some, every] = outcodes(polygon, window, &mut room.codes);
    room.some = Outcode(some);
    if every != 0 {
        return Some(());
    }
    if !turns(polygon) {
        return None;
    }
    if some == 0 {
        out.extend_from_slice(polygon);
        return Some(());
    }
    let Room { codes, tail, polygon: corners, out: kept, .. } = room;
    let is_inside = |code: &u8| *code == 0;
    let first = codes.iter().position(is_inside)?;
    let mut detours = Detours { given: Given::one(polygon, window), codes, corners, kept };
    let mut end = codes.len();
    tail.clear();
    if first > 0 {
        // The list starts within a detour: what lies before the start comes last.
        end = codes.iter().rposition(is_inside)? + 1;
        let beyond = codes[end..].iter().chain(&codes[..first]);
        let split = detours.clip([end - 1, first], beyond, out)?;
        tail.extend(out.drain(..split));
    }
    let mut at = first;
    while at < end {
        let leaves = codes[at..end].iter().position(|code| !is_inside(code)).map_or(end, |i| at + i);
        out.extend_from_slice(&polygon[at..leaves]);
        at = leaves;
        if leaves < end {
            at = codes[leaves..].iter().position(is_inside).map_or(end, |i| leaves + i);
            detours.clip([leaves - 1, at % codes.len()], codes[leaves..at].iter(), out)?;
        }
    }
    out.extend_from_slice(tail);
    let is_flat = |axis: usize| out.iter().all(|point| point[axis] == out[0][axis]);
    (!is_flat(0) && !is_flat(1)).then_some(())
}

/// What clips the detours of one polygon.
struct Detours<'a> {
    given: Given<'a>,
    codes: &'a [u8],
    corners: &'a mut Vec<Corner>,
    kept: &'a mut Vec<Corner>,
}

/// A corner of the window that a detour may go around.
struct Around {
    at: Point,
    /// The bits of its vertical and its horizontal side.
    bits: [u8; 2],
    /// The sides.
    sides: [Border; 2],
    /// Whether going around it counter-clockwise leads from the horizontal to the vertical side.
    from_horizontal: bool,
}

/// How a detour goes around a corner of the window.
enum Way {
    /// Outside all the way, and never back.
    Outside,
    /// Through the window, along this edge.
    Through(usize),
    /// Otherwise.
    Other,
}

impl Detours<'_> {
    /// Clips the detour from one corner inside to the next one inside. Returns how many of the corners it
    /// emits lie before the start of the list.
    #[inline]
    fn clip<'c>(
        &mut self,
        [from, to]: [usize; 2],
        beyond: impl DoubleEndedIterator<Item = &'c u8> + Clone,
        out: &mut Vec<Point>,
    ) -> Option<usize> {
        let ends = [from, to].map(|index| self.given.points[index]);
        let edges = [from, to.checked_sub(1).unwrap_or(self.codes.len() - 1)];
        let some = beyond.clone().fold(0, |some, code| some | code);
        if let Some(border) = single(some) {
            emit(ends, edges.map(|edge| self.cut(edge, border)), out)?;
            return Some(1);
        }
        let Some(around) = self.around(some) else { return self.clip_by_sides([from, to], some, out) };
        let codes = [*beyond.clone().next()?, *beyond.clone().next_back()?];
        match self.way(beyond, from, codes, &around)? {
            Way::Outside => {
                let sides = [
                    self.side(edges[0], codes[0], true, &around)?,
                    self.side(edges[1], codes[1], false, &around)?,
                ];
                let [leaves, enters] = from_fn(|i| self.cut(edges[i], sides[i]));
                if sides[0] == sides[1] {
                    emit(ends, [leaves, enters], out)?;
                    return Some(1);
                }
                emit(ends, [leaves, around.at, enters], out)?;
                // The horizontal side, which cuts later, emits it on the way between the cuts at the
                // vertical one. Are these after the start?
                let [vertical, _] = around.bits;
                Some(if self.codes[0] & vertical == 0 && codes[1] & vertical != 0 { 1 } else { 2 })
            }
            Way::Through(edge) => {
                let [leaves, enters] = codes.map(single);
                let (leaves, enters) = (leaves?, enters?);
                let cuts = [(edges[0], leaves), (edge, leaves), (edge, enters), (edges[1], enters)];
                emit(ends, cuts.map(|(edge, border)| self.cut(edge, border)), out)?;
                Some(if edge < from { 1 } else { 3 })
            }
            Way::Other => self.clip_by_sides([from, to], some, out),
        }
    }

    fn cut(&self, edge: usize, border: Border) -> Point {
        intersection(self.given.edge(edge as u32), border, self.given.window, &mut Tally::default())
    }

    /// The corner of the window between the two sides that a detour leads beyond, if it is two.
    fn around(&self, some: u8) -> Option<Around> {
        let bits = [some & 0b0011, some & 0b1100];
        let sides = [single(bits[0])?, single(bits[1])?];
        let from_horizontal = (sides[0] == Border::Left) != (sides[1] == Border::Bottom);
        Some(Around { at: self.given.window_corner(sides), bits, sides, from_horizontal })
    }

    /// Which side a corner of the window lies on of an edge; `None` if on it.
    fn passes(&self, edge: usize, corner: Point) -> Option<Sign> {
        let [p, q] = self.given.edge(edge as u32);
        let side = orient2d(p, q, corner, &mut Tally::default());
        (!side.is_zero()).then_some(side)
    }

    /// The corners beyond the one side come first, then those beyond both, then those beyond the other.
    fn way<'c>(
        &self,
        beyond: impl Iterator<Item = &'c u8>,
        from: usize,
        [start, end]: [u8; 2],
        around: &Around,
    ) -> Option<Way> {
        let [vertical, horizontal] = around.bits;
        let both = vertical | horizontal;
        let before = if start == both { both ^ end } else { start };
        let (mut previous, mut way) = (0, Way::Outside);
        for (i, code) in beyond.enumerate() {
            let rank = if *code == both {
                1
            } else if *code == before {
                0
            } else {
                2
            };
            if rank < previous {
                return Some(Way::Other);
            }
            if rank == 2 && previous == 0 {
                let edge = (from + i) % self.codes.len();
                let counter_clockwise = around.from_horizontal == (before == horizontal);
                if self.passes(edge, around.at)?.is_positive() != counter_clockwise {
                    if single(start).is_none() || single(end).is_none() {
                        return Some(Way::Other);
                    }
                    way = Way::Through(edge);
                }
            }
            previous = rank;
        }
        Some(way)
    }

    /// The side across which an edge leaves or enters the window, if its outer end has this code.
    fn side(&self, edge: usize, code: u8, leaves: bool, around: &Around) -> Option<Border> {
        let [vertical, horizontal] = around.sides;
        Some(match single(code) {
            Some(border) => border,
            None if (self.passes(edge, around.at)?.is_positive() == leaves) == around.from_horizontal => {
                horizontal
            }
            None => vertical,
        })
    }

    /// A detour through the text of the algorithm.
    fn clip_by_sides(&mut self, [from, to]: [usize; 2], some: u8, out: &mut Vec<Point>) -> Option<usize> {
        let (len, wraps) = (self.codes.len(), to > 0 && to <= from);
        let corner = |index: usize| Corner::given(index, self.given.points[index]);
        self.corners.clear();
        if wraps {
            // The list starts where the given one does; what lies inside is left out.
            self.corners.extend((0..=to).chain(from..len).map(corner));
        } else {
            let after = if to == 0 { len } else { to };
            self.corners.extend((from..after).chain([to]).map(corner));
        }
        let mut tally = Tally::default();
        let mut form = Exact::new(self.given, &mut tally);
        for border in SideOrder::default().sides() {
            if Outcode(some).has(border) {
                clip_side(&mut form, border, self.corners, self.kept, &mut NoTrace);
                std::mem::swap(self.corners, self.kept);
            }
        }
        let given = |corner: &Corner, index: usize| corner.source == Source::Vertex(index as u32);
        let level = |corner: &Corner| [0, 1].map(|axis| self.given.is_level(corner.next, axis));
        let pairs = self.corners.iter().zip(self.corners.iter().cycle().skip(1));
        for (p, q) in pairs {
            let joint = given(p, to) && given(q, from);
            let ([px, py], [qx, qy]) = (level(p), level(q));
            if !joint && (p.at == q.at || px && qx || py && qy) {
                return None;
            }
        }
        let [before, after] = if wraps {
            let middle = self.corners.iter().position(|corner| given(corner, to))?;
            let (after, before) = self.corners.split_at(middle + 1);
            [before, &after[..middle]]
        } else {
            [&self.corners[..self.corners.len() - 1], &[]]
        };
        let (from_corner, before) = before.split_first()?;
        if from_corner.next != Carrier::Edge(from as u32) {
            return None;
        }
        out.extend(before.iter().chain(after).map(|corner| corner.at));
        Some(before.len())
    }
}

/// Emits the cuts of a detour; `None` if two corners fall together, of which one is to be dropped.
fn emit<const N: usize>([from, to]: [Point; 2], cuts: [Point; N], out: &mut Vec<Point>) -> Option<()> {
    let mut before = from;
    let mut apart = true;
    for point in cuts {
        apart &= point != before;
        before = point;
    }
    out.extend(cuts);
    (apart && before != to).then_some(())
}

/// The border of a code with one bit.
fn single(code: u8) -> Option<Border> {
    match code {
        0b0001 => Some(Border::Left),
        0b0010 => Some(Border::Right),
        0b0100 => Some(Border::Bottom),
        0b1000 => Some(Border::Top),
        _ => None,
    }
}

/// The outcodes of all corners; returns the bits that some have and those that all have.
fn outcodes(polygon: &[Point], window: &Window, codes: &mut Vec<u8>) -> [u8; 2] {
    let Window { xmin, ymin, xmax, ymax } = *window;
    let (min, max) = (f32x4::new([xmin, ymin, xmin, ymin]), f32x4::new([xmax, ymax, xmax, ymax]));
    let both = |[[x1, y1], [x2, y2]]: [Point; 2]| {
        let ends = f32x4::new([x1, y1, x2, y2]);
        let (below, above) = (ends.simd_lt(min), ends.simd_gt(max));
        [below.unpack_lo(above), below.unpack_hi(above)].map(|bits| bits.to_bitmask() as u8)
    };
    codes.clear();
    codes.resize(polygon.len(), 0);
    let ((pairs, rest), (code_pairs, code_rest)) = (polygon.as_chunks(), codes.as_chunks_mut());
    let (mut some, mut every) = ([0; 2], [0b1111; 2]);
    for (codes, pair) in code_pairs.iter_mut().zip(pairs) {
        *codes = both(*pair);
        some = from_fn(|i| some[i] | codes[i]);
        every = from_fn(|i| every[i] & codes[i]);
    }
    for (code, point) in code_rest.iter_mut().zip(rest) {
        [*code, _] = both([*point; 2]);
        (some[0], every[0]) = (some[0] | *code, every[0] & *code);
    }
    [some[0] | some[1], every[0] & every[1]]
}

/// A turn is certain if the difference of the two products is greater than this part of their sum: with
/// u = 2^-24 each is off by less than 3.1 u of itself, and their difference and sum by u.
const CERTAIN: f32 = 8.0 * (f32::EPSILON / 2.0);

/// The products' sum from which on underflow, 2^-150 at most each, does not matter.
const LARGE: f32 = 1e-30;

/// Whether the outline certainly turns at each corner: a filter in binary32 without a branch. Overflow
/// makes it uncertain.
fn turns(polygon: &[Point]) -> bool {
    let [first, second, .., before, last] = *polygon else {
        return matches!(*polygon, [a, b, c] if turns_at([a, b, c]));
    };
    let around_the_start = turns_at([before, last, first]) & turns_at([last, first, second]);
    // Four corners at a time.
    let flat = polygon.as_flattened();
    let mut done = 0;
    // Of a mask only the sign bits are read.
    let mut all = f32x8::splat(-0.0);
    while let Some(points) = flat[done..].first_chunk::<12>() {
        let here: [_; 8] = from_fn(|i| points[i + 2] - points[i]);
        let next: [_; 8] = from_fn(|i| points[i + 4] - points[i + 2]);
        let products: [_; 8] = from_fn(|i| here[i] * next[i ^ 1]);
        let sums = f32x8::new(from_fn(|i| products[i].abs() + products[i ^ 1].abs()));
        let sides = f32x8::new(from_fn(|i| (products[i] - products[i ^ 1]).abs()));
        all = all & sides.simd_gt(sums * f32x8::splat(CERTAIN)) & sums.simd_gt(f32x8::splat(LARGE));
        done += 8;
    }
    let rest = polygon[done / 2..].windows(3).fold(true, |all, p| all & turns_at([p[0], p[1], p[2]]));
    around_the_start & rest & (all.to_bitmask() == 0xFF)
}

fn turns_at([[ax, ay], [bx, by], [cx, cy]]: [Point; 3]) -> bool {
    let (left, right) = ((bx - ax) * (cy - by), (by - ay) * (cx - bx));
    let sum = left.abs() + right.abs();
    ((left - right).abs() > CERTAIN * sum) & (sum > LARGE)
}
