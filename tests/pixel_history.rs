//! Why a pixel looks as it does: the reasons of known pixels, with their numbers.

use crate::presets::scene;
use rasterscope_core::{
    clip::polygon::Plane,
    labs,
    message::{Message, Value},
    pipeline::{Outcome, Skips, pixel_history_of, render},
    replay::Budget,
    scene::{Draw, Geometry, Lab, Mesh, PRESETS, Scene},
    transform::Projection,
};
use std::sync::Arc;

fn argument<'m>(message: &'m Message, name: &str) -> &'m Value {
    &message.args.iter().find(|(key, _)| *key == name).unwrap_or_else(|| panic!("{message:?}: no {name}")).1
}

#[test]
fn a_layer_below_another_was_blended_over() {
    let history = pixel_history_of(&scene("order-of-blending"), [9, 11]);
    let written: Vec<_> = history.entries.iter().filter(|entry| entry.is_fragment()).collect();
    assert_eq!(
        written.iter().map(|entry| entry.reason().id).collect::<Vec<_>>(),
        ["pipeline-pixel-blended-over", "pipeline-pixel-written"]
    );
    let details = written[1].details(&scene("order-of-blending"));
    let blended = details.last().expect("colours");
    assert_eq!(blended.id, "pipeline-pixel-blended");
    assert_eq!(argument(blended, "before"), &Value::text("(39, 62, 83, 255)"), "half of A over black");
}

#[test]
fn a_failed_stencil_test_has_its_values_and_masks() {
    let scene = scene("stencil-mask");
    let history = pixel_history_of(&scene, [3, 11]);
    let failed = history.entries.iter().find(|entry| entry.is_fragment()).expect("B comes there");
    assert_eq!(failed.reason().id, "pipeline-pixel-stencil");
    let details = failed.details(&scene);
    assert_eq!(argument(&details[0], "reference"), &Value::Int(1));
    assert_eq!(argument(&details[0], "stored"), &Value::Int(0));
    assert_eq!(argument(&details[0], "compare"), &Value::text("≠"));
    assert_eq!(details[1].id, "pipeline-pixel-stencil-stored");
}

#[test]
fn a_depth_that_is_not_written_says_so() {
    let mut scene = scene("two-through-each-other");
    scene.draws.iter_mut().for_each(|draw| draw.depth.write = false);
    let history = pixel_history_of(&scene, [13, 11]);
    let first = history.entries.iter().find(|entry| entry.is_fragment()).expect("A.1 is drawn");
    assert!(first.details(&scene).iter().any(|line| line.id == "pipeline-pixel-depth-unwritten"));
}

/// At some pixels of every small preset: the history ends with what the image holds.
#[test]
fn histories_end_with_the_image() {
    for preset in PRESETS {
        let scene = scene(preset.name);
        if scene.draws.is_empty() || scene.size[0] > 40 {
            continue;
        }
        let frame = render(&scene, &Skips::ALL);
        for (x, y) in [(9, 11), (13, 11), (3, 5), (20, 14), (17, 6)] {
            let pixel = [x % scene.size[0], y % scene.size[1]];
            let history = pixel_history_of(&scene, pixel);
            let at = frame.index(pixel);
            assert_eq!(
                (history.color, history.stencil),
                (frame.pixel(pixel), frame.stencil[at]),
                "{}",
                preset.name
            );
        }
    }
}

/// Seen from straight above, 3 wide and 2 high: beyond its corner lie triangles that no plane alone excludes.
fn beyond_the_corner(corners: [[f32; 2]; 3]) -> Scene {
    let positions = corners.map(|[x, y]| [x, y, 0.0]).to_vec();
    let mut scene = Scene::empty([24, 16]);
    scene.camera.projection = Projection::Orthographic { height: 2.0 };
    scene.draws = vec![Draw::new("A", Geometry::Mesh(Arc::new(Mesh::soup(positions, [1.0; 4]))))];
    scene
}

