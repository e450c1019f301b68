//! The whole pipeline: one known image, image laws, run counts.

use crate::support::Random;
use rasterscope_core::{
    blend::{AlphaTest, BlendComponent, BlendFactor, BlendOperation, BlendState},
    cull::{CullMode, Facing, FrontFace},
    depth::{CompareFunction, DepthBias, DepthFormat, DepthPlacement, DepthState},
    labs::Stage,
    pipeline::{
        Bounding, DrawRuns, Frame, Outcome, Pipeline, Rasterizer, Reason, Skip, Skips, pixel_history,
        pixel_history_of, render,
    },
    raster::{Algorithm, FillRule, Scissor, YAxis},
    scene::{Draw, Geometry, Mesh, PRESETS, Scene, Shade, Texture, Transform},
    stencil::{StencilOperation, StencilState},
    transform::DepthRange,
};
use std::sync::Arc;

/// Draws of one triangle each, in one colour.
fn scene(triangles: &[([[f32; 3]; 3], [f32; 4])]) -> Scene {
    let draw = |(i, (positions, color)): (usize, &([[f32; 3]; 3], [f32; 4]))| {
        let name = char::from(b'A' + (i % 26) as u8);
        Draw::new(name, Geometry::Mesh(Arc::new(Mesh::soup(positions.to_vec(), *color))))
    };
    Scene { draws: triangles.iter().enumerate().map(draw).collect(), ..Scene::empty([36, 24]) }
}

/// Two triangles through each other, a third shows its back.
fn two_through_each_other() -> Scene {
    let mut scene = scene(&[
        ([[-3.4, -1.9, 0.9], [6.4, -1.0, -1.6], [0.2, 2.5, 0.1]], [1.0, 0.0, 0.0, 1.0]),
        ([[2.6, -2.3, 0.9], [1.9, 2.5, -1.0], [-3.3, 0.9, -0.9]], [0.0, 1.0, 0.0, 1.0]),
        ([[-3.6, -0.5, -0.9], [-1.1, 2.3, -0.6], [0.9, -2.1, 0.2]], [0.0, 0.0, 1.0, 1.0]),
    ]);
    scene.depth_format = DepthFormat::Unorm16;
    scene
}

/// The numbers that the design's mock of this scene was computed with, independently.
#[test]
fn known_scene_has_its_known_counts() {
    let frame = render(&two_through_each_other(), &Skips::ALL);
    let went = |stage| frame.stats.stage(stage).went;
    assert_eq!([went(Stage::Scene), went(Stage::Model), went(Stage::Cull), went(Stage::Clip)], [3, 9, 2, 3]);
    assert_eq!([went(Stage::Divide), went(Stage::Viewport)], [7, 7]);
    assert_eq!(frame.stats.stage(Stage::Cull).dropped(Reason::BackFace), 1);
    assert_eq!([went(Stage::Fragments), went(Stage::Depth)], [522, 422]);
    assert_eq!(frame.stats.stage(Stage::Depth).dropped(Reason::Depth), 100);
    assert_eq!(went(Stage::Image), 360);
    assert_eq!(frame.stats.stage(Stage::Image).dropped(Reason::Redrawn), 62);
    let at = frame.index([13, 11]);
    assert_eq!(frame.pixel([13, 11]), [255, 0, 0, 255]);
    assert_eq!(frame.depth_codes.as_ref().map(|codes| codes[at]), Some(0xDF60));
}

/// All skips, none, each alone off, each alone on.
fn skip_sets() -> Vec<Skips> {
    let single = |on| Skip::ALL.map(|skip| if on { Skips::NONE } else { Skips::ALL }.with(skip, on));
    [Skips::NONE, Skips::ALL].into_iter().chain(single(true)).chain(single(false)).collect()
}

/// The image by scan line, with nothing left out.
fn one_by_one(scene: &Scene) -> Frame {
    let mut pipeline = Pipeline::new(Algorithm::Scanline);
    pipeline.update(scene, &Skips::NONE);
    pipeline.into_frame()
}

