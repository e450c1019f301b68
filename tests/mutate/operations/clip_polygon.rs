//! A polygon of any shape against a window: corners rounded once, windings kept, direction no matter.

use super::{Operation, path, same};
use crate::{
    case::{Case, Reader, codes, fresh, points},
    integers::{integer, nearest, sign},
    random::Random,
};
use num_bigint::BigInt;
use rasterscope_core::{
    clip::{
        line::{Point, Window},
        polygon::sutherland_hodgman::{Corner, Settings, SideOrder, Source, clip, clip_traced},
    },
    math::Tally,
    trace::NoTrace,
};

pub(super) const OPERATION: Operation =
    Operation { name: "clip-polygon", cases: 80_000, fresh: polygon, check, code };

/// The window, the order of sides, the number of corners, and up to eight of them.
fn polygon(random: &mut Random) -> Case {
    let mut case = fresh(random, 4 + 2 + 16);
    case[4] = random.bits();
    case[5] = random.bits();
    case
}

fn read(words: &[u32]) -> (Vec<Point>, Window, SideOrder) {
    let mut reader = Reader(words);
    let [xmin, ymin, xmax, ymax] = reader.window();
    let order = reader.choice(&SideOrder::ALL);
    let count = reader.choice(&[3, 3, 4, 5, 6, 8]);
    let polygon = (0..count).map(|_| reader.numbers()).collect();
    (polygon, Window { xmin, ymin, xmax, ymax }, order)
}

fn code(words: &[u32]) -> String {
    let (polygon, Window { xmin, ymin, xmax, ymax }, order) = read(words);
    let window = codes(&[xmin, ymin, xmax, ymax]);
    format!("let (polygon, window) = (vec!{}, window({window})); // {order:?}", points(&polygon))
}

/// x and y over a common positive denominator.
type Place = [BigInt; 3];

fn whole([x, y]: Point) -> Place {
    [integer(x), integer(y), BigInt::from(1)]
}

/// The corner that a source names, without a rounding.
fn place(source: Source, polygon: &[Point], window: &Window) -> Place {
    match source {
        Source::Vertex(i) => whole(polygon[i as usize]),
        Source::Window(borders) => {
            let mut at = [0.0; 2];
            borders.iter().for_each(|border| at[border.axis()] = window.at(*border));
            whole(at)
        }
        Source::Crossing { edge, border } => {
            let (fixed, free) = (border.axis(), 1 - border.axis());
            let edge = edge as usize;
            let [p, q] = [polygon[edge], polygon[(edge + 1) % polygon.len()]].map(|p| p.map(integer));
            let c = integer(window.at(border));
            let (mut across, mut along) =
                (&q[fixed] - &p[fixed], &p[free] * (&q[fixed] - &c) + &q[free] * (&c - &p[fixed]));
            if sign(&across) < 0 {
                (across, along) = (-across, -along);
            }
            let mut place = [&c * &across, &c * &across, across];
            place[free] = along;
            place
        }
    }
}

/// On which side of `a b` the point `c` lies: the determinant of the three.
fn turn([a, b, c]: [&Place; 3]) -> i32 {
    sign(
        &(&a[0] * (&b[1] * &c[2] - &c[1] * &b[2]) - &b[0] * (&a[1] * &c[2] - &c[1] * &a[2])
            + &c[0] * (&a[1] * &b[2] - &b[1] * &a[2])),
    )
}

/// The order of two places along an axis.
fn order(a: &Place, b: &Place, axis: usize) -> i32 {
    sign(&(&b[axis] * &a[2] - &a[axis] * &b[2]))
}

/// The same outline without given corners that repeat or at which it goes straight on. The sign of a
/// zero is no place: one sign, so that the same corner stays.
fn simplified(mut polygon: Vec<Point>) -> Vec<Point> {
    polygon.iter_mut().flatten().for_each(|coordinate| *coordinate += 0.0);
    let is_idle = |polygon: &[Point], i: usize| {
        let count = polygon.len();
        let [a, b, c] = [i + count - 1, i, i + 1].map(|i| whole(polygon[i % count]));
        polygon[(i + 1) % count] == polygon[i]
            || turn([&a, &b, &c]) == 0 && (0..2).any(|axis| order(&a, &b, axis) * order(&b, &c, axis) > 0)
    };
    while let Some(idle) = (0..polygon.len()).find(|&i| is_idle(&polygon, i)) {
        polygon.remove(idle);
    }
    polygon
}

/// How often an outline winds around a point; `None` if the point lies on it.
fn winding(outline: &[Place], around: &Place) -> Option<i32> {
    let mut count = 0;
    for (a, b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
        let height = |p: &Place| sign(&(&p[1] * &around[2] - &around[1] * &p[2]));
        let along = |p: &Place| sign(&(&p[0] * &around[2] - &around[0] * &p[2]));
        let side = turn([a, b, around]);
        let within = |f: &dyn Fn(&Place) -> i32| f(a) * f(b) <= 0;
        if side == 0 && within(&height) && within(&along) {
            return None;
        }
        match (height(a) > 0, height(b) > 0) {
            (false, true) if side > 0 => count += 1,
            (true, false) if side < 0 => count -= 1,
            _ => {}
        }
    }
    Some(count)
}