#[test]
fn what_several_planes_remove_together_names_the_last_and_the_others() {
    for (mirror, last, others) in [
        ([1.0, 1.0], Plane::Top, [Plane::Right]),
        ([-1.0, 1.0], Plane::Top, [Plane::Left]),
        ([1.0, -1.0], Plane::Bottom, [Plane::Right]),
        ([-1.0, -1.0], Plane::Bottom, [Plane::Left]),
    ] {
        let [x, y] = mirror;
        let corners = [[1.2, 1.4], [1.9, 0.7], [1.9, 1.4]].map(|[a, b]: [f32; 2]| [a * x, b * y]);
        let [a, b, c] = corners;
        let mut scene = beyond_the_corner(if x * y > 0.0 { [a, b, c] } else { [a, c, b] });
        scene.draws[0].cull = rasterscope_core::cull::CullMode::None;
        let history = pixel_history_of(&scene, [0, 0]);
        let Outcome::ClippedAway(removed) = history.entries[0].outcome else {
            panic!("{:?}", history.entries[0].outcome)
        };
        assert_eq!((removed.last, removed.others.iter().collect::<Vec<_>>()), (Some(last), others.to_vec()));
        assert_eq!(history.entries[0].details(&scene).len(), 1);
    }
}

#[test]
fn one_sentence_says_why_a_pixel_is_black() {
    let at = |name: &str, pixel| pixel_history_of(&scene(name), pixel).sentence().id;
    assert_eq!(at("two-through-each-other", [13, 11]), "pipeline-pixel-drawn");
    assert_eq!(at("two-through-each-other", [0, 0]), "pipeline-pixel-why-nothing");
    assert_eq!(at("stencil-mask", [3, 11]), "pipeline-pixel-why-stencil");
    assert_eq!(at("depth-unclipped", [5, 17]), "pipeline-pixel-why-cut-off");
    let mut scene = scene("two-through-each-other");
    scene.clear.depth = 0.0;
    assert_eq!(pixel_history_of(&scene, [13, 11]).sentence().id, "pipeline-pixel-why-depth");
    scene.draws.truncate(1);
    scene.draws[0].cull = rasterscope_core::cull::CullMode::Front;
    assert_eq!(pixel_history_of(&scene, [13, 11]).sentence().id, "pipeline-pixel-why-front-facing");
    let mut black = beyond_the_corner([[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]]);
    if let Geometry::Mesh(mesh) = &mut black.draws[0].geometry {
        Arc::make_mut(mesh).colors = vec![[0.0, 0.0, 0.0, 1.0]; 3];
    }
    assert_eq!(pixel_history_of(&black, [12, 10]).sentence().id, "pipeline-pixel-why-own-black");
}

/// Every row of every history leads to a lab that opens on the scene and runs.
#[test]
fn every_entry_has_a_lab_that_runs() {
    let mut seen = std::collections::BTreeSet::new();
    for preset in PRESETS {
        let scene = scene(preset.name);
        if scene.draws.is_empty() || scene.size[0] > 40 || scene.samples > 1 {
            continue;
        }
        for pixel in [[13, 11], [3, 5], [20, 14]] {
            let pixel = [0, 1].map(|axis| pixel[axis] % scene.size[axis]);
            for entry in &pixel_history_of(&scene, pixel).entries {
                let mut scene = scene.clone();
                let input = labs::lab_of(entry, &scene);
                seen.insert(input.name());
                scene.lab = Some(Lab::new(input));
                assert_eq!(scene.validate(), Ok(()), "{}: {entry:?}", preset.name);
                let run = labs::play(&scene, Budget::default());
                assert!(run.is_ok_and(|run| !run.is_empty()), "{}: {entry:?}", preset.name);
            }
        }
    }
    assert!(seen.len() >= 4, "{seen:?}");
}

#[test]
fn a_blended_fragment_says_its_numbers() {
    let scene = scene("order-of-blending");
    let history = pixel_history_of(&scene, [9, 11]);
    let last = history.entries.iter().rfind(|entry| entry.is_fragment()).expect("two layers");
    let details = last.details(&scene);
    let lines: Vec<_> = details.iter().filter(|line| line.id == "pipeline-pixel-blend-add").collect();
    assert_eq!(lines.len(), 4, "{details:?}");
    assert_eq!(argument(lines[0], "source-factor"), &Value::F64(0.5), "alpha of the source");
    assert_eq!(argument(lines[0], "stored"), &Value::F64(39.0 / 255.0));
}
