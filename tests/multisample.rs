//! `render` with several samples a pixel: against a naive picture of every sample, and with every skip on and off.

use crate::{
    compute::{ask, check, check_codes},
    presets::scene,
    support::{Oracle, areas},
};
use rasterscope_core::{
    interpolate::unorm,
    math::Dyadic,
    pipeline::{Frame, Skip, Skips, render, screen_triangles},
    raster::{Samples, Settings},
    scene::{Scene, preset},
};
use serde_json::json;

const SCENES: [&str; 6] = [
    "two-through-each-other",
    "z-fighting",
    "order-of-blending",
    "stencil-mask",
    "checkered-square",
    "near-plane",
];

fn with_samples(name: &str, samples: u32) -> Scene {
    Scene { samples, lab: None, ..scene(name) }
}

#[test]
fn no_skip_changes_a_bit() {
    for name in SCENES {
        for samples in [2, 4, 8] {
            let scene = with_samples(name, samples);
            let all = render(&scene, &Skips::ALL);
            assert!(all.same_image(&render(&scene, &Skips::NONE)), "{name}, {samples} samples");
            for skip in Skip::ALL {
                let without = render(&scene, &Skips::ALL.with(skip, false));
                assert!(all.same_image(&without), "{name}, {samples} samples, without {skip:?}");
            }
            assert!(!all.same_image(&render(&Scene { samples: 1, ..scene }, &Skips::ALL)), "{name}");
        }
    }
}

/// Every sample by itself: the nearest triangle of one colour each, depths as exact quotients.
fn naive(scene: &Scene, samples: Samples) -> Vec<u8> {
    let settings = Settings { fill_rule: scene.fill_rule, ..Settings::new(scene.size) };
    let clear = scene.clear.color.map(|channel| unorm(channel, 255) as u8);
    let triangles = screen_triangles(scene);
    let colors: Vec<[u8; 4]> = triangles
        .iter()
        .map(|triangle| {
            let mesh = scene.draws[triangle.draw as usize].geometry.mesh().expect("it is drawn");
            mesh.colors[0].map(|channel| unorm(channel, 255) as u8)
        })
        .collect();
    let oracles: Vec<_> = triangles
        .iter()
        .map(|triangle| Oracle::new(triangle.vertices.map(|[x, y, _]| [x, y]), &settings))
        .collect();
    let [width, height] = scene.size;
    let mut image = Vec::new();
    for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
        let mut channels = [[0_u8; Samples::MOST]; 4];
        for sample in 0..samples.count() as usize {
            let point = samples.point(pixel, sample, scene.y_axis);
            let (mut nearest, mut color) = (scene.depth_format.encode(scene.clear.depth), clear);
            for ((triangle, oracle), own) in triangles.iter().zip(&oracles).zip(&colors) {
                if !oracle.as_ref().is_some_and(|oracle| oracle.covers(point)) {
                    continue;
                }
                let [a, b, c] = areas(triangle.vertices.map(|[x, y, _]| [x, y]), point);
                let [z0, z1, z2] = triangle.vertices.map(|[_, _, z]| Dyadic::from(z));
                let (num, den) = (&a * &z0 + &b * &z1 + &c * &z2, a + b + c);
                // Depths of binary32 that are not negative are ordered as their bits.
                let code = match scene.depth_format.max_code() {
                    None => Dyadic::ratio_to_f32(&num, &den).to_bits(),
                    Some(max) => Dyadic::ratio_to_code(&num, &den, max),
                };
                if code < nearest {
                    (nearest, color) = (code, *own);
                }
            }
            for (codes, code) in channels.iter_mut().zip(color) {
                codes[sample] = code;
            }
        }
        image.extend(channels.map(|codes| samples.resolve(&codes)));
    }
    image
}

#[test]
fn every_pixel_is_the_mean_of_its_samples() {
    for name in ["two-through-each-other", "z-fighting", "near-plane"] {
        for samples in Samples::ALL {
            let scene = with_samples(name, samples.count());
            assert_eq!(render(&scene, &Skips::ALL).color, naive(&scene, samples), "{name} {samples:?}");
        }
    }
}