/// Points inside the window to ask: between its borders, between corners, beside them.
fn probes(polygon: &[Point], window: &Window) -> Vec<Point> {
    let middle = |a: f32, b: f32| a / 2.0 + b / 2.0;
    let center = [middle(window.xmin, window.xmax), middle(window.ymin, window.ymax)];
    let between = polygon.iter().zip(polygon.iter().cycle().skip(2));
    let mut all: Vec<Point> = between.map(|(p, q)| [middle(p[0], q[0]), middle(p[1], q[1])]).collect();
    all.extend(polygon.iter().map(|p| [p[0].next_up(), p[1].next_down()]));
    all.extend(window.corners().map(|c| [middle(c[0], center[0]), middle(c[1], center[1])]));
    all.push(center);
    let inside =
        |[x, y]: &Point| window.xmin < *x && *x < window.xmax && window.ymin < *y && *y < window.ymax;
    all.retain(inside);
    all
}

/// A point, and those an ULP beside it.
fn beside([x, y]: Point) -> [Point; 5] {
    [[x, y], [x.next_up(), y], [x.next_down(), y], [x, y.next_up()], [x, y.next_down()]]
}

fn check(words: &[u32]) -> Result<u64, String> {
    let (polygon, window, order) = read(words);
    let mut tally = Tally::default();
    let mut corners = |polygon: &[Point], order| -> Vec<Corner> {
        let settings = Settings { order, ..Settings::default() };
        let mut all = clip_traced(&[polygon.to_vec()], &window, settings, &mut tally, &mut NoTrace);
        all.pop().unwrap_or_default()
    };
    let result = corners(&polygon, order);
    for corner in &result {
        let [x, y] = corner.at;
        if !(window.xmin..=window.xmax).contains(&x) || !(window.ymin..=window.ymax).contains(&y) {
            return Err(format!("{:?} lies outside", corner.at));
        }
        let [px, py, d] = place(corner.source, &polygon, &window);
        same(&format!("{:?}", corner.source), &corner.at, &[nearest(&px, &d), nearest(&py, &d)])?;
        if let Source::Vertex(i) = corner.source {
            same(
                "a corner that stays",
                &corner.at.map(f32::to_bits),
                &polygon[i as usize].map(f32::to_bits),
            )?;
        }
    }
    let given: Vec<Place> = polygon.iter().copied().map(whole).collect();
    let left: Vec<Place> = result.iter().map(|corner| place(corner.source, &polygon, &window)).collect();
    let mut windings = Vec::new();
    for probe in probes(&polygon, &window) {
        // Corners that round to one are one, which moves an edge by less than an ULP.
        let around = |outline: &[Place]| beside(probe).map(|probe| winding(outline, &whole(probe)));
        let [expected, found] = [around(&given), around(&left)];
        if !found.iter().any(|winding| winding.is_none() || expected.contains(winding)) {
            same(&format!("winding around {probe:?}"), &found, &expected)?;
        }
        windings.push(expected[0]);
    }
    let bits = |corners: &[Corner]| -> Vec<_> { corners.iter().map(|c| c.at.map(f32::to_bits)).collect() };
    let unsigned = |corners: &[Corner]| -> Vec<_> {
        corners.iter().map(|c| c.at.map(|coordinate| (coordinate + 0.0).to_bits())).collect()
    };
    let reversed: Vec<Point> = polygon.iter().rev().copied().collect();
    let mut back = bits(&corners(&reversed, order));
    back.reverse();
    same("from the other direction", &rotated(back), &rotated(bits(&result)))?;
    let fewer = simplified(polygon.clone());
    let fewer = if fewer.len() < 3 { Vec::new() } else { unsigned(&corners(&fewer, order)) };
    same("without idle corners", &rotated(unsigned(&result)), &rotated(fewer))?;
    let usual = bits(&corners(&polygon, SideOrder::default()));
    let fast: Vec<_> = clip(&polygon, &window).iter().map(|p| p.map(f32::to_bits)).collect();
    same("the fast call", &fast, &usual)?;
    let sources: Vec<_> = result.iter().map(|corner| corner.source).collect();
    Ok(path((sources, windings, tally.exact)))
}

/// The same cycle, starting where it is smallest.
fn rotated(mut cycle: Vec<[u32; 2]>) -> Vec<[u32; 2]> {
    let from = |start: usize| cycle.iter().cycle().skip(start).take(cycle.len());
    let start = (0..cycle.len()).min_by(|&a, &b| from(a).cmp(from(b)));
    cycle.rotate_left(start.unwrap_or_default());
    cycle
}
