//! A triangle against clip space: an oracle that enumerates the corners.

use super::{Operation, path};
use crate::{
    case::{Case, Reader, fresh, points},
    integers::{cross, dot, integer, nearest, sign},
    random::Random,
};
use num_bigint::BigInt;
use num_traits::Zero;
use rasterscope_core::{
    clip::polygon::{Origin, Plane, PlaneSet, clip_triangle},
    math::Tally,
    transform::DepthRange,
};

pub(super) const OPERATION: Operation =
    Operation { name: "clip-triangle", cases: 60_000, fresh: triangle, check, code };

type Triangle = [[f32; 4]; 3];

fn triangle(random: &mut Random) -> Case {
    let mut case = fresh(random, 13);
    if random.below(2) == 0 {
        // On the planes and beside them: x, y and z are w, -w, 0 or a neighbour of them.
        for place in 0..12 {
            let w = f32::from_bits(case[place | 3]);
            if place % 4 != 3 {
                let border = random.pick(&[w, -w, 0.0, w / 2.0]);
                case[place] = random.near(border).to_bits();
            }
        }
    }
    case
}

fn read(words: &[u32]) -> (Triangle, DepthRange) {
    let mut reader = Reader(words);
    let triangle = [0; 3].map(|_| reader.numbers());
    (triangle, reader.choice(&DepthRange::ALL))
}

fn code(words: &[u32]) -> String {
    let (triangle, range) = read(words);
    format!("let (triangle, range) = ({}, DepthRange::{range:?});", points(&triangle))
}

/// The distances of the vertices from a plane: a linear function of barycentric coordinates.
fn distances(plane: Plane, triangle: &[[BigInt; 4]; 3], range: DepthRange) -> [BigInt; 3] {
    triangle.each_ref().map(|[x, y, z, w]| match plane {
        Plane::Left => w + x,
        Plane::Right => w - x,
        Plane::Bottom => w + y,
        Plane::Top => w - y,
        Plane::Near if range == DepthRange::MinusOneToOne => w + z,
        Plane::Near => z.clone(),
        Plane::Far => w - z,
    })
}

/// The corners, rounded and sorted: where two of the nine lines (edges and planes) meet, on no
/// wrong side of the others.
fn oracle(triangle: Triangle, range: DepthRange) -> Vec<[u32; 4]> {
    let exact = triangle.map(|v| v.map(integer));
    let unit = |i: usize| [0, 1, 2].map(|j| BigInt::from(i32::from(i == j)));
    let planes = Plane::ALL.map(|plane| distances(plane, &exact, range));
    let lines: Vec<[BigInt; 3]> = (0..3).map(unit).chain(planes).collect();
    let mut corners: Vec<[BigInt; 3]> = Vec::new();
    for i in 0..lines.len() {
        for j in 0..i {
            let mut point = cross(&lines[i], &lines[j]);
            let sum = &point[0] + &point[1] + &point[2];
            if sum.is_zero() {
                continue; // the lines are the same, or meet at no point of the plane
            }
            if sign(&sum) < 0 {
                point = point.map(|p| -p);
            }
            let inside = lines.iter().all(|line| sign(&dot(line, &point)) >= 0);
            let new = |corner: &[BigInt; 3]| cross(corner, &point).iter().any(|d| !d.is_zero());
            if inside && corners.iter().all(new) {
                corners.push(point);
            }
        }
    }
    if corners.len() < 3 {
        return Vec::new();
    }
    let place = |weights: &[BigInt; 3]| {
        let sum = &weights[0] + &weights[1] + &weights[2];
        [0, 1, 2, 3].map(|axis| {
            let components = exact.each_ref().map(|v| v[axis].clone());
            (nearest(&dot(weights, &components), &sum) + 0.0).to_bits()
        })
    };
    let mut rounded: Vec<_> = corners.iter().map(place).collect();
    rounded.sort_unstable();
    rounded
}

fn check(words: &[u32]) -> Result<u64, String> {
    let (triangle, range) = read(words);
    let mut tally = Tally::default();
    let polygon = clip_triangle(triangle, range, PlaneSet::All, &mut tally);
    let mut found: Vec<_> =
        polygon.corners().iter().map(|corner| corner.position.map(|c| (c + 0.0).to_bits())).collect();
    found.sort_unstable();
    let mut expected = oracle(triangle, range);
    if !polygon.is_whole() {
        // Corners that round to one are one; what is left of a sliver may be nothing.
        expected.dedup();
        found.dedup();
        if expected.len() < 3 {
            expected.clear();
        }
    }
    if found != expected {
        let numbers = |corners: Vec<[u32; 4]>| -> Vec<_> {
            corners.into_iter().map(|corner| corner.map(f32::from_bits)).collect()
        };
        return Err(format!("{:?}, but exactly {:?}", numbers(found), numbers(expected)));
    }
    for corner in polygon.corners() {
        let [x, y, z, w] = corner.position;
        let low = if range == DepthRange::ZeroToOne { 0.0 } else { -w };
        if !(-w <= x && x <= w && -w <= y && y <= w && low <= z && z <= w) {
            return Err(format!("{:?} lies outside", corner.position));
        }
    }
    let origins: Vec<_> = polygon
        .corners()
        .iter()
        .map(|corner| match corner.origin {
            Origin::Vertex(i) => (0, usize::from(i), 0),
            Origin::Edge { edge, plane } => (1, usize::from(edge), plane as usize),
            Origin::Interior { planes: [a, b] } => (2, a as usize, b as usize),
        })
        .collect();
    Ok(path((origins, tally.exact)))
}
