//! A small sphere around points, never too small.
//!
//! *Source:* Ritter, An Efficient Bounding Sphere, Graphics Gems, 1990; Bădoiu and Clarkson, Smaller
//! Core-Sets for Balls, 2003 (a middle that goes towards the farthest point by ever smaller steps).
//! Deviations: of both middles the better one is taken; the middle is rounded first and the radius after
//! that, upwards, so that no point lies outside.

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its middle.
    pub center: [f32; 3],
    /// Its radius, not negative; infinite if no binary32 number is large enough.
    pub radius: f32,
}

/// Steps towards the farthest point: the radius comes within about 1 / sqrt(STEPS) of the smallest one
/// in theory, and far nearer in practice.
const STEPS: u32 = 64;

/// Covers the three roundings of a square, the two of the sum and that of the root, all in binary64: far
/// less than this share.
const ABOVE: f64 = 1.0 + 1e-14;

impl Sphere {
    /// A sphere that no point lies outside of, usually less than a hundredth larger than the smallest
    /// one; `None` if there are no points. Finite coordinates. About 70 times over the points.
    pub fn around(points: &[[f32; 3]]) -> Option<Self> {
        let all: Vec<[f64; 3]> = points.iter().map(|point| point.map(f64::from)).collect();
        let ritter = ritter(&all)?;
        let candidates = [ritter, walk(&all, ritter)].map(|middle| {
            let center = middle.map(|c| c as f32);
            Self { center, radius: radius(center, &all) }
        });
        let [ritter, walked] = candidates;
        Some(if walked.radius < ritter.radius { walked } else { ritter })
    }
}

fn square(a: [f64; 3], b: [f64; 3]) -> f64 {
    let [x, y, z] = [0, 1, 2].map(|i| a[i] - b[i]);
    x * x + y * y + z * z
}

fn farthest(from: [f64; 3], points: &[[f64; 3]]) -> Option<[f64; 3]> {
    points.iter().copied().max_by(|a, b| square(from, *a).total_cmp(&square(from, *b)))
}

/// Ritter's middle: of two points far apart, then as far towards each point outside as is needed.
fn ritter(points: &[[f64; 3]]) -> Option<[f64; 3]> {
    let a = farthest(*points.first()?, points)?;
    let b = farthest(a, points)?;
    let mut middle = [0, 1, 2].map(|i| (a[i] + b[i]) / 2.0);
    let mut radius = square(a, b).sqrt() / 2.0;
    for &point in points {
        let distance = square(middle, point).sqrt();
        if distance > radius {
            let share = (distance - radius) / 2.0 / distance;
            middle = [0, 1, 2].map(|i| middle[i] + (point[i] - middle[i]) * share);
            radius = (radius + distance) / 2.0;
        }
    }
    Some(middle)
}

/// Bădoiu and Clarkson's middle.
fn walk(points: &[[f64; 3]], from: [f64; 3]) -> [f64; 3] {
    let mut middle = from;
    for step in 1..=STEPS {
        let Some(point) = farthest(middle, points) else { break };
        let share = 1.0 / f64::from(step + 1);
        middle = [0, 1, 2].map(|i| middle[i] + (point[i] - middle[i]) * share);
    }
    middle
}

/// The distance of the farthest point, rounded up.
fn radius(center: [f32; 3], points: &[[f64; 3]]) -> f32 {
    let center = center.map(f64::from);
    let most = points.iter().map(|&point| square(center, point)).fold(0.0, f64::max);
    let exact = most.sqrt() * ABOVE;
    let rounded = exact as f32;
    if f64::from(rounded) < exact { rounded.next_up() } else { rounded }
}
