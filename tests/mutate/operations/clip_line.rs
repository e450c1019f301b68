//! A line against a window: every algorithm, from both ends.

use super::{Operation, path, same};
use crate::{
    case::{Case, Reader, codes, fresh, points},
    integers::{integer, nearest},
    random::Random,
};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use rasterscope_core::{
    clip::line::{Border, Segment, Window, clip, cohen_sutherland, liang_barsky},
    math::{Arithmetic, Tally},
    trace::NoTrace,
};

pub(super) const OPERATION: Operation =
    Operation { name: "clip-line", cases: 400_000, fresh: line, check, code };

/// The textbook in binary32, which is wrong near corners and along borders.
pub(super) const FAULTY: Operation =
    Operation { name: "clip-line in binary32", cases: 0, fresh: line, check: check_textbook, code };

fn line(random: &mut Random) -> Case {
    fresh(random, 8)
}

fn read(words: &[u32]) -> (Segment, Window) {
    let mut reader = Reader(words);
    let [xmin, ymin, xmax, ymax] = reader.window();
    let [x1, y1, x2, y2] = reader.numbers();
    ([[x1, y1], [x2, y2]], Window { xmin, ymin, xmax, ymax })
}

fn code(words: &[u32]) -> String {
    let (segment, Window { xmin, ymin, xmax, ymax }) = read(words);
    let window = codes(&[xmin, ymin, xmax, ymax]);
    format!("let (segment, window) = ({}, window({window}));", points(&segment))
}

/// A parameter as a fraction with a positive denominator.
type Parameter = (BigInt, BigInt);

/// The visible part in rational numbers: its parameters, and its ends rounded once.
struct Visible {
    t: [f32; 2],
    ends: Segment,
    cut: [bool; 2],
}

/// `inside` of a border is `p t <= q`: the paper's own inequalities, in integers.
fn visible_part([p1, p2]: Segment, window: &Window) -> Option<Visible> {
    let [start, end] = [p1, p2].map(|p| p.map(integer));
    let direction = [&end[0] - &start[0], &end[1] - &start[1]];
    let zero = || (BigInt::zero(), BigInt::from(1));
    let one = || (BigInt::from(1), BigInt::from(1));
    let less = |a: &Parameter, b: &Parameter| &a.0 * &b.1 < &b.0 * &a.1;
    let [mut enter, mut leave] = [zero(), one()];
    for border in Border::ALL {
        let axis = border.axis();
        let outward = if matches!(border, Border::Top | Border::Right) { 1 } else { -1 };
        let p: BigInt = &direction[axis] * outward;
        let q: BigInt = (integer(window.at(border)) - &start[axis]) * outward;
        if p.is_zero() {
            if q.is_negative() {
                return None;
            }
        } else if p.is_positive() {
            let t = (q, p);
            leave = if less(&t, &leave) { t } else { leave };
        } else {
            let t = (-q, -p);
            enter = if less(&enter, &t) { t } else { enter };
        }
    }
    if less(&leave, &enter) {
        return None;
    }
    let cut = [less(&zero(), &enter), less(&leave, &one())];
    let unit = integer(1.0);
    let at = |(n, d): &Parameter, cut: bool, given: [f32; 2]| {
        if !cut {
            return given;
        }
        [0, 1].map(|axis| {
            let value = nearest(&(&start[axis] * d + n * &direction[axis]), d);
            // A coordinate of the window has that border's bits.
            let sides = window.sides(axis);
            sides.into_iter().find(|side| *side == value).unwrap_or(value)
        })
    };
    let ends = [at(&enter, cut[0], p1), at(&leave, cut[1], p2)];
    let t = [&enter, &leave].map(|(n, d)| nearest(&(n * &unit), d));
    Some(Visible { t, ends, cut })
}

fn check_textbook(words: &[u32]) -> Result<u64, String> {
    let (segment, window) = read(words);
    let expected = visible_part(segment, &window).map(|visible| visible.ends);
    let (mut tally, arithmetic) = (Tally::default(), Arithmetic::F32);
    let found = cohen_sutherland::clip_traced(segment, &window, arithmetic, &mut tally, &mut NoTrace);
    same("cohen-sutherland in binary32", &found, &expected)?;
    Ok(path(expected.is_some()))
}

fn check(words: &[u32]) -> Result<u64, String> {
    let (segment, window) = read(words);
    let exact = visible_part(segment, &window);
    let raw = |ends: Segment| ends.map(|p| p.map(f32::to_bits));
    // Of two borders at -0 and 0 either may be the one that cut.
    let thin = [window.xmin == window.xmax, window.ymin == window.ymax];
    let bits = |ends: Segment| {
        ends.map(|p| [0, 1].map(|axis| if thin[axis] { p[axis] + 0.0 } else { p[axis] }.to_bits()))
    };
    let expected = exact.as_ref().map(|visible| bits(visible.ends));
    let [p1, p2] = segment;
    let turned = |ends: Option<Segment>| ends.map(|[a, b]| bits([b, a]));

    let mut tally = Tally::default();
    let cohen_sutherland = |segment: Segment, tally: &mut Tally| {
        cohen_sutherland::clip_traced(segment, &window, Arithmetic::Exact, tally, &mut NoTrace)
    };
    same("cohen-sutherland", &cohen_sutherland(segment, &mut tally).map(bits), &expected)?;
    same("cohen-sutherland from the other end", &turned(cohen_sutherland([p2, p1], &mut tally)), &expected)?;

    let liang_barsky = |segment: Segment, tally: &mut Tally| {
        liang_barsky::clip_traced(segment, &window, Arithmetic::Exact, tally, &mut NoTrace)
    };
    let visible = liang_barsky(segment, &mut tally);
    same("liang-barsky", &visible.map(|visible| bits(visible.segment)), &expected)?;
    same("liang-barsky's t", &visible.map(|visible| visible.t), &exact.as_ref().map(|visible| visible.t))?;
    let other = liang_barsky([p2, p1], &mut tally).map(|visible| visible.segment);
    same("liang-barsky from the other end", &turned(other), &expected)?;
    let [ours, theirs] = [cohen_sutherland(segment, &mut tally), visible.map(|visible| visible.segment)];
    same("liang-barsky and cohen-sutherland", &theirs.map(raw), &ours.map(raw))?;
    same("at once", &clip(segment, &window).map(bits), &expected)?;

    if let Some([x, y]) = exact
        .iter()
        .flat_map(|visible| visible.ends)
        .find(|[x, y]| !(window.xmin..=window.xmax).contains(x) || !(window.ymin..=window.ymax).contains(y))
    {
        return Err(format!("({x}, {y}) lies outside"));
    }
    let signs = |a: f32, b: f32| a.partial_cmp(&b);
    let sides = Border::ALL.map(|border| {
        let (axis, at) = (border.axis(), window.at(border));
        [signs(p1[axis], at), signs(p2[axis], at)]
    });
    Ok(path((sides, exact.map(|visible| visible.cut), tally.calls, tally.exact)))
}