/// Law 6 and law 5: no skip and no rasterizer changes a bit of the image.
#[track_caller]
fn check_image_laws(name: &str, scene: &Scene) {
    let expected = one_by_one(scene);
    for skips in skip_sets() {
        for rasterizer in Algorithm::ALL.map(Rasterizer::Each).into_iter().chain([Rasterizer::Engine]) {
            let mut pipeline = Pipeline::new(rasterizer);
            let frame = &pipeline.update(scene, &skips).frame;
            assert!(frame.same_image(&expected), "{name}: {skips:?} {rasterizer:?} change the image");
        }
    }
    // Nor what stands for an object in the frustum.
    for bounding in Bounding::ALL {
        let mut pipeline = Pipeline::new(Algorithm::Scanline);
        pipeline.bounding = bounding;
        let frame = &pipeline.update(scene, &Skips::ALL).frame;
        assert!(frame.same_image(&expected), "{name}: {bounding:?} changes the image");
    }
    // Neither does what was drawn before.
    let mut pipeline = Pipeline::default();
    let mut other = scene.clone();
    other.draws.reverse();
    other.camera.eye[0] += 0.5;
    for scene in [&other, scene] {
        pipeline.update(scene, &Skips::ALL);
    }
    assert!(pipeline.outputs().frame.same_image(&expected), "{name}: the image before shows through");
}

#[test]
fn skips_change_nothing_in_any_preset() {
    let mut load =
        |name: &str| rasterscope_core::scene::model(name).map(<[u8]>::to_vec).ok_or_else(|| name.to_string());
    for preset in PRESETS {
        let scene = Scene::from_json(preset.json.as_bytes()).expect("presets are right");
        let scene = scene.resolve(&mut load).expect("their models are built in");
        check_image_laws(preset.name, &scene);
    }
}

/// A scene of a few triangles, some behind the eye, some beside the picture, some degenerate.
pub(crate) fn random_scene(random: &mut Random) -> Scene {
    let mut scene = Scene::empty([1 + random.below(40), 1 + random.below(30)]);
    for _ in 0..1 + random.below(6) {
        let mut mesh = Mesh::soup(Vec::new(), [1.0; 4]);
        let far = random.pick(&[1.0, 3.0, 12.0]);
        for _ in 0..4 {
            mesh.positions.push([0; 3].map(|_| far * random.grid(-2, 2)));
            mesh.colors.push([0; 4].map(|_| random.grid(0, 1)));
            mesh.uvs.push([0; 2].map(|_| random.grid(-1, 2)));
        }
        mesh.triangles = (0..3).map(|_| [0; 3].map(|_| random.below(4))).collect();
        let mut draw = Draw::new("T", Geometry::Mesh(Arc::new(mesh)));
        draw.cull = random.pick(&[CullMode::None, CullMode::Back, CullMode::Front]);
        draw.depth = DepthState {
            test: random.below(4) > 0,
            compare: random.pick(&CompareFunction::ALL),
            write: random.below(4) > 0,
        };
        let reference = random.pick(&[0.0, 0.5, 0.75]);
        let compare = random.pick(&CompareFunction::ALL);
        draw.alpha_test = (random.below(3) == 0).then_some(AlphaTest { compare, reference });
        draw.scissor = (random.below(4) == 0).then(|| Scissor::from([0; 4].map(|_| random.below(25))));
        let bias =
            DepthBias { constant: random.pick(&[0, 0, -4]), slope: random.pick(&[0.0, 2.0]), clamp: 0.0 };
        draw.placement = DepthPlacement { bias, unclipped: random.below(4) == 0 };
        draw.stencil = (random.below(3) == 0).then(|| StencilState {
            compare: random.pick(&CompareFunction::ALL),
            fail_op: random.pick(&StencilOperation::ALL),
            depth_fail_op: random.pick(&StencilOperation::ALL),
            pass_op: random.pick(&StencilOperation::ALL),
            read_mask: random.pick(&[0xFF, 0x03]),
            write_mask: random.pick(&[0xFF, 0x05]),
            reference: random.below(4) as u8,
        });
        draw.blend = (random.below(3) == 0).then(|| {
            let component = BlendComponent {
                src_factor: random.pick(&[BlendFactor::SrcAlpha, BlendFactor::Constant, BlendFactor::Dst]),
                dst_factor: random.pick(&[BlendFactor::OneMinusSrcAlpha, BlendFactor::One]),
                operation: random.pick(&[BlendOperation::Add, BlendOperation::Max]),
            };
            BlendState { color: component, alpha: component, constant: [0.5, 0.25, 0.0, 1.0] }
        });
        draw.texture = (random.below(3) == 0).then_some(Texture::Checker { squares: 4 });
        draw.shade = random.pick(&Shade::ALL);
        scene.draws.push(draw);
    }
    scene.depth_range = random.pick(&DepthRange::ALL);
    scene.depth_format = random.pick(&DepthFormat::ALL);
    scene.reversed = random.below(2) == 0;
    scene.clear.depth = random.pick(&[0.0, 0.5, 1.0]);
    scene.fill_rule = random.pick(&FillRule::ALL);
    scene.y_axis = random.pick(&[YAxis::Down, YAxis::Up]);
    scene.samples = random.pick(&[1, 1, 1, 2, 4, 8]);
    scene.clear.color = random.pick(&[[0.0; 4], [0.2, 0.5, 1.0, 1.0]]);
    scene.clear.stencil = random.pick(&[0, 2]);
    for draw in &mut scene.draws {
        draw.front = random.pick(&[FrontFace::Ccw, FrontFace::Cw]);
    }
    scene
}

