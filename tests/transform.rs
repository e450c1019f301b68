//! The transform chain: laws, golden logs, and what the matrices must map where.

use crate::support::{Coverage, Random, check_golden, check_laws, log_text};
use rasterscope_core::{
    raster::YAxis,
    trace::NoTrace,
    transform::{
        Camera, DepthRange, Projection, Viewport, apply,
        chain::{self, Chain, Event, Snapshot},
        divide,
        matrices::{self, IDENTITY},
    },
};

fn chain(camera: &Camera, depth_range: DepthRange, y_axis: YAxis) -> Chain {
    let viewport = Viewport { size: [36, 24], depth_range, y_axis };
    Chain {
        model: matrices::model([0.5, -0.25, 0.0], [0.0, 90.0, 30.0], [1.0, 2.0, -1.0]),
        view: matrices::view(camera),
        projection: matrices::projection(camera, viewport.aspect(), depth_range, false),
        viewport,
    }
}

#[track_caller]
fn check(name: &str, vertex: [f32; 3]) {
    let mut events: Vec<Event> = Vec::new();
    let chain = chain(&Camera::default(), DepthRange::ZeroToOne, YAxis::Down);
    chain::run_traced(&[vertex], &chain, &mut events);
    check_golden(&format!("transform/{name}"), &log_text(&events));
}

#[test]
fn vertex_in_front() {
    check("in_front", [0.5, 0.5, 0.25]);
}

#[test]
fn vertex_beside_the_picture() {
    check("beside", [0.0, 6.0, 0.0]);
}

#[test]
fn vertex_behind_the_eye() {
    check("behind", [-7.0, 0.0, 0.0]);
}

#[test]
fn vertex_in_the_plane_of_the_eye() {
    check("no_image", [-5.0, 1.0, 0.0]);
}

#[test]
fn vertex_at_the_origin() {
    check("origin", [0.0; 3]);
}

#[test]
fn the_chain_keeps_the_laws() {
    let mut random = Random::new(6);
    let mut coverage = Coverage::default();
    for round in 0..60 {
        let camera = Camera { eye: [random.grid(-4, 4), 1.0, 5.0], ..Camera::default() };
        let y_axis = [YAxis::Down, YAxis::Up][round % 2];
        let chain = chain(&camera, random.pick(&DepthRange::ALL), y_axis);
        let vertices: Vec<[f32; 3]> =
            (0..1 + round % 3).map(|_| [0; 3].map(|_| random.grid(-8, 8))).collect();
        let mut events = Vec::new();
        let traced = chain::run_traced(&vertices, &chain, &mut events);
        let fast = chain::run_traced(&vertices, &chain, &mut NoTrace);
        let play = |budget| chain::play(vertices.clone(), chain, budget);
        check_laws((&fast, &traced), &events, play, Snapshot::result, &mut coverage);
    }
    coverage.check_every_line::<Snapshot>();
}

/// Depth in NDC of a point straight ahead.
fn depth(camera: &Camera, range: DepthRange, reversed: bool, distance: f32) -> f32 {
    let projection = matrices::projection(camera, 1.5, range, reversed);
    divide(apply(&projection, [0.0, 0.0, -distance, 1.0]))[2]
}

#[test]
fn near_and_far_map_to_the_ends_of_the_depth_range() {
    let kinds = [Projection::Perspective { fovy_degrees: 60.0 }, Projection::Orthographic { height: 3.0 }];
    for projection in kinds {
        let camera = Camera { projection, ..Camera::default() };
        for (range, low) in [(DepthRange::MinusOneToOne, -1.0), (DepthRange::ZeroToOne, 0.0)] {
            for (reversed, near, far) in [(false, low, 1.0), (true, 1.0, low)] {
                // Two matrix entries and the division are rounded: a few ULP of the largest term, 20 / 9.
                let tolerance = 4.0 * f32::EPSILON;
                let got = [camera.near, camera.far].map(|d| depth(&camera, range, reversed, d));
                assert!((got[0] - near).abs() <= tolerance, "{projection:?} {range:?} near: {}", got[0]);
                assert!((got[1] - far).abs() <= tolerance, "{projection:?} {range:?} far: {}", got[1]);
            }
        }
    }
}

