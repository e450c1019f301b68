//! What lies on an image, held against the fragments counted by hand, triangle by triangle and pixel by
//! pixel.

use rasterscope_core::{
    explain::Tone,
    message::Value,
    pipeline::{
        Changed, Frame, Layer, Outcome, Overlay, Pipeline, PixelCounts, PixelEntry, Reason, Skips, Wires,
        pixel_history,
    },
    raster::{Algorithm, FillRule},
    scene::{Draw, Geometry, Mesh, PRESETS, Scene},
    stage::Stage,
    transform::{Camera, Projection},
};
use std::sync::Arc;

use crate::presets::scene;

/// Small presets of the whole pipeline: culling, clipping, stencil, blending, several samples.
fn small() -> impl Iterator<Item = (&'static str, Scene)> {
    PRESETS.iter().filter_map(|preset| {
        let scene = scene(preset.name);
        let pixels = scene.size.iter().product::<u32>();
        let triangles: usize =
            scene.draws.iter().filter_map(|draw| draw.geometry.mesh()).map(|mesh| mesh.triangles.len()).sum();
        (triangles > 0 && triangles <= 40 && pixels <= 2_000).then_some((preset.name, scene))
    })
}

/// A scene of this text.
fn read(text: &str) -> Scene {
    Scene::from_json(text.as_bytes()).expect("it is one")
}

fn drawn(scene: &Scene) -> Pipeline {
    let mut pipeline = Pipeline::new(Algorithm::Scanline);
    pipeline.update(scene, &Skips::ALL);
    pipeline
}

#[test]
fn counts_are_those_of_every_pixels_history() {
    let mut seen = 0;
    for (name, scene) in small().filter(|(_, scene)| scene.samples == 1) {
        let pipeline = drawn(&scene);
        let counts = PixelCounts::of(&scene, pipeline.outputs());
        for at in 0..counts.generated.len() {
            let [width, _] = scene.size;
            let pixel = [at as u32 % width, at as u32 / width];
            let history = pixel_history(&scene, pipeline.outputs(), pixel);
            let fragments = history.entries.iter().filter(|entry| entry.is_fragment()).count();
            let written: Vec<_> = history
                .entries
                .iter()
                .filter(|entry| matches!(entry.outcome, Outcome::Written { .. }))
                .collect();
            let told = [fragments as u32, written.len() as u32];
            assert_eq!([counts.generated[at], counts.written[at]], told, "{name} {pixel:?}");
            let last = counts.last_written(at).map(|piece| (piece.draw as usize, Some(piece.triangle)));
            assert_eq!(last, written.last().map(|entry| (entry.draw, entry.triangle)), "{name} {pixel:?}");
        }
        seen += 1;
    }
    assert!(seen >= 10, "{seen} presets");
}

#[test]
fn counts_are_those_of_the_statistics_with_any_skips() {
    for (name, scene) in small() {
        let counts = [Skips::ALL, Skips::NONE].map(|skips| {
            let mut pipeline = Pipeline::new(Algorithm::Scanline);
            pipeline.update(&scene, &skips);
            PixelCounts::of(&scene, pipeline.outputs())
        });
        assert_eq!(counts[0], counts[1], "{name}");
        let stats = drawn(&scene).outputs().frame.stats;
        let sum = |counts: &[u32]| counts.iter().map(|n| u64::from(*n)).sum::<u64>();
        let of = |stage| stats.stage(stage).went;
        let discarded = stats.stage(Stage::Fragments).dropped(Reason::Discarded);
        let expected = [of(Stage::Fragments) + discarded, of(Stage::Blend), of(Stage::Image)];
        let once = counts[0].written.iter().filter(|n| **n > 0).count() as u64;
        assert_eq!([sum(&counts[0].generated), sum(&counts[0].written), once], expected, "{name}");
    }
}