#[test]
fn skips_change_nothing_in_random_scenes() {
    let mut random = Random::new(7);
    for round in 0..300 {
        check_image_laws(&format!("scene {round}"), &random_scene(&mut random));
    }
}

#[test]
fn every_pixel_can_tell_its_history() {
    let mut random = Random::new(8);
    for round in 0..60 {
        let scene = random_scene(&mut random);
        let mut pipeline = Pipeline::new(Algorithm::Aabb);
        let outputs = pipeline.update(&scene, &Skips::ALL);
        let frame = &outputs.frame;
        for _ in 0..20 {
            let pixel = scene.size.map(|n| random.below(n));
            let history = pixel_history(&scene, outputs, pixel);
            let index = frame.index(pixel);
            assert_eq!(history.color, frame.pixel(pixel), "scene {round} at {pixel:?}");
            assert_eq!(history.stencil, frame.stencil[index], "scene {round} at {pixel:?}");
            let depth = scene.depth_format.decode(history.depth) as f32;
            assert_eq!(depth.to_bits(), frame.depth[index].to_bits(), "scene {round} at {pixel:?}");
            for entry in &history.entries {
                assert!(entry.reason().id.starts_with("pipeline-pixel-"));
            }
        }
    }
}

#[test]
fn history_names_the_reasons_of_the_known_pixel() {
    let history = pixel_history_of(&two_through_each_other(), [13, 11]);
    let names: Vec<_> = history.entries.iter().map(|entry| (&entry.name[..], entry.reason().id)).collect();
    let expected = [
        ("A.1", "pipeline-pixel-written"),
        ("A.2", "pipeline-pixel-outside-edge"),
        ("B", "pipeline-pixel-depth"),
        ("C", "pipeline-pixel-back-facing"),
    ];
    assert_eq!(names, expected);
    let depths = history.entries.iter().filter_map(|entry| match entry.outcome {
        Outcome::Depth { new, stored, .. } => Some((new, stored)),
        _ => None,
    });
    assert_eq!(depths.collect::<Vec<_>>(), [(0xE7BC, 0xDF60)]);
    let outside = history.entries.iter().find_map(|entry| match entry.outcome {
        Outcome::OutsideEdge { edge, value } => Some((edge, (value * 100.0).round() / 100.0)),
        _ => None,
    });
    assert_eq!(outside, Some((0, -248.86)));
    let culled = history.entries.iter().find(|entry| entry.name == "C").map(|entry| entry.outcome);
    let Some(Outcome::Culled { facing: Facing::Back, determinant, would_cover: true }) = culled else {
        panic!("{culled:?}");
    };
    assert!(determinant < 0.0, "front is counter-clockwise: {determinant}");
}