#[test]
fn a_scene_with_samples_is_answered_and_others_are_refused() {
    let text = preset("two-through-each-other").expect("a preset").json;
    let of = |samples: &str| {
        let scene =
            text.replace("\"rasterscope\": 1,", &format!("\"rasterscope\": 1, \"samples\": {samples},"));
        ask(format!(r#"{{"op":"render","scene":{}}}"#, scene.replace(['\n', '\r'], " ")).as_bytes())
    };
    let one = of("1");
    for samples in ["2", "4", "8"] {
        let answer = of(samples);
        assert!(answer.get("error").is_none() && answer["color"] != one["color"], "{samples}");
    }
    for samples in ["0", "3", "16"] {
        assert_eq!(of(samples)["error"]["code"], "bad-scene");
    }
}

#[test]
fn the_image_is_cleared_between_frames() {
    // The second image is drawn over the target of the first.
    let mut pipeline = rasterscope_core::pipeline::Pipeline::default();
    let images: Vec<Frame> = SCENES
        .iter()
        .chain(&SCENES)
        .map(|name| pipeline.update(&with_samples(name, 4), &Skips::ALL).frame.clone())
        .collect();
    for (name, image) in SCENES.iter().chain(&SCENES).zip(&images) {
        assert!(image.same_image(&render(&with_samples(name, 4), &Skips::ALL)), "{name}");
    }
}

#[test]
fn coverage_answers_the_masks_of_samples() {
    let triangle = r#""size":[3,2],"vertices":[[0.25,0.25],[2,0.5],[0.5,1.75]]"#;
    let of = |more: &str| ask(format!(r#"{{"op":"coverage",{triangle}{more}}}"#).as_bytes());
    assert_eq!(of(r#","samples":1"#), json!({"rows": [[0, 0, 2], [1, 0, 1]]}));
    assert_eq!(of(""), json!({"rows": [[0, 0, 2], [1, 0, 1]]}));
    let masks = of(r#","samples":4"#)["masks"].clone();
    let masks: Vec<[u32; 3]> = serde_json::from_value(masks).expect("rows of three numbers");
    let edges = Oracle::new([[0.25, 0.25], [2.0, 0.5], [0.5, 1.75]], &Settings::new([3, 2]));
    let edges = edges.expect("it has an area");
    for pixel in (0..2).flat_map(|y| (0..3).map(move |x| [x, y])) {
        let inside =
            |sample: &u32| edges.covers(Samples::Four.point(pixel, *sample as usize, Default::default()));
        let expected = (0..4).filter(inside).fold(0, |mask, sample| mask | 1 << sample);
        let found = masks.iter().find(|[x, y, _]| [*x, *y] == pixel).map_or(0, |[_, _, mask]| *mask);
        assert_eq!(found, expected, "{pixel:?}");
    }
    check(&[(
        r#"{"op":"coverage","size":[2,2],"samples":8,"vertices":[[0,0],[1,1],[2,2]]}"#,
        r#"{"rows":[],"masks":[]}"#,
    )]);
    let bad = |samples: &str| format!(r#"{{"op":"coverage",{triangle},"samples":{samples}}}"#);
    for samples in ["0", "3", "16", "2.5", "\"4\"", "null"] {
        check_codes(&[(&bad(samples), "bad-field")]);
    }
    check_codes(&[(&bad("4,\"arithmetic\":\"f32\""), "unsupported")]);
}

#[test]
fn interpolate_reads_as_the_interface_says() {
    let of = |more: &str| ask(format!(r#"{{"op":"interpolate","attribute":[0,6,12],{more}}}"#).as_bytes());
    let deep = r#""vertices":[[0,0,1],[4,0,2],[0,4,1]]"#;
    let turned = r#""vertices":[[0,4,1],[4,0,2],[0,0,1]]"#;
    // Perspective unless said otherwise; either winding; on an edge and at a vertex, too.
    assert_eq!(of(&format!(r#"{deep},"at":[2,0]"#)), json!({"value": 2.0}));
    assert_eq!(of(&format!(r#"{deep},"at":[2,0],"mode":"perspective""#)), json!({"value": 2.0}));
    assert_eq!(of(&format!(r#"{turned},"at":[2,0]"#)), json!({"value": 10.0}));
    assert_eq!(of(&format!(r#"{deep},"at":[0,4]"#)), json!({"value": 12.0}));
    // Affine does not read w.
    let nowhere = r#""vertices":[[0,0,0],[4,0,0],[0,4,-1]]"#;
    assert_eq!(of(&format!(r#"{nowhere},"at":[1,2],"mode":"affine""#)), json!({"value": 7.5}));
    assert_eq!(of(&format!(r#"{nowhere},"at":[1,2]"#))["error"]["code"], "zero-w");
    // Every arithmetic; fixed point snaps the vertices to 1/256.
    for arithmetic in ["exact", "f32", "f64", "fixed-8"] {
        let more = format!(r#"{deep},"at":[2,0],"arithmetic":"{arithmetic}""#);
        assert_eq!(of(&more), json!({"value": 2.0}), "{arithmetic}");
    }
    let near = r#""vertices":[[0.001,0,1],[4,0,1],[0,4,1]],"at":[0,2]"#;
    assert_eq!(of(near)["error"]["code"], "outside-triangle");
    assert_eq!(of(&format!(r#"{near},"arithmetic":"fixed-8""#)), json!({"value": 6.0}));
    assert_eq!(
        of(&format!(r#"{deep},"at":[2,0],"arithmetic":"f16""#))["error"]["code"],
        "unknown-arithmetic"
    );
    assert_eq!(of(&format!(r#"{deep},"at":[1e39,0]"#))["error"]["code"], "not-finite");
    assert_eq!(of(deep)["error"]["code"], "missing-field");
}
