//! All decisions about a line at once: the fast call of this stage.
//!
//! The taught algorithms take one decision after the other, and what no processor can foresee costs more
//! than all the arithmetic. But the answer depends on the line and the window alone, not on who finds it.
//! So here no branch depends on where a line lies, except where nothing is left to cut, or where binary64
//! does not decide. The taught algorithms answer the same, bit for bit.
//!
//! *What is visible.* Once neither both ends lie beyond one border nor both inside, something is visible
//! if and only if the window's corners are not all strictly on one side of the line: four orientations
//! from the given ends, which share their products.
//!
//! *Which border cuts.* An end beyond one border is cut there. An end beyond two is cut at the one or the
//! other, and on which side of the line their corner is says at which. The rest is looking up.
//!
//! *Where.* The orientations' products are the numerators of the crossings, too. A processor divides four
//! numbers nearly as fast as one, so there are four quotients, of which at most two are used.
//!
//! *Source:* Skala 2023 (doi 10.15388/23-INFOR508) for clipping by the sides of the corners; Ericson,
//! Real-Time Collision Detection, 2005, section 5.3.3, for the separating axes; Ziv 1991 for the rounding
//! test. The table is ours.

use super::{
    Border, Kept, Segment, Window,
    intersection::{ERROR, intersection},
};
use crate::math::{Sign, Tally, orient2d, predicates::ORIENT2D_FILTER};
use std::array::from_fn;
use wide::{f32x4, f64x4};

/// An answer without a branch: [`visible`](Self::visible) says whether the segment means anything.
#[derive(Clone, Copy)]
struct Part {
    /// The ends, in the order given.
    segment: Segment,
    /// Whether something is visible.
    visible: bool,
}

impl From<Part> for Option<Segment> {
    #[inline(always)]
    fn from(part: Part) -> Self {
        // Not `then_some`, which the compiler makes a branch.
        let mut answer = Some(part.segment);
        if !part.visible {
            answer = None;
        }
        answer
    }
}

/// Keeps the bound above zero: no crossing at zero is certain, because its sign is to be looked at.
const TINY: f64 = 1e-290;

/// Clips a segment of finite coordinates against a window: `None` if no point of it is inside.
///
/// The answer is exact, and that of every algorithm of this stage. A segment of length zero is a point.
/// Costs two comparisons of four lanes if it is wholly inside or beyond one border, else four
/// orientations and four quotients at once, about 8 ns.
///
/// Inlined: where there is nothing to cut, a call would cost more than the rest.
#[inline(always)]
pub fn clip(segment: Segment, window: &Window) -> Option<Segment> {
    part(&segment, window).into()
}

/// [`clip`] for each of many segments: appends what is visible of them, in order, with their indices.
///
/// Allocates only if `kept` has no room for all of them.
pub fn clip_all(segments: &[Segment], window: &Window, kept: &mut Vec<Kept>) {
    const ROOM: usize = 64;
    kept.reserve(segments.len());
    // Whether a segment is kept decides how far the next one is written, not whether to jump.
    let mut room = [Kept { index: 0, segment: [[0.0; 2]; 2] }; ROOM];
    let mut index = 0;
    for some in segments.chunks(ROOM) {
        let mut count = 0;
        for given in some {
            let Part { segment, visible } = part(given, window);
            room[count % ROOM] = Kept { index, segment };
            count += usize::from(visible);
            index += 1;
        }
        kept.extend_from_slice(&room[..count]);
    }
}

