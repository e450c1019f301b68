//! Polygons that break clippers, and what is left of them in rational numbers.

use super::{Random, line};
use rasterscope_core::{
    clip::line::{Border, Point, Window},
    clip::polygon::outline::{Corner, Source},
    math::{Dyadic, Sign},
};
use std::{
    cmp::Ordering,
    ops::{Add, Mul, Sub},
};

/// A rational number; the denominator is positive.
#[derive(Clone, Debug)]
pub(crate) struct Ratio {
    num: Dyadic,
    den: Dyadic,
}

impl Ratio {
    pub(crate) fn new(num: Dyadic, den: Dyadic) -> Self {
        if den.sign().is_negative() { Self { num: -num, den: -den } } else { Self { num, den } }
    }

    /// Rounded once.
    pub(crate) fn to_f32(&self) -> f32 {
        Dyadic::ratio_to_f32(&self.num, &self.den)
    }

    pub(crate) fn sign(&self) -> Sign {
        self.num.sign()
    }
}

impl From<f32> for Ratio {
    fn from(value: f32) -> Self {
        Self { num: Dyadic::from(value), den: Dyadic::one() }
    }
}

impl PartialEq for Ratio {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Ratio {}

impl PartialOrd for Ratio {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Ratio {
    fn cmp(&self, other: &Self) -> Ordering {
        (&self.num * &other.den).cmp(&(&other.num * &self.den))
    }
}

impl Sub for &Ratio {
    type Output = Ratio;

    fn sub(self, other: Self) -> Ratio {
        Ratio { num: &self.num * &other.den - &other.num * &self.den, den: &self.den * &other.den }
    }
}

impl Add for &Ratio {
    type Output = Ratio;

    fn add(self, other: Self) -> Ratio {
        Ratio { num: &self.num * &other.den + &other.num * &self.den, den: &self.den * &other.den }
    }
}

impl Mul for &Ratio {
    type Output = Ratio;

