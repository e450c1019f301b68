//! A triangle against clip space: an oracle that enumerates corners, and what neighbours rely on.

use crate::support::{Random, Triangle, clipped_corners, cross, dot, unit};
use rasterscope_core::{
    clip::polygon::{Corner, Origin, Plane, PlaneSet, Polygon, clip_triangle},
    math::{Dyadic, Sign, Tally},
    transform::DepthRange,
};

fn clip(triangle: Triangle, range: DepthRange) -> Polygon {
    clip_triangle(triangle, range, PlaneSet::All, &mut Tally::default())
}

/// The distances of the three vertices from a plane: a linear function of barycentric coordinates.
fn distances(plane: Plane, triangle: Triangle, range: DepthRange) -> [Dyadic; 3] {
    triangle.map(|v| {
        let [x, y, z, w] = v.map(Dyadic::from);
        match plane {
            Plane::Left => w + x,
            Plane::Right => w - x,
            Plane::Bottom => w + y,
            Plane::Top => w - y,
            Plane::Near if range == DepthRange::MinusOneToOne => w + z,
            Plane::Near => z,
            Plane::Far => w - z,
        }
    })
}

fn oracle(triangle: Triangle, range: DepthRange) -> Vec<[u32; 4]> {
    clipped_corners(triangle, Plane::ALL.into_iter().map(|plane| distances(plane, triangle, range)))
}

fn weights(origin: Origin, triangle: Triangle, range: DepthRange) -> [Dyadic; 3] {
    let point = match origin {
        Origin::Vertex(i) => unit(usize::from(i)),
        Origin::Edge { edge, plane } => cross(&unit(usize::from(edge)), &distances(plane, triangle, range)),
        Origin::Interior { planes: [a, b] } => {
            cross(&distances(a, triangle, range), &distances(b, triangle, range))
        }
    };
    let negative = (&point[0] + &point[1] + &point[2]).sign() == Sign::Negative;
    if negative { point.map(|p| -p) } else { point }
}

fn input(random: &mut Random) -> (Triangle, DepthRange) {
    let family = random.below(6);
    let range = random.pick(&DepthRange::ALL);
    let w = random.uniform(0.5, 3.0);
    let mut component = |i: usize| match family {
        0 => random.below(7) as f32 - 3.0,
        1 => random.grid(-4, 4),
        2 if i == 3 => w,
        2 => {
            let border = random.pick(&[w, -w, 0.0, w / 2.0]);
            random.near(border)
        }
        3 => random.any(),
        4 if i == 3 => random.uniform(0.5, 3.0),
        _ => random.uniform(-5.0, 5.0),
    };
    ([0; 3].map(|_| [0, 1, 2, 3].map(&mut component)), range)
}

fn sorted(corners: &[Corner]) -> Vec<[u32; 4]> {
    let mut sorted: Vec<_> =
        corners.iter().map(|corner| corner.position.map(|c| (c + 0.0).to_bits())).collect();
    sorted.sort_unstable();
    sorted
}

#[test]
fn agrees_with_the_oracle_and_fulfils_the_inequalities() {
    let mut random = Random::new(3);
    let (mut cut, mut interior, mut most) = (0, 0, 0);
    for _ in 0..30_000 {
        let (triangle, range) = input(&mut random);
        let polygon = clip(triangle, range);
        let corners = polygon.corners();
        let mut expected = oracle(triangle, range);
        if !polygon.is_whole() {
            expected.dedup();
            if expected.len() < 3 {
                expected.clear();
            }
        }
        assert_eq!(sorted(corners), expected, "{triangle:?} {range:?}");
        for corner in corners {
            let [x, y, z, w] = corner.position;
            let low = if range == DepthRange::ZeroToOne { 0.0 } else { -w };
            assert!(
                -w <= x && x <= w && -w <= y && y <= w && low <= z && z <= w,
                "{corner:?} of {triangle:?}"
            );
        }
        for i in 0..corners.len() {
            let [a, b, c] =
                [0, 1, 2].map(|k| weights(corners[(i + k) % corners.len()].origin, triangle, range));
            assert_eq!(dot(&cross(&a, &b), &c).sign(), Sign::Positive, "{triangle:?} turns at {i}");
        }
        cut += u32::from(!corners.is_empty() && !polygon.is_whole());
        interior += u32::from(corners.iter().any(|c| matches!(c.origin, Origin::Interior { .. })));
        most = most.max(corners.len());
    }
    assert!(
        cut > 2_000 && interior > 500 && most >= 6,
        "{cut} cut, {interior} with a frustum edge, most {most}"
    );
}

