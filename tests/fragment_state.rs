//! Scissor, alpha test, bias and depth clamp of a draw: what they leave of the image, and what they say.

use crate::support::covered;
use rasterscope_core::{
    blend::AlphaTest,
    depth::{CompareFunction, DepthBias, DepthFormat, DepthState, Early},
    labs::Stage,
    message::Value,
    pipeline::{Outcome, Reason, Skip, Skips, pixel_history_of, render, screen_triangles},
    raster::{self, Scissor},
    scene::{Draw, Geometry, Mesh, Scene},
    stencil::{StencilOperation, StencilState},
};
use std::sync::Arc;

const WALL: [[f32; 3]; 3] = [[-3.0, -2.0, 0.0], [3.0, -2.0, 0.0], [0.0, 2.5, 0.0]];

fn scene(triangles: &[([[f32; 3]; 3], [f32; 4])]) -> Scene {
    let draw = |(positions, color): &([[f32; 3]; 3], [f32; 4])| {
        Draw::new("", Geometry::Mesh(Arc::new(Mesh::soup(positions.to_vec(), *color))))
    };
    Scene { draws: triangles.iter().map(draw).collect(), ..Scene::empty([24, 16]) }
}

fn white(triangle: [[f32; 3]; 3]) -> Scene {
    scene(&[(triangle, [1.0; 4])])
}

fn drawn(scene: &Scene) -> usize {
    render(scene, &Skips::ALL).color.chunks(4).filter(|pixel| pixel[3] != 0).count()
}

fn dark() -> Scene {
    let mut scene = white(WALL);
    scene.clear.color = [0.0; 4];
    scene
}

#[test]
fn a_scissor_keeps_the_pixels_of_its_rectangle() {
    let mut scene = dark();
    let scissor = Scissor { x: 9, y: 7, width: 6, height: 20 };
    scene.draws[0].scissor = Some(scissor);
    let frame = render(&scene, &Skips::ALL);
    let [triangle] = &screen_triangles(&scene)[..] else { panic!("one triangle") };
    let spans = covered(triangle.vertices.map(|[x, y, _]| [x, y]), &raster::Settings::new(scene.size));
    let inside = |x, y| spans.iter().any(|span| span.y == y && (span.begin..span.end).contains(&x));
    let mut kept = 0;
    for y in 0..16 {
        for x in 0..24 {
            let expected = inside(x, y) && (9..15).contains(&x) && (7..27).contains(&y);
            assert_eq!(frame.pixel([x, y])[3] != 0, expected, "({x}, {y})");
            kept += u64::from(expected);
        }
    }
    let all: u32 = spans.iter().map(raster::Span::len).sum();
    let count = frame.stats.stage(Stage::Fragments);
    assert_eq!((count.went, count.dropped(Reason::Scissor)), (kept, u64::from(all) - kept));
    let history = pixel_history_of(&scene, [8, 10]);
    assert_eq!(history.entries[0].outcome, Outcome::Scissored(scissor));
    let details = history.entries[0].details(&scene);
    assert_eq!(details[0].args.iter().find(|(name, _)| *name == "right"), Some(&("right", Value::Int(15))));
}

/// Alpha 0 at one vertex and 1 at the others, over a wall that is drawn later and lies behind.
fn leaf() -> Scene {
    let near = WALL.map(|[x, y, _]| [x, y, 0.5]);
    let mut scene = scene(&[(near, [0.0, 1.0, 0.0, 1.0]), (WALL, [1.0; 4])]);
    if let Geometry::Mesh(mesh) = &mut scene.draws[0].geometry {
        Arc::make_mut(mesh).colors[2][3] = 0.0;
    }
    scene.draws[0].alpha_test = Some(AlphaTest::default());
    scene
}

#[test]
fn what_is_discarded_writes_no_depth() {
    let scene = leaf();
    for skips in [Skips::ALL, Skips::NONE] {
        let frame = render(&scene, &skips);
        // Near the top the leaf is discarded: the wall shows through it.
        assert_eq!(frame.pixel([12, 5]), [255; 4]);
        assert_eq!(frame.pixel([12, 11])[1], 255);
        assert!(frame.pixel([12, 11])[0] == 0, "green");
        assert!(frame.stats.stage(Stage::Fragments).dropped(Reason::Discarded) > 10);
    }
    let history = pixel_history_of(&scene, [12, 5]);
    let Outcome::Discarded { alpha } = history.entries[0].outcome else {
        panic!("{:?}", history.entries[0].outcome)
    };
    assert!(alpha < 0.5, "{alpha}");
    assert_eq!(history.entries[1].reason().id, "pipeline-pixel-written");
}

