//! Images drawn as a whole by the engine: the same bytes and the same counts as one triangle after another.

use crate::{pipeline::random_scene, support::Random};
use rasterscope_core::{
    cull::CullMode,
    depth::DepthFormat,
    engine::{Canvas, Clear, Colors, Engine, Lanes, State, Stencil, Threads, Triangles},
    labs::Stage,
    pipeline::{Frame, Picture, Pipeline, Rasterizer, Reason, Skip, Skips},
    raster::Algorithm,
    scene::{Draw, Geometry, Mesh, PRESETS, Scene, model},
    transform::{Camera, Projection},
};
use std::sync::Arc;

fn drawn(scene: &Scene, rasterizer: Rasterizer, skips: &Skips) -> Frame {
    let mut pipeline = Pipeline::new(rasterizer);
    pipeline.update(scene, skips);
    pipeline.into_frame()
}

/// The same image, and in each stage the same counts, also of what was dropped and why.
#[track_caller]
fn check(name: &str, scene: &Scene, skips: Skips) {
    let each = drawn(scene, Rasterizer::Each(Algorithm::Scanline), &skips);
    let whole = drawn(scene, Rasterizer::Engine, &skips);
    assert!(whole.same_image(&each), "{name}, {skips:?}: another image");
    assert!(Picture::default().draw(scene).same_image(&each), "{name}: another picture");
    for stage in Stage::ALL {
        assert_eq!(whole.stats.stage(stage), each.stats.stage(stage), "{name}, {skips:?}, {stage:?}");
    }
    for skip in [Skip::EarlyZ, Skip::BackFace, Skip::Frustum] {
        assert_eq!(whole.stats.skipped(skip), each.stats.skipped(skip), "{name}, {skips:?}, {skip:?}");
    }
}

fn skip_sets() -> impl Iterator<Item = Skips> {
    let without =
        [Skip::EarlyZ, Skip::Deferred, Skip::HierarchicalZ, Skip::Tile, Skip::BackFace, Skip::Clear];
    [Skips::ALL, Skips::NONE].into_iter().chain(without.map(|skip| Skips::ALL.with(skip, false)))
}

#[test]
fn presets_are_drawn_and_counted_alike() {
    let mut load = |name: &str| model(name).map(<[u8]>::to_vec).ok_or_else(|| name.to_string());
    for preset in PRESETS {
        let scene = Scene::from_json(preset.json.as_bytes()).expect("presets are right");
        let scene = scene.resolve(&mut load).expect("their models are built in");
        check(preset.name, &scene, Skips::ALL);
    }
}

#[test]
fn random_scenes_over_many_tiles_are_drawn_and_counted_alike() {
    let mut random = Random::new(20);
    for round in 0..120 {
        let mut scene = random_scene(&mut random);
        // Larger than a tile in both directions, and not a multiple of one.
        scene.size = [60 + random.below(90), 50 + random.below(100)];
        for skips in skip_sets() {
            check(&format!("scene {round}"), &scene, skips);
        }
    }
}

