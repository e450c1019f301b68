//! Polygons clipped in rational numbers, and what is wrong with an answer.

use super::{Answer, Polygon};
use crate::{
    exact::{Rational, integer, nearest, rational},
    lines::Sides,
};
use num_traits::{Signed, ToPrimitive, Zero};
use std::collections::HashSet;

/// What is left of a polygon, as the window's half-planes leave it one after the other. Pieces may be
/// joined along the borders, which changes neither the area nor where corners can be.
pub struct Expected {
    /// The corners, rounded once.
    pub corners: HashSet<[u32; 2]>,
    /// The area, and how much of it rounding all corners may move.
    area: f64,
    slack: f64,
}

pub fn clip(polygon: &Polygon, [xmin, ymin, xmax, ymax]: Sides) -> Expected {
    let mut corners: Vec<[Rational; 2]> = polygon.iter().map(|p| p.map(rational)).collect();
    for (axis, side, sign) in [(0, xmin, 1), (0, xmax, -1), (1, ymin, 1), (1, ymax, -1)] {
        let side = rational(side);
        let depth = |p: &[Rational; 2]| (&p[axis] - &side) * integer(sign);
        let mut left = Vec::new();
        for i in 0..corners.len() {
            let (p, q) = (&corners[i], &corners[(i + 1) % corners.len()]);
            let (dp, dq) = (depth(p), depth(q));
            if !dp.is_negative() {
                left.push(p.clone());
            }
            if dp.is_positive() && dq.is_negative() || dp.is_negative() && dq.is_positive() {
                let t = &dp / (&dp - &dq);
                left.push([0, 1].map(|i| crate::exact::between(&p[i], &q[i], &t)));
            }
        }
        corners = left;
    }
    let mut doubled = Rational::zero();
    let mut length = 0.0;
    for i in 0..corners.len() {
        let (p, q) = (&corners[i], &corners[(i + 1) % corners.len()]);
        doubled += &p[0] * &q[1] - &p[1] * &q[0];
        length += [0, 1]
            .map(|axis| (&q[axis] - &p[axis]).to_f64().unwrap_or(0.0))
            .iter()
            .map(|x| x.abs())
            .sum::<f64>();
    }
    let ulp = f64::from(f32::EPSILON) * f64::from(xmax.abs().max(xmin.abs()).max(ymax.abs()).max(ymin.abs()));
    Expected {
        corners: corners.iter().map(|p| bits([nearest(&p[0]), nearest(&p[1])])).collect(),
        area: doubled.to_f64().unwrap_or(0.0).abs() / 2.0,
        slack: length * ulp,
    }
}

/// Equal numbers have equal bits.
fn bits(p: [f32; 2]) -> [u32; 2] {
    p.map(|x| (x + 0.0).to_bits())
}

/// A part of the area missing or too much, more than rounding all corners moves; corners outside the
/// window; corners that are no nearest binary32 of an exact one (binary64 is rounded first).
pub const COLUMNS: [&str; 3] = ["area", "outside", "not nearest"];

/// How many polygons have a wrong area, then how many corners are wrong, in the order of [`COLUMNS`].
pub fn count(answers: &[Answer], expected: &[Expected], [xmin, ymin, xmax, ymax]: Sides) -> Vec<usize> {
    let [xmin, ymin, xmax, ymax] = [xmin, ymin, xmax, ymax].map(f64::from);
    let mut counts = vec![0; COLUMNS.len()];
    for (answer, expected) in answers.iter().zip(expected) {
        let area: f64 = answer.iter().map(|piece| area(piece)).sum::<f64>().abs();
        counts[0] += usize::from((area - expected.area).abs() > expected.slack);
        for &[x, y] in answer.iter().flatten() {
            counts[1] += usize::from(x < xmin || x > xmax || y < ymin || y > ymax);
            counts[2] += usize::from(!expected.corners.contains(&bits([x as f32, y as f32])));
        }
    }
    counts
}

/// Signed, by the shoelace formula.
fn area(piece: &[[f64; 2]]) -> f64 {
    (0..piece.len())
        .map(|i| {
            let ([x1, y1], [x2, y2]) = (piece[i], piece[(i + 1) % piece.len()]);
            (x1 * y2 - y1 * x2) / 2.0
        })
        .sum()
}