#[test]
fn what_lies_inside_comes_back_bit_for_bit() {
    let inside = [[-0.0, 0.25, 0.5, 1.0], [1.0, -1.0, 0.0, 1.0], [0.3, 2.0, 2.0, 2.0]];
    let polygon = clip(inside, DepthRange::ZeroToOne);
    let bits = |corners: &[Corner]| corners.iter().map(|c| c.position.map(f32::to_bits)).collect::<Vec<_>>();
    assert!(polygon.is_whole());
    assert_eq!(bits(polygon.corners()), inside.map(|v| v.map(f32::to_bits)));
}

#[test]
fn only_touching_is_nothing() {
    let cases = [
        // A vertex on the near plane, an edge on the right plane, the eye itself.
        [[0.0, 0.0, 0.0, 1.0], [0.1, 0.0, -1.0, 1.0], [0.0, 0.1, -1.0, 1.0]],
        [[1.0, 0.0, 0.5, 1.0], [1.0, 0.5, 0.5, 1.0], [2.0, 0.0, 0.5, 1.0]],
        [[0.0; 4], [2.0, 0.0, 0.0, 1.0], [2.0, 1.0, 0.0, 1.0]],
    ];
    for triangle in cases {
        assert!(clip(triangle, DepthRange::ZeroToOne).corners().is_empty(), "{triangle:?}");
    }
}

#[test]
fn order_of_vertices_only_turns_the_polygon() {
    let mut random = Random::new(4);
    for _ in 0..5_000 {
        let ([a, b, c], range) = input(&mut random);
        let polygon = clip([a, b, c], range);
        let expected = sorted(polygon.corners());
        for other in [[b, c, a], [c, a, b], [a, c, b], [b, a, c]] {
            assert_eq!(sorted(clip(other, range).corners()), expected, "{other:?}");
        }
        let pieces = |polygon: &Polygon| {
            let mut pieces: Vec<_> =
                polygon.fan().map(|piece| sorted(&piece.map(|i| polygon.corners()[i]))).collect();
            pieces.sort_unstable();
            pieces
        };
        assert_eq!(pieces(&clip([c, a, b], range)), pieces(&polygon));
        assert_eq!(pieces(&clip([b, a, c], range)), pieces(&polygon));
    }
}

#[test]
fn neighbours_meet_in_the_same_bits() {
    let mut random = Random::new(5);
    let mut met = 0;
    for _ in 0..10_000 {
        let ([a, b, c], range) = input(&mut random);
        let ([d, ..], _) = input(&mut random);
        // Edge 2 of both is the shared one, in opposite directions.
        let shared = |triangle: Triangle| {
            let polygon = clip(triangle, range);
            let on_edge = |c: &&Corner| {
                !matches!(
                    c.origin,
                    Origin::Interior { .. } | Origin::Vertex(2) | Origin::Edge { edge: 0 | 1, .. }
                )
            };
            let mut bits: Vec<_> =
                polygon.corners().iter().filter(on_edge).map(|c| c.position.map(f32::to_bits)).collect();
            bits.sort_unstable();
            bits
        };
        let (left, right) = (shared([a, b, c]), shared([b, a, d]));
        if left.len() == 2 && right.len() == 2 {
            assert_eq!(left, right, "{a:?} {b:?}");
            met += 1;
        }
    }
    assert!(met > 300, "{met} edges were visible in both");
}

#[test]
fn attributes_are_those_of_the_unclipped_triangle() {
    let triangle = [[-3.0, 0.0, 0.5, 1.0], [3.0, 0.0, 0.5, 1.0], [0.0, 3.0, 0.5, 1.0]];
    let polygon = clip(triangle, DepthRange::ZeroToOne);
    let mut tally = Tally::default();
    for corner in polygon.corners() {
        let [x, y, ..] = corner.position;
        let by_x = polygon.attribute(corner, triangle.map(|v| v[0]), &mut tally);
        let constant = polygon.attribute(corner, [0.1; 3], &mut tally);
        assert_eq!((by_x, constant), (x, 0.1));
        assert_eq!(polygon.attribute(corner, triangle.map(|v| v[1]), &mut tally), y);
    }
    assert_eq!(polygon.corners().len(), 4, "the square's upper half, cut at both sides and the top");
}

#[test]
fn near_only_leaves_the_sides_alone() {
    let triangle = [[-3.0, 0.0, -0.5, 1.0], [3.0, 0.0, 0.5, 1.0], [0.0, 3.0, 0.5, 1.0]];
    let polygon = clip_triangle(triangle, DepthRange::ZeroToOne, PlaneSet::Near, &mut Tally::default());
    let corners: Vec<_> = polygon.corners().iter().map(|corner| corner.position).collect();
    assert_eq!(corners, [[0.0, 0.0, 0.0, 1.0], triangle[1], triangle[2], [-1.5, 1.5, 0.0, 1.0]]);
}
