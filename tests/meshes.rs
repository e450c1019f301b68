//! Meshes are covered exactly once: no hole and no double pixel along a shared edge, whoever draws it.

use rasterscope_core::{
    math::{Arithmetic, Tally, orient2d},
    raster::{Algorithm, Settings, rows},
    scene::{MODELS, Mesh},
};
use std::collections::HashMap;

type Point = [f32; 2];

const SIZE: [u32; 2] = [96, 96];

/// How often each pixel is covered: by triangles that turn one way, less by those that turn the other.
fn balance(triangles: &[[Point; 3]], algorithm: Algorithm, arithmetic: Arithmetic) -> Vec<i32> {
    let settings = Settings { arithmetic, ..Settings::new(SIZE) };
    let mut balance = vec![0; (SIZE[0] * SIZE[1]) as usize];
    for &[a, b, c] in triangles {
        let turned = orient2d(a, b, c, &mut Tally::default());
        for span in rows(algorithm, [a, b, c], &settings, &mut Tally::default()) {
            let row = (span.y * SIZE[0]) as usize;
            let pixels = &mut balance[row + span.begin as usize..row + span.end as usize];
            pixels.iter_mut().for_each(|n| *n += if turned.is_positive() { 1 } else { -1 });
        }
    }
    balance
}

/// A mesh as seen along z, as large as the image, and closed: each edge without a partner is joined to
/// one more vertex.
fn closed(mesh: &Mesh) -> Vec<[Point; 3]> {
    let axis = |i: usize| mesh.positions.iter().map(move |p| p[i]);
    let (min, max) =
        ([0, 1].map(|i| axis(i).fold(f32::MAX, f32::min)), [0, 1].map(|i| axis(i).fold(f32::MIN, f32::max)));
    let scale = 90.0 / (max[0] - min[0]).max(max[1] - min[1]);
    let place = |i: u32| [0, 1].map(|k| (mesh.positions[i as usize][k] - min[k]) * scale + 3.0);
    let mut unpaired = HashMap::new();
    for &[a, b, c] in &mesh.triangles {
        for (p, q) in [(a, b), (b, c), (c, a)] {
            let (edge, along) = if p < q { ((p, q), 1_i32) } else { ((q, p), -1) };
            *unpaired.entry(edge).or_insert(0) += along;
        }
    }
    let apex = [47.3, 51.9];
    let mut triangles: Vec<_> = mesh.triangles.iter().map(|corners| corners.map(place)).collect();
    for ((p, q), n) in unpaired {
        let cap = if n > 0 { [place(q), place(p), apex] } else { [place(p), place(q), apex] };
        triangles.extend(std::iter::repeat_n(cap, n.unsigned_abs() as usize));
    }
    triangles
}

/// How many pixels are not covered as often from both sides.
fn wrong(triangles: &[[Point; 3]], algorithm: Algorithm, arithmetic: Arithmetic) -> usize {
    balance(triangles, algorithm, arithmetic).iter().filter(|n| **n != 0).count()
}

#[track_caller]
fn check(name: &str, triangles: &[[Point; 3]]) {
    for algorithm in Algorithm::ALL {
        assert_eq!(wrong(triangles, algorithm, Arithmetic::Exact), 0, "{name}, {algorithm:?}");
    }
}

#[test]
fn closed_surfaces_are_covered_as_often_from_both_sides() {
    for (name, text) in MODELS {
        let mesh = Mesh::from_obj(text).expect("a built-in model");
        check(name, &closed(&mesh));
    }
}

#[test]
fn a_missing_triangle_is_noticed() {
    let mesh = Mesh::from_obj(MODELS[0].1).expect("a built-in model");
    assert!(wrong(&closed(&mesh)[1..], Algorithm::Scanline, Arithmetic::Exact) > 0);
}

/// The two models of many courses, where they are at hand.
#[test]
fn large_models_are_covered_as_often_from_both_sides() {
    for file in ["teapot.obj", "bunny.obj"] {
        let path = format!("{}/../../shared/models/{file}", env!("CARGO_MANIFEST_DIR"));
        let Ok(text) = std::fs::read(path) else { continue };
        let mesh = Mesh::from_obj(&text).expect("a model");
        check(file, &closed(&mesh));
    }
}

/// A fan whose rays run through pixel centres, around one: the rim is the only border.
#[test]
fn a_fan_around_a_centre_covers_every_pixel_once() {
    let middle = [48.5, 48.5];
    let steps = [[1, 0], [2, 1], [1, 1], [1, 2]];
    let quarter = |[x, y]: [i32; 2], turn: usize| match turn {
        0 => [x, y],
        1 => [-y, x],
        2 => [-x, -y],
        _ => [y, -x],
    };
    let rim: Vec<Point> =
        (0..16).map(|i| quarter(steps[i % 4], i / 4).map(|step| 48.5 + 18.0 * step as f32)).collect();
    let fan: Vec<_> = (0..16).map(|i| [middle, rim[i], rim[(i + 1) % 16]]).collect();
    for algorithm in Algorithm::ALL {
        let balance = balance(&fan, algorithm, Arithmetic::Exact);
        assert!(balance.iter().all(|n| (0..=1).contains(n)), "{algorithm:?} draws a pixel twice");
        let inner = |i: usize| {
            let at = [i as u32 % SIZE[0], i as u32 / SIZE[0]].map(|at| at as f32 - 48.0);
            at[0].hypot(at[1]) < 16.0
        };
        assert!(
            (0..balance.len()).filter(|&i| inner(i)).all(|i| balance[i] == 1),
            "{algorithm:?} leaves a hole"
        );
    }
}