/// The visible part of a segment of finite coordinates.
#[inline(always)]
fn part(segment: &Segment, window: &Window) -> Part {
    let [[x1, y1], [x2, y2]] = *segment;
    let Window { xmin, ymin, xmax, ymax } = *window;
    let ends = f32x4::new([x1, y1, x2, y2]);
    let below = ends.simd_lt(f32x4::new([xmin, ymin, xmin, ymin]));
    let above = ends.simd_gt(f32x4::new([xmax, ymax, xmax, ymax]));
    // The bits of both outcodes.
    let [code1, code2] = [below.unpack_lo(above), below.unpack_hi(above)].map(f32x4::to_bitmask);
    if code1 & code2 != 0 {
        return Part { segment: [[0.0; 2]; 2], visible: false };
    }
    if code1 | code2 == 0 {
        return Part { segment: *segment, visible: true };
    }

    let [[x1, y1], [x2, y2]] = segment.map(|p| p.map(f64::from));
    let (dx, dy) = (x2 - x1, y2 - y1);
    let borders = Border::ALL.map(|border| f64::from(window.at(border)));
    let across: [_; 4] = from_fn(|i| borders[i] - [y1, y1, x1, x1][i]);
    let products: [_; 4] = from_fn(|i| [dx, dx, dy, dy][i] * across[i]);

    // Upper right, upper left, lower right, lower left.
    let [top, bottom, right, left] = products;
    let (minuends, subtrahends) = ([top, top, bottom, bottom], [right, left, right, left]);
    let sides: [_; 4] = from_fn(|i| minuends[i] - subtrahends[i]);
    let margins: [_; 4] =
        from_fn(|i: usize| ORIENT2D_FILTER * (minuends[i].abs() + subtrahends[i].abs()) - sides[i].abs());
    let to_the_right = if f64x4::new(margins).to_bitmask() == ALL_CORNERS {
        f64x4::new(sides).to_bitmask()
    } else {
        careful_sides(segment, window, sides, margins)
    };

    let greater = |a: f64, b: f64| if a > b { a } else { b };
    let [ex, ey] = [[x1, x2], [y1, y2]].map(|[b1, b2]| ERROR * greater(greater(b1.abs(), b2.abs()), TINY));
    let values: [_; 4] = from_fn(|i| [x1, x1, y1, y1][i] + products[i] / [dy, dy, dx, dx][i]);
    let low: [_; 4] = from_fn(|i| (values[i] - [ex, ex, ey, ey][i]) as f32);
    let high: [_; 4] = from_fn(|i| (values[i] + [ex, ex, ey, ey][i]) as f32);
    // Which zero it is, the window says.
    let doubt = |i: usize| low[i].to_bits() ^ high[i].to_bits() | u32::from(low[i] == 0.0);
    let [top, bottom, right, left] = if (0..4).fold(0, |doubts, i| doubts | doubt(i)) == 0 {
        low
    } else {
        careful_places(segment, window, [low, high])
    };

    let [p1, p2] = *segment;
    let places = [[top, ymax], [bottom, ymin], [xmax, right], [xmin, left], p1, p2];
    let place = |end: usize, code: u32| {
        let index = PLACES[end][(code << 4 | to_the_right) as usize % PLACES[end].len()];
        places.get(usize::from(index)).copied().unwrap_or_default()
    };
    // Neither none nor all, in one comparison: two are two branches.
    let visible = (to_the_right + 1) & (ALL_CORNERS - 1) != 0;
    Part { segment: [place(0, code1), place(1, code2)], visible }
}

/// A bit each.
const ALL_CORNERS: u32 = 0b1111;

/// Where the ends are in the end: the crossing with a border, in the order of [`Border::ALL`], or where
/// they were given. By their outcode, times 16, and the corners to the right of the line.
const PLACES: [[u8; 256]; 2] = {
    let mut places = [[0; 256]; 2];
    let mut index = 0;
    while index < 256 {
        let (code, to_the_right) = (index >> 4, index & 0b1111);
        places[0][index] = if code == 0 { 4 } else { cut_at(code, to_the_right) as u8 };
        // Seen from the other end, right is left.
        places[1][index] = if code == 0 { 5 } else { cut_at(code, !to_the_right) as u8 };
        index += 1;
    }
    places
};

/// The border at which the first end is cut, if it has this outcode.
const fn cut_at(code: usize, to_the_right: usize) -> Border {
    let [left, right, bottom, top] = [code & 1 != 0, code & 2 != 0, code & 4 != 0, code & 8 != 0];
    let x = if right { Border::Right } else { Border::Left };
    let y = if top { Border::Top } else { Border::Bottom };
    if !left && !right {
        return y;
    }
    if !bottom && !top {
        return x;
    }
    // Coming in from the upper right or the lower left, a corner to the left is passed across a
    // horizontal border; from the other two, across a vertical one.
    let corner = left as usize + 2 * bottom as usize;
    let is_right = to_the_right >> corner & 1 == 1;
    if is_right == (left != bottom) { y } else { x }
}

/// The corners to the right of the line where one is nearly on it, or on it. A corner on the line is
/// passed on either side, so it counts as being where not all others are.
#[cold]
#[inline(never)]
fn careful_sides(&[p, q]: &Segment, window: &Window, sides: [f64; 4], margins: [f64; 4]) -> u32 {
    let Window { xmin, ymin, xmax, ymax } = *window;
    let corners = [[xmax, ymax], [xmin, ymax], [xmax, ymin], [xmin, ymin]];
    let signs: [Sign; 4] = from_fn(|i| match margins[i] < 0.0 {
        true => Sign::of(sides[i]),
        false => orient2d(p, q, corners[i], &mut Tally::default()),
    });
    let bits = |sign| (0..).zip(signs).fold(0, |bits, (i, s)| bits | u32::from(s == sign) << i);
    let (right, on) = (bits(Sign::Negative), bits(Sign::Zero));
    match right {
        0 if on == ALL_CORNERS => 1,
        0 => on,
        _ => right,
    }
}

/// The places where one of them is nearly halfway between two numbers, or zero, or where the line is
/// parallel to a border.
#[cold]
#[inline(never)]
fn careful_places(segment: &Segment, window: &Window, [low, high]: [[f32; 4]; 2]) -> [f32; 4] {
    Border::ALL.map(|border| {
        let (axis, c, i) = (border.axis(), window.at(border), border as usize);
        let [a1, a2] = segment.map(|p| p[axis]);
        let crosses = a1 != a2 && (a1 <= c && c <= a2 || a2 <= c && c <= a1);
        if low[i].to_bits() == high[i].to_bits() && low[i] != 0.0 || !crosses {
            return low[i];
        }
        intersection(*segment, border, window, &mut Tally::default())[1 - axis]
    })
}