/// Two triangles that overlap in three pixels of a row, by hand.
#[test]
fn two_layers_are_told_from_one() {
    let scene = read(
        r#"{"rasterscope": 1, "size": [4, 2],
            "camera": {"eye": [0, 0, 5], "projection": {"kind": "orthographic", "height": 2}},
            "draws": [{"name": "near", "vertices": [[-2, -1, 1], [2, -1, 1], [-2, 3, 1]], "color": [1, 0, 0, 1]},
                      {"name": "far", "vertices": [[-2, -1, 0], [6, -1, 0], [-2, 7, 0]], "color": [0, 1, 0, 1]}]}"#,
    );
    let pipeline = drawn(&scene);
    let counts = PixelCounts::of(&scene, pipeline.outputs());
    // The near one's slanted edge passes the centres of (2, 0) and (3, 1), which it does not own.
    assert_eq!(counts.generated, [2, 2, 1, 1, 2, 2, 2, 1]);
    assert_eq!(counts.written, [1; 8]);
    let draw = |at| counts.last_written(at).map(|piece| piece.draw);
    assert_eq!([0, 1, 2, 3].map(draw), [Some(0), Some(0), Some(1), Some(1)]);
    let drawn_last = |at| counts.last_generated(at).map(|piece| piece.draw);
    assert_eq!([0, 3].map(drawn_last), [Some(1), Some(1)]);
    assert_eq!(counts.last_written(8), None, "there is no such pixel");

    let Layer::Field(Overlay::Generated, field) =
        Layer::of(Overlay::Generated, &scene, pipeline.outputs(), Some(&counts), None)
    else {
        panic!("it is a field")
    };
    assert_eq!((field.tone, field.ends()), (Tone::Heat, [Value::Int(1), Value::Int(2)]));
    assert_eq!((field.share(0), field.value(2)), (Some(1.0), Value::Int(1)));
}

/// Against the codes in the histories of pixels.
#[test]
fn equal_codes_are_where_a_fragment_meets_its_own_code() {
    let mut most = 0;
    for (name, scene) in small() {
        let pipeline = drawn(&scene);
        let counts = PixelCounts::of(&scene, pipeline.outputs());
        for (at, equal) in counts.equal.iter().enumerate() {
            let pixel = [at as u32 % scene.size[0], at as u32 / scene.size[0]];
            let history = pixel_history(&scene, pipeline.outputs(), pixel);
            let met = |entry: &&PixelEntry| match entry.outcome {
                Outcome::Depth { new, stored, .. } => new == stored,
                Outcome::Written { depth: Some(new), stored, .. } => new == stored,
                _ => false,
            };
            if scene.samples == 1 {
                assert_eq!(*equal as usize, history.entries.iter().filter(met).count(), "{name} {pixel:?}");
                most = most.max(*equal);
            }
        }
    }
    assert!(most > 0, "some preset fights");
    let scene = read(include_str!("../assets/scenes/z-fighting.json"));
    let pipeline = drawn(&scene);
    let counts = PixelCounts::of(&scene, pipeline.outputs());
    // Where B's code is A's, B is not seen although it is nearer.
    let both = |at: &usize| counts.generated[*at] == 2;
    let stays = |at: &usize| counts.last_written(*at).is_some_and(|piece| piece.draw == 0);
    let pixels = 0..counts.equal.len();
    let hidden: Vec<_> = pixels.clone().filter(both).filter(stays).collect();
    let equal: Vec<_> = pixels.filter(|at| counts.equal[*at] > 0).collect();
    assert!(hidden.len() > 10 && hidden == equal, "{hidden:?} {equal:?}");
}

#[test]
fn depth_and_stencil_are_those_of_the_image() {
    for (name, scene) in small() {
        let pipeline = drawn(&scene);
        let frame = &pipeline.outputs().frame;
        let field = |overlay: Overlay| overlay.field(&scene, frame, None);
        let [depth, stencil] = [Overlay::Depth, Overlay::Stencil].map(|o| field(o).expect("a field"));
        for at in 0..frame.stencil.len() {
            assert_eq!(depth.value(at), Value::F32(frame.depth[at]), "{name}");
            assert_eq!(stencil.value(at), Value::from(u32::from(frame.stencil[at])), "{name}");
            assert_eq!(stencil.share(at).is_none(), frame.stencil[at] == scene.clear.stencil, "{name}");
        }
        let loudest = (0..frame.depth.len()).filter(|at| depth.share(*at) == Some(1.0));
        let nearest = loudest.map(|at| frame.depth[at]).collect::<Vec<_>>();
        let best = if scene.reversed { f32::max } else { f32::min };
        let seen = (0..frame.depth.len()).filter(|at| depth.share(*at).is_some()).map(|at| frame.depth[at]);
        assert!(nearest.iter().all(|z| Some(*z) == seen.clone().reduce(best)), "{name}");
        assert_eq!(field(Overlay::Generated), None, "nobody counted");
    }
}