#[test]
fn a_drag_reruns_only_what_depends_on_it() {
    let mut scene = two_through_each_other();
    let mut pipeline = Pipeline::new(Algorithm::Scanline);
    pipeline.update(&scene, &Skips::ALL);
    let first: Vec<_> = (0..3).map(|draw| pipeline.runs(draw)).collect();
    assert_eq!((first[0].total(), pipeline.image_runs()), (DrawRuns::STAGES, 1));

    pipeline.update(&scene, &Skips::ALL);
    assert_eq!((pipeline.runs(1), pipeline.image_runs()), (first[1], 1), "nothing changed, nothing ran");
    assert_eq!(pipeline.outputs().frame.stats.skipped(Skip::Memo), 25);

    let mut mesh = Mesh::clone(scene.draws[1].geometry.mesh().expect("it is a mesh"));
    mesh.positions[0][0] += 0.25;
    scene.draws[1].geometry = Geometry::Mesh(Arc::new(mesh));
    pipeline.update(&scene, &Skips::ALL);
    assert_eq!([pipeline.runs(0), pipeline.runs(2)], [first[0], first[2]], "A and C stand still");
    assert_eq!(pipeline.runs(1).world, 2);
    assert_eq!(pipeline.image_runs(), 2);

    scene.clear.color = [0.0, 0.0, 1.0, 1.0];
    let before = pipeline.runs(1);
    pipeline.update(&scene, &Skips::ALL);
    assert_eq!((pipeline.runs(1), pipeline.image_runs()), (before, 3), "only the image");
    assert_eq!(pipeline.outputs().frame.pixel([0, 0]), [0, 0, 255, 255]);
}

#[test]
fn a_colour_moves_no_vertex() {
    let mut scene = two_through_each_other();
    let mut pipeline = Pipeline::new(Algorithm::Scanline);
    pipeline.update(&scene, &Skips::ALL);
    let before = pipeline.runs(0);
    let mut mesh = Mesh::clone(scene.draws[0].geometry.mesh().expect("it is a mesh"));
    mesh.colors = vec![[1.0; 4]; 3];
    scene.draws[0].geometry = Geometry::Mesh(Arc::new(mesh));
    pipeline.update(&scene, &Skips::ALL);
    let after = pipeline.runs(0);
    assert_eq!(
        [after.view, after.clip, after.cull, after.viewport],
        [before.view, before.clip, before.cull + 1, before.viewport]
    );
    assert_eq!(pipeline.outputs().frame.pixel([13, 11]), [255; 4]);
}

#[test]
fn skips_count_what_they_leave_out() {
    let mut scene = scene(&[
        ([[40.0, 0.0, 0.0], [41.0, 0.0, 0.0], [40.0, 1.0, 0.0]], [1.0; 4]),
        ([[-1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [1.0, -1.0, 0.0]], [1.0; 4]),
        ([[-1.0, -1.0, 0.0], [0.0, 0.0, 0.0], [1.0, 1.0, 0.0]], [1.0; 4]),
        ([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0]], [1.0; 4]),
        ([[-1.0, -1.0, -1.0], [1.0, -1.0, -1.0], [1.0, 1.0, -1.0]], [0.5; 4]),
    ]);
    scene.size = [30, 20];
    let counts = |skips: Skips| {
        let stats = render(&scene, &skips).stats;
        [Skip::ObjectFrustum, Skip::Frustum, Skip::BackFace, Skip::Degenerate].map(|skip| stats.skipped(skip))
    };
    assert_eq!(counts(Skips::ALL), [1, 0, 1, 1]);
    assert_eq!(counts(Skips::ALL.with(Skip::ObjectFrustum, false)), [0, 1, 1, 1]);
    assert_eq!(counts(Skips::NONE), [0; 4]);
    let stats = render(&scene, &Skips::ALL).stats;
    let behind = stats.stage(Stage::Depth).dropped(Reason::Depth);
    assert!(behind > 0 && stats.skipped(Skip::EarlyZ) == behind);
    let carried = render(&scene, &Skips::NONE).stats.stage(Stage::Fragments).dropped(Reason::Carried);
    assert!(carried > 0, "the back face came to the fragments");
}

#[test]
fn what_reaches_behind_the_eye_is_cut_at_the_near_plane() {
    // From in front of the camera to far behind it: the floor fills the lower half.
    let floor = [[-50.0, -1.0, 20.0], [50.0, -1.0, 20.0], [0.0, -1.0, -400.0]];
    let mut scene = scene(&[(floor, [1.0; 4])]);
    scene.draws[0].cull = CullMode::None;
    scene.camera.far = 1000.0;
    let frame = render(&scene, &Skips::ALL);
    let rows: String = (0..24).map(|y| if frame.pixel([18, y]) == [255; 4] { '#' } else { '.' }).collect();
    assert_eq!(rows, "............############");
    assert!(frame.stats.cut == 1);
    let history = pixel_history_of(&scene, [18, 2]);
    assert!(!matches!(history.entries[0].outcome, Outcome::Written { .. }));

    let behind = [[-1.0, -1.0, 6.0], [1.0, -1.0, 6.0], [0.0, 1.0, 6.0]];
    let mut scene = self::scene(&[(behind, [1.0; 4])]);
    scene.draws[0].cull = CullMode::None;
    for skips in [Skips::ALL, Skips::NONE] {
        let frame = render(&scene, &skips);
        assert_eq!(frame.stats.stage(Stage::Image).went, 0, "a triangle behind the eye has no image");
    }
}

