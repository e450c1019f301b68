//! Visibility by other means: pairs in object space and rays through pixels see what the depth buffer sees.

use rasterscope_core::{
    depth::z_buffer,
    stress::Random,
    visibility::{
        object_pairs::{Relation, Triangle, relation, visible_parts},
        rays,
    },
};

const SIZE: [u32; 2] = [40, 30];

fn soup(count: usize, seed: u64) -> Vec<Triangle> {
    let mut random = Random::new(seed);
    let mut vertex = || [random.uniform(-4.0, 44.0), random.uniform(-4.0, 34.0), random.uniform(0.05, 0.95)];
    (0..count).map(|_| [vertex(), vertex(), vertex()]).collect()
}

#[test]
fn rays_show_what_the_depth_buffer_shows() {
    for seed in 0..4 {
        let triangles = soup(12, seed);
        let image = z_buffer::draw(&triangles, &z_buffer::Settings::new(SIZE));
        let seen = rays::nearest(&triangles, SIZE);
        assert_eq!(seen.intersections, 40 * 30 * 12);
        for y in 0..SIZE[1] {
            for x in 0..SIZE[0] {
                let owner = seen.owners[(y * SIZE[0] + x) as usize];
                assert_eq!(owner, image.owner([x, y]), "seed {seed}: ({x}, {y})");
            }
        }
    }
}

/// How far a point lies inside a convex polygon; negative outside.
fn depth_inside(part: &[[f64; 2]], [x, y]: [f64; 2]) -> f64 {
    let next = part.iter().cycle().skip(1);
    let sides = part
        .iter()
        .zip(next)
        .map(|([ax, ay], [bx, by])| ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / (bx - ax).hypot(by - ay));
    sides.fold(f64::INFINITY, f64::min)
}

#[test]
fn visible_parts_lie_where_the_depth_buffer_shows_them() {
    const NEAR: f64 = 1e-6;
    for seed in 10..14 {
        let triangles = soup(10, seed);
        let image = z_buffer::draw(&triangles, &z_buffer::Settings::new(SIZE));
        let (parts, counts) = visible_parts(&triangles);
        assert_eq!(counts.pairs(), 45);
        let mut looked_at = 0;
        for y in 0..SIZE[1] {
            for x in 0..SIZE[0] {
                let centre = [f64::from(x) + 0.5, f64::from(y) + 0.5];
                let inside: Vec<(usize, f64)> = (parts.iter().enumerate())
                    .flat_map(|(i, parts)| parts.iter().map(move |part| (i, depth_inside(part, centre))))
                    .filter(|(_, inside)| *inside > -NEAR)
                    .collect();
                if inside.iter().any(|(_, inside)| *inside < NEAR) {
                    continue; // on the side of a part: either may be right
                }
                looked_at += 1;
                assert!(inside.len() < 2, "parts overlap at ({x}, {y})");
                let owner = image.owner([x, y]).map(|owner| owner as usize);
                assert_eq!(inside.first().map(|(i, _)| *i), owner, "seed {seed}: ({x}, {y})");
            }
        }
        assert!(looked_at > 1_100, "{looked_at}");
    }
}

#[test]
fn the_four_relations_are_told_apart() {
    let large = |z: f32| [[0.0, 0.0, z], [20.0, 0.0, z], [0.0, 20.0, z]];
    let small = |z: f32| [[2.0, 2.0, z], [6.0, 2.0, z], [2.0, 6.0, z]];
    let away = [[30.0, 30.0, 0.1], [35.0, 30.0, 0.1], [30.0, 35.0, 0.1]];
    let through = [[2.0, 2.0, 0.1], [6.0, 2.0, 0.9], [2.0, 6.0, 0.9]];
    for (name, first, second, expected) in [
        ("a large one in front", large(0.2), small(0.5), Relation::Hides),
        ("a large one behind", small(0.5), large(0.2), Relation::IsHidden),
        ("a small one in front", small(0.2), large(0.5), Relation::Partly),
        ("side by side", large(0.5), away, Relation::Apart),
        ("through each other", large(0.5), through, Relation::Partly),
        ("the same twice: the first is seen", small(0.5), small(0.5), Relation::Hides),
    ] {
        assert_eq!(relation(&first, &second), expected, "{name}");
    }
    let flat = [[0.0, 0.0, 0.0], [5.0, 5.0, 0.0], [9.0, 9.0, 0.0]];
    assert_eq!(relation(&flat, &large(0.5)), Relation::Apart);
    assert!(visible_parts(&[flat]).0[0].is_empty());
}