#[test]
fn alpha_is_compared_exactly() {
    let mut scene = dark();
    let all = drawn(&scene);
    if let Geometry::Mesh(mesh) = &mut scene.draws[0].geometry {
        Arc::make_mut(mesh).colors = vec![[1.0, 1.0, 1.0, 0.3]; 3];
    }
    for compare in CompareFunction::ALL {
        for (reference, above) in [(0.3_f32, 0), (0.3_f32.next_up(), -1), (0.3_f32.next_down(), 1)] {
            scene.draws[0].alpha_test = Some(AlphaTest { compare, reference });
            let expected = if compare.passes(above, 0) { all } else { 0 };
            assert_eq!(drawn(&scene), expected, "{compare:?} {reference}");
        }
    }
}

/// A failing fragment that counts in the stencil waits for its alpha test; one that does not is left out.
#[test]
fn early_z_stops_where_a_discarded_fragment_would_leave_a_trace() {
    let mut scene = leaf();
    scene.draws.swap(0, 1);
    scene.draws[1].depth.compare = CompareFunction::Never;
    let skipped = |scene: &Scene| render(scene, &Skips::ALL).stats.skipped(Skip::EarlyZ);
    assert!(skipped(&scene) > 50, "no leaf fragment passes, and none is coloured");
    let count = StencilState { depth_fail_op: StencilOperation::IncrementWrap, ..StencilState::default() };
    scene.draws[1].stencil = Some(count);
    assert_eq!(skipped(&scene), 0);
    let frame = render(&scene, &Skips::ALL);
    assert_eq!(frame.stencil[frame.index([12, 5])], 0, "discarded: not counted");
    assert_eq!(frame.stencil[frame.index([12, 11])], 1, "failed: counted");
    assert!(frame.same_image(&render(&scene, &Skips::NONE)));
    let masked = StencilState { write_mask: 0, ..count };
    for (stencil, expected) in
        [(None, Early::TestOnly), (Some(masked), Early::TestOnly), (Some(count), Early::Never)]
    {
        assert_eq!(Early::of(true, true, stencil.as_ref()), expected);
        assert_eq!(Early::of(false, true, stencil.as_ref()), Early::Whole);
    }
}

#[test]
fn a_decal_in_the_plane_of_its_wall_needs_a_bias() {
    for (format, reversed) in
        [(DepthFormat::F32, false), (DepthFormat::Unorm16, false), (DepthFormat::F32, true)]
    {
        let wall = [[-3.0, -2.0, 0.4], [3.0, -2.0, -0.7], [0.0, 2.5, 0.1]];
        // Halves of its edges: a smaller triangle in the same plane.
        let middle = |i: usize, j: usize| [0, 1, 2].map(|axis| (wall[i][axis] + wall[j][axis]) / 2.0);
        let decal = [middle(0, 1), middle(1, 2), middle(2, 0)];
        let mut scene = scene(&[(wall, [1.0; 4]), (decal, [1.0, 0.0, 0.0, 1.0])]);
        (scene.depth_format, scene.reversed) = (format, reversed);
        let compare = if reversed { CompareFunction::Greater } else { CompareFunction::Less };
        scene.draws.iter_mut().for_each(|draw| draw.depth.compare = compare);
        scene.clear.depth = if reversed { 0.0 } else { 1.0 };
        let red = |scene: &Scene| {
            render(scene, &Skips::ALL).color.chunks(4).filter(|pixel| pixel[..2] == [255, 0]).count()
        };
        let [_, decal] = &screen_triangles(&scene)[..] else { panic!("two triangles") };
        let whole: u32 = covered(decal.vertices.map(|[x, y, _]| [x, y]), &raster::Settings::new(scene.size))
            .iter()
            .map(raster::Span::len)
            .sum();
        assert!(red(&scene) < whole as usize, "it fights");
        let toward = if reversed { 1 } else { -1 };
        scene.draws[1].placement.bias = DepthBias { constant: 8 * toward, slope: toward as f32, clamp: 0.0 };
        assert_eq!(red(&scene), whole as usize, "{format:?} {reversed}");
        assert!(render(&scene, &Skips::ALL).same_image(&render(&scene, &Skips::NONE)));
    }
}