    fn mul(self, other: Self) -> Ratio {
        Ratio { num: &self.num * &other.num, den: &self.den * &other.den }
    }
}

pub(crate) type Exact = [Ratio; 2];

pub(crate) fn exact(p: Point) -> Exact {
    p.map(Ratio::from)
}

/// On which side of `a b` the point `c` lies.
pub(crate) fn turn([a, b, c]: [&Exact; 3]) -> Sign {
    let area = &(&(&b[0] - &a[0]) * &(&c[1] - &a[1])) - &(&(&b[1] - &a[1]) * &(&c[0] - &a[0]));
    area.sign()
}

/// Where the line through `p` and `q` crosses a border.
pub(crate) fn crossing([p, q]: [Point; 2], border: Border, window: &Window) -> Exact {
    let (fixed, free) = (border.axis(), 1 - border.axis());
    let [a1, b1, a2, b2] = [p[fixed], p[free], q[fixed], q[free]].map(Dyadic::from);
    let c = Dyadic::from(window.at(border));
    let mut at = [Ratio::from(window.at(border)), Ratio::from(window.at(border))];
    at[free] = Ratio::new(&b1 * &(&a2 - &c) + &b2 * &(&c - &a1), &a2 - &a1);
    at
}

/// The corner that a source names, without a rounding.
pub(crate) fn place(source: Source, polygon: &[Point], window: &Window) -> Exact {
    match source {
        Source::Vertex(i) => exact(polygon[i as usize]),
        Source::Crossing { edge, border } => {
            let edge = edge as usize;
            crossing([polygon[edge], polygon[(edge + 1) % polygon.len()]], border, window)
        }
        Source::Window(borders) => {
            let mut at = [0.0; 2];
            borders.iter().for_each(|border| at[border.axis()] = window.at(*border));
            exact(at)
        }
    }
}

/// Each corner is in the window, and where its source says, rounded once.
#[track_caller]
pub(crate) fn check_corners(corners: &[Corner], polygon: &[Point], window: &Window) {
    for corner in corners {
        let [x, y] = corner.at;
        let inside = (window.xmin..=window.xmax).contains(&x) && (window.ymin..=window.ymax).contains(&y);
        assert!(inside, "{corner:?} of {polygon:?} is not in {window:?}");
        if let Source::Vertex(i) = corner.source {
            assert_eq!(corner.at.map(f32::to_bits), polygon[i as usize].map(f32::to_bits));
        }
        let [ex, ey] = place(corner.source, polygon, window);
        assert_eq!(corner.at, [ex.to_f32(), ey.to_f32()], "{corner:?} of {polygon:?} in {window:?}");
    }
}

/// A random polygon of three to nine corners, any shape, of one of several nasty families.
pub(crate) fn polygon(random: &mut Random) -> (Vec<Point>, Window) {
    let ([p, q], window) = line(random);
    let mut points = vec![p, q];
    let coarse = random.below(3) == 0;
    while points.len() < 3 || points.len() < 9 && random.below(4) > 0 {
        let [last, before] = [points[points.len() - 1], points[points.len() - 2]];
        points.push(match random.below(12) {
            0 => last,
            1 => before,
            2 => [0, 1].map(|i| last[i] / 2.0 + before[i] / 2.0),
            3 => [random.near(window.xmin), random.near(window.ymax)],
            4 => [window.xmax, random.grid(-3, 8)],
            5 => [random.grid(-3, 8), window.ymin],
            6 => [last[0], random.near(before[1])],
            7..9 if coarse => [random.below(8) as f32 - 2.0, random.below(8) as f32 - 2.0],
            7 => [p[0], q[1]],
            8 => [random.near(q[0]), random.near(p[1])],
            _ => [random.grid(-3, 8), random.grid(-3, 8)],
        });
    }
    points.iter_mut().flatten().for_each(|x| *x = x.clamp(f32::MIN, f32::MAX));
    (points, window)
}

/// The corners of the smallest convex polygon around some points, counter-clockwise from the leftmost.
pub(crate) fn hull(mut points: Vec<Exact>) -> Vec<Exact> {
    points.sort();
    points.dedup();
    let half = |points: &mut dyn Iterator<Item = &Exact>| {
        let mut chain: Vec<Exact> = Vec::new();
        for p in points {
            while chain.len() > 1
                && turn([&chain[chain.len() - 2], &chain[chain.len() - 1], p]) != Sign::Positive
            {
                chain.pop();
            }
            chain.push(p.clone());
        }
        chain.pop();
        chain
    };
    let mut lower = half(&mut points.iter());
    lower.append(&mut half(&mut points.iter().rev()));
    lower
}

/// What is left of a convex polygon: the smallest convex polygon around the corners of either that lie
/// in the other and the crossings of their edges. Nothing if it has no area.
pub(crate) fn convex_part(polygon: &[Point], window: &Window) -> Vec<Exact> {
    let turns = |a: &Exact, b: &Exact, c: &Exact| turn([a, b, c]);
    let corners: Vec<Exact> = polygon.iter().copied().map(exact).collect();
    let outline = hull(corners.clone());
    if outline.len() < 3 {
        return Vec::new();
    }
    let edges = || outline.iter().zip(outline.iter().cycle().skip(1));
    let [xmin, ymin, xmax, ymax] = [window.xmin, window.ymin, window.xmax, window.ymax].map(Ratio::from);
    let within = |p: &Exact| p[0] >= xmin && p[0] <= xmax && p[1] >= ymin && p[1] <= ymax;
    let mut points: Vec<Exact> = corners.into_iter().filter(within).collect();
    for corner in window.corners().map(exact) {
        if edges().all(|(a, b)| turns(a, b, &corner) != Sign::Negative) {
            points.push(corner);
        }
    }
    for (i, &p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        for border in Border::ALL {
            let (axis, c) = (border.axis(), window.at(border));
            if p[axis] < c && c < q[axis] || q[axis] < c && c < p[axis] {
                points.extend(Some(crossing([p, q], border, window)).filter(|p| within(p)));
            }
        }
    }
    let part = hull(points);
    if part.len() < 3 { Vec::new() } else { part }
}

/// How often an outline winds around a point that is not on it.
pub(crate) fn winding(outline: &[Exact], around: &Exact) -> i32 {
    let mut count = 0;
    for (a, b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
        let above = [a, b].map(|p| p[1] > around[1]);
        match (above, turn([a, b, around])) {
            ([false, true], Sign::Positive) => count += 1,
            ([true, false], Sign::Negative) => count -= 1,
            _ => {}
        }
    }
    count
}