#[test]
fn the_field_of_view_reaches_the_border() {
    let camera = Camera { projection: Projection::Perspective { fovy_degrees: 90.0 }, ..Camera::default() };
    let projection = matrices::projection(&camera, 2.0, DepthRange::ZeroToOne, false);
    let [x, y, _, r] = divide(apply(&projection, [8.0, -4.0, -4.0, 1.0]));
    assert_eq!(([x, y], r), ([1.0, -1.0], 0.25));
}

#[test]
fn quarter_turns_are_exact() {
    let turned = |degrees| apply(&matrices::model([0.0; 3], degrees, [1.0; 3]), [1.0, 2.0, 3.0, 1.0]);
    assert_eq!(turned([90.0, 0.0, 0.0]), [1.0, -3.0, 2.0, 1.0]);
    assert_eq!(turned([0.0, 90.0, 0.0]), [3.0, 2.0, -1.0, 1.0]);
    assert_eq!(turned([0.0, 0.0, 90.0]), [-2.0, 1.0, 3.0, 1.0]);
    assert_eq!(turned([0.0, 0.0, -450.0]), [2.0, -1.0, 3.0, 1.0]);
    assert_eq!(turned([180.0, 0.0, 90.0]), [2.0, 1.0, -3.0, 1.0], "x is turned before z");
}

#[test]
fn scaling_comes_first_and_moving_last() {
    let matrix = matrices::model([10.0, 20.0, 30.0], [0.0, 0.0, 90.0], [2.0, 3.0, 4.0]);
    assert_eq!(apply(&matrix, [1.0, 1.0, 1.0, 1.0]), [7.0, 22.0, 34.0, 1.0]);
}

#[test]
fn the_default_camera_only_moves_the_world_away() {
    let mut expected = IDENTITY;
    expected[14] = -5.0;
    assert_eq!(matrices::view(&Camera::default()), expected);
}

#[test]
fn every_camera_has_a_view() {
    let nothing = Camera { target: [0.0, 0.0, 5.0], ..Camera::default() };
    assert_eq!(apply(&matrices::view(&nothing), [1.0, 2.0, 3.0, 1.0]), [1.0, 2.0, -2.0, 1.0]);
    let down = Camera { eye: [0.0, 5.0, 0.0], ..Camera::default() };
    let [x, y, z, w] = apply(&matrices::view(&down), [0.0, 1.0, 0.0, 1.0]);
    assert_eq!([x, y, z, w], [0.0, 0.0, -4.0, 1.0], "up along the line of sight");
}

#[test]
fn the_viewport_puts_corners_on_corners() {
    let corner = |y_axis, ndc| {
        Viewport { size: [36, 24], depth_range: DepthRange::MinusOneToOne, y_axis }.to_screen(ndc)
    };
    assert_eq!(corner(YAxis::Down, [-1.0, 1.0, -1.0, 0.5]), [0.0, 0.0, 0.0, 0.5]);
    assert_eq!(corner(YAxis::Down, [1.0, -1.0, 1.0, 0.5]), [36.0, 24.0, 1.0, 0.5]);
    assert_eq!(corner(YAxis::Up, [-1.0, -1.0, 0.0, 0.5]), [0.0, 0.0, 0.5, 0.5]);
}

#[test]
fn no_number_becomes_infinite() {
    let huge = [f32::MAX; 16];
    let image = apply(&huge, [f32::MAX; 4]);
    assert_eq!(image, [f32::MAX; 4]);
    assert_eq!(divide([1.0, -1.0, 0.0, f32::from_bits(1)]), [f32::MAX, f32::MIN, 0.0, f32::MAX]);
    assert_eq!(divide([1.0, 2.0, 3.0, 0.0]), [0.0; 4]);
}