/// Colours that change from pixel to pixel: of slivers, in steep perspective, and between two codes.
#[test]
fn colours_that_are_hard_to_round_are_drawn_alike() {
    let mut random = Random::new(23);
    for round in 0..60 {
        let steep = round % 2 == 0;
        let camera = Camera {
            eye: [0.0, 0.0, if steep { 0.0 } else { 5.0 }],
            target: [0.0, 0.0, -1.0],
            near: if steep { 1e-3 } else { 1.0 },
            far: 1e3,
            projection: if steep {
                Projection::Perspective { fovy_degrees: 90.0 }
            } else {
                Projection::Orthographic { height: 2.0 }
            },
            ..Camera::default()
        };
        let mut corner = || {
            let far = if steep { random.pick(&[2e-3, 0.1, 3.0, 400.0]) } else { 1.0 };
            [random.uniform(-2.0, 2.0) * far, random.uniform(-2.0, 2.0) * far, -far]
        };
        let (mut positions, mut colors) = (Vec::new(), Vec::new());
        for _ in 0..20 {
            let (a, b, c) = (corner(), corner(), corner());
            positions.extend([a, b, c]);
            // Nearly on the edge from a to b.
            positions.extend([a, b, [0, 1, 2].map(|i| (a[i] + b[i]) / 2.0 + c[i] * 1e-5)]);
        }
        for _ in &positions {
            let value =
                |random: &mut Random| random.pick(&[0.0, 1e-30, 0.5 / 255.0, 0.5, 100.5 / 255.0, 1.0]);
            colors.push([(); 4].map(|()| value(&mut random)));
        }
        let mesh = Mesh { colors, ..Mesh::soup(positions, [1.0; 4]) };
        let draw = Draw { cull: CullMode::None, ..Draw::new("A", Geometry::Mesh(Arc::new(mesh))) };
        let scene = Scene { camera, draws: vec![draw], ..Scene::empty([70, 66]) };
        check(&format!("triangles {round}"), &scene, Skips::ALL);
    }
    // From 0 to 1 over 255 pixels: each centre lies between two codes.
    let scene = Scene::from_json(
        br#"{"rasterscope": 1, "size": [255, 64], "camera": {"projection": {"kind": "orthographic", "height": 64}},
             "draws": [{"vertices": [[-127.5, -32, 0], [127.5, -32, 0], [-127.5, 32, 0]],
                        "colors": [[0, 0.5, 1, 1], [1, 0.5, 0, 1], [0, 0.5, 1, 1]], "cull": "none"}]}"#,
    )
    .expect("it is right");
    check("between two codes", &scene, Skips::ALL);
}

/// Scenes of which nothing but the image is made: seen from anywhere, also from inside, cut by any plane.
#[test]
fn pictures_are_the_whole_pipelines() {
    let mut random = Random::new(29);
    let mut picture = Picture::default();
    for round in 0..400 {
        let mut scene = random_scene(&mut random);
        let size = [60 + random.below(90), 50 + random.below(100)];
        scene.size = random.pick(&[size, [133, 70]]);
        scene.depth_format = DepthFormat::F32;
        scene.samples = 1;
        for draw in &mut scene.draws {
            let Draw { name, geometry, transform, cull, front, .. } = draw.clone();
            *draw = Draw { transform, cull, front, ..Draw::new(name, geometry) };
        }
        picture.set_threads(Threads::new(1 + round % 3));
        let expected = drawn(&scene, Rasterizer::Each(Algorithm::Scanline), &Skips::ALL);
        assert!(picture.draw(&scene).same_image(&expected), "scene {round}: {}", scene.to_json());
    }
}

/// Slivers along rows of centres: rounding to the screen turns some of them over, but which side is seen was decided
/// before.
#[test]
fn what_is_seen_nearly_from_the_side_is_culled_alike() {
    let mut random = Random::new(31);
    let [width, height] = [133.0, 70.0];
    let camera = Camera { eye: [0.0, 0.0, 5.0], target: [0.0; 3], near: 1.0, far: 10.0, ..Camera::default() };
    let Projection::Perspective { fovy_degrees } = camera.projection else { panic!("it is perspective") };
    let tangent = (f64::from(fovy_degrees) / 2.0).to_radians().tan();
    let mut picture = Picture::default();
    for cull in [CullMode::Back, CullMode::Front, CullMode::None] {
        let mut positions = Vec::new();
        for _ in 0..3000 {
            let row = f64::from(1 + random.below(68)) + 0.5;
            for _ in 0..3 {
                let x = 2.0 * f64::from(random.uniform(5.0, 128.0)) / width - 1.0;
                let y = 1.0 - 2.0 * (row + 1e-6 * f64::from(random.below(9)) - 4e-6) / height;
                let depth = f64::from(random.uniform(2.0, 8.0));
                let at = [x * width / height * tangent * depth, y * tangent * depth, 5.0 - depth];
                positions.push(at.map(|coordinate| coordinate as f32));
            }
        }
        let mut mesh = Mesh::soup(positions, [1.0; 4]);
        mesh.colors.iter_mut().for_each(|color| *color = [0; 4].map(|_| random.uniform(0.0, 1.0)));
        let draw = Draw { cull, ..Draw::new("A", Geometry::Mesh(Arc::new(mesh))) };
        let scene = Scene { camera, draws: vec![draw], ..Scene::empty([133, 70]) };
        let expected = drawn(&scene, Rasterizer::Each(Algorithm::Scanline), &Skips::ALL);
        assert!(expected.color.iter().any(|&code| code > 0), "{cull:?}: something is seen");
        assert!(picture.draw(&scene).same_image(&expected), "{cull:?}");
    }
}