#[test]
fn a_mirror_flips_the_facing() {
    let triangle = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
    let mut scene = scene(&[(triangle, [1.0; 4])]);
    let drawn = |scene: &Scene| render(scene, &Skips::ALL).stats.stage(Stage::Image).went;
    let all = drawn(&scene);
    assert!(all > 0);
    scene.draws[0].transform =
        Transform::Parts { translate: [0.0; 3], rotate_degrees: [0.0; 3], scale: [-1.0, 1.0, 1.0] };
    assert_eq!(drawn(&scene), 0);
    scene.draws[0].front = FrontFace::Cw;
    assert_eq!(drawn(&scene), all);
}

#[test]
fn checker_looks_up_the_nearest_square() {
    let texture = Texture::Checker { squares: 2 };
    let factors = |points: [[f32; 2]; 5]| points.map(|[u, v]| texture.factor(u, v));
    assert_eq!(
        factors([[0.0, 0.0], [0.5, 0.0], [0.5, 0.5], [-0.1, 0.0], [1.0, -0.5]]),
        [1.0, 0.25, 1.0, 0.25, 0.25]
    );
}

#[test]
fn flat_shade_keeps_what_faces_the_eye() {
    let triangle = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 2.0, 0.0]];
    let mut scene = scene(&[(triangle, [1.0; 4])]);
    scene.draws[0].shade = Shade::Flat;
    let at = |scene: &Scene| render(scene, &Skips::ALL).pixel([18, 12]);
    assert_eq!(at(&scene), [255; 4]);
    scene.draws[0].transform =
        Transform::Parts { translate: [0.0; 3], rotate_degrees: [0.0, 60.0, 0.0], scale: [1.0; 3] };
    // cos 60 = 1/2 gives (1 + 3/2) / 4 = 0.625, a hair off: the matrix is rounded.
    assert_eq!(at(&scene), [159, 159, 159, 255]);
}

/// Objects on the border of the frustum, turned, stretched, mirrored and projected: what stands for them
/// never hides a pixel.
#[test]
fn no_body_around_an_object_hides_what_is_seen() {
    let mut random = Random::new(9);
    let mut skipped = [0; 3];
    for round in 0..400 {
        let mut scene = Scene::empty([16, 12]);
        for _ in 0..1 + random.below(12) {
            let mut mesh = Mesh::soup((0..6).map(|_| [0; 3].map(|_| random.grid(-1, 1))).collect(), [1.0; 4]);
            mesh.triangles.push([0, 2, 4]);
            let mut draw = Draw::new("T", Geometry::Mesh(Arc::new(mesh)));
            draw.cull = CullMode::None;
            let translate = [random.grid(-8, 8), random.grid(-6, 6), random.grid(-7, 7)];
            let rotate_degrees = [0; 3].map(|_| random.uniform(-180.0, 180.0));
            let scale = [0; 3].map(|_| random.pick(&[1.0, -1.0, 0.25, 3.0]));
            draw.transform = Transform::Parts { translate, rotate_degrees, scale };
            if random.below(10) == 0 {
                let mut matrix = [0.0; 16].map(|_: f32| random.grid(-2, 2));
                matrix[15] = 1.0;
                draw.transform = Transform::Matrix(matrix);
            }
            scene.draws.push(draw);
        }
        let expected = render(&scene, &Skips::NONE);
        for (bounding, skipped) in Bounding::ALL.into_iter().zip(&mut skipped) {
            let mut pipeline = Pipeline::new(Algorithm::Scanline);
            pipeline.bounding = bounding;
            let frame = &pipeline.update(&scene, &Skips::ALL).frame;
            assert!(frame.same_image(&expected), "scene {round}: {bounding:?} changes the image");
            *skipped += frame.stats.skipped(Skip::ObjectFrustum);
        }
    }
    let [by_box, by_sphere, by_tree] = skipped;
    assert!(by_box > by_sphere && by_box > by_tree && by_sphere > 1_000 && by_tree > 1_000, "{skipped:?}");
}