#[test]
fn what_changed_is_found_pixel_by_pixel() {
    for (name, scene) in small() {
        let before = drawn(&scene);
        let mut edited = scene.clone();
        edited.fill_rule = FillRule::Inclusive;
        let after = drawn(&edited);
        let [old, new] = [&before, &after].map(|pipeline| &pipeline.outputs().frame);
        let changed = Changed::between(old, new).expect("one size");
        let differs = |at: usize| {
            old.color[4 * at..4 * at + 4] != new.color[4 * at..4 * at + 4]
                || old.depth[at].to_bits() != new.depth[at].to_bits()
                || old.stencil[at] != new.stencil[at]
        };
        let expected: Vec<_> = (0..old.stencil.len()).filter(|at| differs(*at)).collect();
        let found: Vec<_> = changed.pixels.iter().map(|pixel| new.index(*pixel)).collect();
        assert_eq!(found, expected, "{name}");
        assert_eq!(changed.pixels.is_empty(), old.same_image(new), "{name}");
        // No skip changes a pixel.
        let layer =
            Layer::of(Overlay::Changed, &scene, before.outputs(), None, Some(&(scene.clone(), Skips::NONE)));
        let Layer::Changed(Some(none)) = layer else { panic!("{name}: it was compared") };
        assert_eq!(*none, Changed { size: scene.size, ..Changed::default() }, "{name}");
    }
    let size = |size| Frame { size, ..Frame::default() };
    assert_eq!(Changed::between(&size([0, 0]), &size([0, 1])), None);
}

#[test]
fn wires_have_each_edge_once() {
    let scene = read(
        r#"{"rasterscope": 1, "size": [8, 8],
            "draws": [{"vertices": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], "indices": [[0, 1, 2], [0, 2, 3]],
                       "color": [1, 1, 1, 1]}]}"#,
    );
    let Wires::Lines(lines) = Wires::of(drawn(&scene).outputs()) else { panic!("five are few") };
    assert_eq!(lines.len(), 5, "four sides and one diagonal");
}

#[test]
fn very_many_wires_are_pixels_on_the_triangles() {
    const SIDE: u32 = 60;
    let corner = |i: u32| [i % (SIDE + 1), i / (SIDE + 1)].map(|c| c as f32 / SIDE as f32 - 0.5);
    let mesh = Mesh {
        positions: (0..(SIDE + 1).pow(2)).map(corner).map(|[x, y]| [x, y, 0.0]).collect(),
        triangles: (0..SIDE * SIDE)
            .map(|square| square / SIDE * (SIDE + 1) + square % SIDE)
            .flat_map(|i| [[i, i + 1, i + SIDE + 2], [i, i + SIDE + 2, i + SIDE + 1]])
            .collect(),
        colors: vec![[1.0; 4]; (SIDE as usize + 1).pow(2)],
        ..Mesh::default()
    };
    let scene = Scene {
        camera: Camera { projection: Projection::Orthographic { height: 1.0 }, ..Camera::default() },
        draws: vec![Draw::new("plane", Geometry::Mesh(Arc::new(mesh)))],
        ..Scene::empty([300, 300])
    };
    let pipeline = drawn(&scene);
    let Wires::Pixels(pixels) = Wires::of(pipeline.outputs()) else { panic!("they are many") };
    let wired = pixels.iter().filter(|wire| **wire).count();
    let drawn = PixelCounts::of(&scene, pipeline.outputs()).written.iter().filter(|n| **n > 0).count();
    assert_eq!(drawn, 90_000);
    assert!((30_000..60_000).contains(&wired), "squares of 5 pixels, each with a diagonal: {wired}");
}

#[test]
fn names_lead_back_to_overlays() {
    for overlay in Overlay::ALL {
        assert_eq!(Overlay::from_name(overlay.name()), Some(overlay));
    }
    assert_eq!(Overlay::from_name("stickers"), None);
}