#[test]
fn a_bias_is_shown_beside_the_depth() {
    let mut scene = white(WALL);
    scene.depth_format = DepthFormat::Unorm16;
    scene.draws[0].placement.bias = DepthBias { constant: -100, slope: 0.0, clamp: 0.0 };
    let history = pixel_history_of(&scene, [12, 10]);
    let placed = history.entries[0].samples[0].placed.expect("it has a bias");
    assert_eq!(placed.bias, -100.0 / 65535.0);
    let details = history.entries[0].details(&scene);
    assert!(details.iter().any(|line| line.id == "pipeline-pixel-biased"), "{details:?}");
    let Outcome::Written { depth: Some(code), .. } = history.entries[0].outcome else { panic!("drawn") };
    let plain = DepthFormat::Unorm16.encode(placed.plane as f32);
    assert_eq!(code, plain - 100);
}

#[test]
fn without_clipping_what_is_too_near_or_far_is_drawn_at_the_planes() {
    // From beside the eye to beyond the far plane.
    let long = [[-20.0, -0.5, 4.9], [20.0, -0.5, 4.9], [0.0, 36.0, -60.0]];
    let mut scene = white(long);
    scene.clear.color = [0.0; 4];
    scene.draws[0].depth.compare = CompareFunction::LessEqual;
    let clipped = drawn(&scene);
    scene.draws[0].placement.unclipped = true;
    let frame = render(&scene, &Skips::ALL);
    assert!(drawn(&scene) > clipped);
    let at = |pixel| frame.depth[frame.index(pixel)];
    assert_eq!(at([12, 13]), 0.0, "in front of the near plane");
    let far = (0..16).find(|y| frame.pixel([12, *y])[3] != 0).expect("it is drawn");
    assert_eq!(at([12, far]), 1.0, "beyond the far plane");
    for skip in Skip::ALL {
        assert!(frame.same_image(&render(&scene, &Skips::ALL.with(skip, false))), "{skip:?}");
    }
    // Wholly in front of the near plane, and behind the eye.
    let near = [[-0.2, -0.2, 4.5], [0.2, -0.2, 4.5], [0.0, 0.2, 4.5]];
    let mut scene = dark();
    for (z, expected) in [(4.5_f32, true), (5.5, false)] {
        let moved = near.map(|[x, y, _]| [x, y, z]);
        scene.draws[0].geometry = Geometry::Mesh(Arc::new(Mesh::soup(moved.to_vec(), [1.0; 4])));
        for skips in [Skips::ALL, Skips::NONE] {
            scene.draws[0].placement.unclipped = true;
            assert_eq!(render(&scene, &skips).color.iter().any(|byte| *byte != 0), expected, "z = {z}");
            scene.draws[0].placement.unclipped = false;
            assert_eq!(drawn(&scene), 0, "z = {z}");
        }
    }
}

#[test]
fn the_state_stands_in_the_scene_file() {
    let json = r#"{"rasterscope":1,"size":[4,4],"draws":[{"vertices":[[0,0,0],[1,0,0],[0,1,0]],
        "depth":{"compare":"less-equal","bias":{"constant":-2,"slope":-1.5,"clamp":-0.25},"unclipped":true},
        "scissor":[1,0,2,16384],"alpha_test":{"compare":"greater","reference":0.25}}]}"#;
    let scene = Scene::from_json(json.as_bytes()).expect("it is right");
    let draw = &scene.draws[0];
    assert_eq!(draw.depth, DepthState { compare: CompareFunction::LessEqual, ..DepthState::default() });
    assert_eq!(draw.placement.bias, DepthBias { constant: -2, slope: -1.5, clamp: -0.25 });
    assert!(draw.placement.unclipped);
    assert_eq!(draw.scissor, Some(Scissor { x: 1, y: 0, width: 2, height: 16384 }));
    assert_eq!(draw.alpha_test, Some(AlphaTest { compare: CompareFunction::Greater, reference: 0.25 }));
    let written = scene.to_json();
    assert_eq!(Scene::from_json(written.as_bytes()).expect("it reads what it wrote"), scene);
    let plain = white(WALL).to_json();
    for field in ["bias", "unclipped", "scissor", "alpha_test"] {
        assert!(!plain.contains(field), "{field} is written only where it is set");
    }
}
