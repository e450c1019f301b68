//! Where the line through two points crosses the four borders, all at once: regions and places, exactly.

use super::{
    Border, Outcode, Point, Segment, Window,
    intersection::{ERROR, intersection},
};
use crate::math::{Sign, Tally, orient2d, predicates::ORIENT2D_FILTER};
use std::array::from_fn;

/// The crossings of a line with the borders of a window.
///
/// *Regions.* On which side of the line the window's corners are decides beyond which corner of a border
/// the line crosses it: four orientations, which share their products, serve every cut. They are signs
/// from the given ends, since a rounded point can fall on a border from outside.
///
/// *Places.* These products are the numerators of the crossings, too. A processor divides four numbers
/// nearly as fast as one, so there are four quotients, of which at most two are used.
///
/// No branch depends on where a line lies, except the rare ones to where binary64 does not decide: what
/// no processor can foresee costs more than all the arithmetic here.
///
/// *Source:* Skala 2023 (doi 10.15388/23-INFOR508) for clipping by the sides of the corners; Ziv 1991 for
/// the rounding test.
pub(super) struct Crossings<'a> {
    window: &'a Window,
    /// Four bits a border, the first border lowest.
    codes: u16,
    /// The coordinate along each border, rounded once.
    along: [f32; 4],
}

/// Keeps the bound above zero: no crossing at zero is certain, because its sign is to be looked at.
const TINY: f64 = 1e-290;

impl<'a> Crossings<'a> {
    /// Of the line through the ends of `segment`, which are not the same; `tally` counts the signs as
    /// one decision and the roundings as one.
    #[inline(always)]
    pub(super) fn new(segment: &Segment, window: &'a Window, tally: &mut Tally) -> Self {
        tally.calls += 2;
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
        let codes = if margins.iter().fold(1, |all, margin| all & is_negative(*margin)) == 1 {
            // Bytes to bits at once: the product brings the lowest bit of each into the highest byte.
            let bytes = u32::from_le_bytes(sides.map(|side| is_negative(side) as u8));
            let index = bytes.wrapping_mul(0x0102_0408) >> 24 & 0b1111;
            CODES[index as usize | (is_negative(dx) << 4 | is_negative(dy) << 5) as usize]
        } else {
            tally.exact += 1;
            careful_codes(segment, window, sides, margins)
        };

        let greater = |a: f64, b: f64| if a > b { a } else { b };
        let [ex, ey] =
            [[x1, x2], [y1, y2]].map(|[b1, b2]| ERROR * greater(greater(b1.abs(), b2.abs()), TINY));
        let values: [_; 4] = from_fn(|i| [x1, x1, y1, y1][i] + products[i] / [dy, dy, dx, dx][i]);
        let low: [_; 4] = from_fn(|i| (values[i] - [ex, ex, ey, ey][i]) as f32);
        let high: [_; 4] = from_fn(|i| (values[i] + [ex, ex, ey, ey][i]) as f32);
        // Which zero it is, the window says.
        let doubt = |i: usize| low[i].to_bits() ^ high[i].to_bits() | u32::from(low[i] == 0.0);
        let along = if (0..4).fold(0, |doubts, i| doubts | doubt(i)) == 0 {
            low
        } else {
            tally.exact += 1;
            careful_places(segment, window, [low, high])
        };
        Self { window, codes, along }
    }

    /// The outcode of the exact crossing with `border`; any if the line is parallel to it.
    #[inline(always)]
    pub(super) fn code(&self, border: Border) -> Outcode {
        Outcode((self.codes >> (4 * border as u16) & 0b1111) as u8)
    }

    /// The crossing with `border`, rounded once; any if the ends are strictly on one side of it.
    #[inline(always)]
    pub(super) fn place(&self, border: Border) -> Point {
        let (c, along) = (self.window.at(border), self.along[border as usize]);
        if border.axis() == 0 { [c, along] } else { [along, c] }
    }
}

/// 1 for a number below zero; -0 does not occur.
#[inline(always)]
fn is_negative(value: f64) -> u64 {
    value.to_bits() >> 63
}

/// The codes by signs: bits of an index that are 1 where a corner is to the right of the line, upper
/// right first, and where x and y fall.
const CODES: [u16; 64] = {
    let (mut codes, mut index) = ([0; 64], 0);
    while index < codes.len() {
        let mut signs = [1; 6];
        let mut bit = 0;
        while bit < signs.len() {
            signs[bit] -= 2 * (index as i8 >> bit & 1);
            bit += 1;
        }
        let [ur, ul, lr, ll, dx, dy] = signs;
        codes[index] = codes_by_signs([ur, ul, lr, ll], [dx, dy]);
        index += 1;
    }
    codes
};

/// Along the line, a border is crossed beyond its corner if that corner is on the one side when the other
/// coordinate rises, and on the other when it falls. A corner on the line is not passed.
const fn codes_by_signs([ur, ul, lr, ll]: [i8; 4], [dx, dy]: [i8; 2]) -> u16 {
    const fn code([top, bottom, right, left]: [bool; 4]) -> u16 {
        (top as u16) << 3 | (bottom as u16) << 2 | (right as u16) << 1 | left as u16
    }
    code([false, false, ur * dy > 0, ul * dy < 0])
        | code([false, false, lr * dy > 0, ll * dy < 0]) << 4
        | code([ur * dx < 0, lr * dx > 0, false, false]) << 8
        | code([ul * dx < 0, ll * dx > 0, false, false]) << 12
}

/// The codes where a corner is nearly on the line, or on it.
#[cold]
#[inline(never)]
fn careful_codes(&[p, q]: &Segment, window: &Window, sides: [f64; 4], margins: [f64; 4]) -> u16 {
    let Window { xmin, ymin, xmax, ymax } = *window;
    let corners = [[xmax, ymax], [xmin, ymax], [xmax, ymin], [xmin, ymin]];
    let corners = from_fn(|i| match margins[i] < 0.0 {
        true => number(Sign::of(sides[i])),
        false => number(orient2d(p, q, corners[i], &mut Tally::default())),
    });
    codes_by_signs(corners, [0, 1].map(|axis| number(Sign::of(f64::from(q[axis]) - f64::from(p[axis])))))
}

fn number(sign: Sign) -> i8 {
    match sign {
        Sign::Negative => -1,
        Sign::Zero => 0,
        Sign::Positive => 1,
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