/// What is drawn next does not depend on what was drawn before, however the two differ.
#[test]
fn one_image_after_another() {
    let mut random = Random::new(21);
    let mut pipeline = Pipeline::default();
    for round in 0..60 {
        let scene = random_scene(&mut random);
        let expected = drawn(&scene, Rasterizer::Each(Algorithm::Scanline), &Skips::NONE);
        for _ in 0..2 {
            assert!(pipeline.update(&scene, &Skips::ALL).frame.same_image(&expected), "scene {round}");
            // The same size and clear values, so that the tiles are kept.
            let moved = Scene { draws: scene.draws[1..].to_vec(), ..scene.clone() };
            pipeline.update(&moved, &Skips::ALL);
        }
    }
}

/// One triangle hides another, drawn before it or behind it: all pixels are counted, and coloured once.
#[test]
fn what_is_hidden_is_counted_and_costs_no_colour() {
    let scene = Scene::from_json(
        br#"{"rasterscope": 1, "size": [200, 150], "draws": [
            {"name": "near", "vertices": [[-9, -9, 1], [9, -9, 1], [0, 9, 1]], "colors": [[1,0,0,1],[0,1,0,1],[0,0,1,1]]},
            {"name": "far", "vertices": [[-9, -9, 0], [9, -9, 0], [0, 9, 0]], "colors": [[1,0,0,1],[0,1,0,1],[0,0,1,1]]}
        ]}"#,
    )
    .expect("it is right");
    let frame = drawn(&scene, Rasterizer::Engine, &Skips::ALL);
    let fragments = frame.stats.stage(Stage::Fragments).went;
    assert!(fragments > 30_000, "{fragments}");
    assert_eq!(frame.stats.skipped(Skip::EarlyZ), fragments - frame.stats.stage(Stage::Image).went);
    assert!(frame.stats.skipped(Skip::HierarchicalZ) > 0);
    let mut backwards = scene.clone();
    backwards.draws.reverse();
    let frame = drawn(&backwards, Rasterizer::Engine, &Skips::ALL);
    let redrawn = frame.stats.stage(Stage::Image).dropped(Reason::Redrawn);
    assert!(redrawn > 20_000, "{redrawn}");
    assert_eq!(frame.stats.skipped(Skip::Deferred), redrawn);
}

/// Whatever draws: each vector unit of this machine, and 1, 2 and 7 threads.
#[test]
fn no_number_of_threads_and_no_vector_unit_changes_a_byte() {
    let mut random = Random::new(22);
    let mut triangles = Vec::new();
    for _ in 0..3000 {
        let [x, y] = [random.uniform(-20.0, 300.0), random.uniform(-20.0, 500.0)];
        let reach = random.pick(&[2.0, 6.0, 30.0]);
        let corner = |random: &mut Random| {
            let [x, y] = [x, y].map(|at| at + random.uniform(-reach, reach));
            [x, y, random.uniform(0.0, 1.0)]
        };
        triangles.extend([corner(&mut random), corner(&mut random), corner(&mut random)]);
    }
    let colors: Vec<_> = (0..3000_u32).map(u32::to_ne_bytes).collect();
    let input = Triangles { positions: &triangles, indices: None, colors: Colors::Each(&colors) };
    let draw = |lanes, threads| {
        let mut canvas = Canvas::new([290, 470], Clear::default(), Stencil::Without);
        let state = State { lanes, threads: Threads::new(threads), ..State::default() };
        let stats = Engine::default().draw(&mut canvas, Some(Clear::default()), &input, &state);
        (canvas.color().to_vec(), canvas.depth().to_vec(), stats)
    };
    let expected = draw(Lanes::widest(), 1);
    assert!(expected.2.hidden > 100, "{:?}", expected.2);
    for lanes in Lanes::all() {
        for threads in [1, 2, 7] {
            assert!(draw(lanes, threads) == expected, "{}, {threads} threads", lanes.name());
        }
    }
}
