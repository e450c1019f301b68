//! Why a pixel looks as it does: the reasons of known pixels, with their numbers.

use crate::presets::scene;
use rasterscope_core::{
    clip::polygon::Plane,
    labs,
    message::{Message, Value},
    pipeline::{Later, Outcome, Pipeline, Skips, pixel_history, pixel_history_of},
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

/// At the pixels of every small preset, with any number of samples: the history ends with what the image holds.
#[test]
fn histories_end_with_the_image() {
    let mut partly = 0;
    for preset in PRESETS {
        let mut scene = scene(preset.name);
        if scene.draws.is_empty() || scene.size[0] > 40 {
            continue;
        }
        for samples in [1, 2, 4, 8] {
            scene.samples = samples;
            let mut pipeline = Pipeline::default();
            pipeline.update(&scene, &Skips::ALL);
            let frame = &pipeline.outputs().frame;
            for pixel in (0..scene.size[1]).flat_map(|y| (0..scene.size[0]).map(move |x| [x, y])) {
                let history = pixel_history(&scene, pipeline.outputs(), pixel);
                let at = frame.index(pixel);
                let depth = frame.depth_codes.as_ref().map_or(frame.depth[at].to_bits(), |codes| codes[at]);
                assert_eq!(
                    (history.color, history.depth, history.stencil),
                    (frame.pixel(pixel), depth, frame.stencil[at]),
                    "{} at {pixel:?} with {samples} samples",
                    preset.name
                );
                partly += usize::from(history.sentence().id.starts_with("pipeline-pixel-why-mean"));
            }
        }
    }
    assert!(partly > 100, "{partly} pixels lie on outlines");
}

/// An edge through a pixel: each of the covered samples has its own test, and who is seen in how many is said.
#[test]
fn with_several_samples_each_one_has_its_own_tests() {
    let mut scene = scene("two-through-each-other");
    scene.samples = 4;
    let size = scene.size;
    let pixels = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| [x, y]));
    let histories: Vec<_> = pixels.map(|pixel| pixel_history_of(&scene, pixel)).collect();
    let both = histories.iter().find(|history| {
        let seen = history.sentence();
        let whole = history.entries.iter().any(|entry| entry.name == "A.1" && entry.samples.len() == 4);
        seen.id == "pipeline-pixel-why-mean"
            && argument(&seen, "parts") == &Value::text("2 × A.1, 2 × B")
            && whole
    });
    let both = both.expect("they cut each other in the middle of some pixel");
    let first = both.entries.iter().find(|entry| entry.is_fragment()).expect("A.1 is drawn");
    let details = first.details(&scene);
    let ids: Vec<_> = details.iter().map(|line| line.id).filter(|id| id.contains("sample")).collect();
    assert_eq!(ids, ["pipeline-pixel-sample"; 4]);
    let reasons: Vec<_> = first.samples.iter().map(|sample| sample.outcome).collect();
    let overwritten =
        |outcome: &&Outcome| matches!(outcome, Outcome::Written { later: Later::Overwritten, .. });
    assert_eq!(reasons.iter().filter(overwritten).count(), 2, "{reasons:?}");
    let partly = histories.iter().find(|history| history.sentence().id == "pipeline-pixel-why-mean-clear");
    assert!(partly.is_some(), "an outline goes through pixels");
}

/// A triangle around a centre that no sample of the pixel shares.
#[test]
fn a_triangle_between_the_samples_covers_none() {
    let mut scene = beyond_the_corner([[0.0; 2]; 3]);
    scene.draws[0].cull = rasterscope_core::cull::CullMode::None;
    let size = scene.size.map(|n| n as f32);
    let centre = [size[0] / 2.0 + 0.5, size[1] / 2.0 - 0.5];
    let half = 0.1;
    let [x, y] = centre;
    let around = [[x - half, y + half], [x + half, y + half], [x, y - half]];
    let height = 2.0 / size[1];
    let place = around.map(|[x, y]| [(x - size[0] / 2.0) * height, (size[1] / 2.0 - y) * height]);
    let positions = place.map(|[x, y]| [x, y, 0.0]).to_vec();
    scene.draws[0].geometry = Geometry::Mesh(Arc::new(Mesh::soup(positions, [1.0; 4])));
    let pixel = centre.map(|n| n as u32);
    assert_eq!(pixel_history_of(&scene, pixel).sentence().id, "pipeline-pixel-drawn");
    scene.samples = 4;
    let history = pixel_history_of(&scene, pixel);
    assert_eq!(history.entries[0].outcome, Outcome::NoSample);
    assert_eq!(history.sentence().id, "pipeline-pixel-why-no-sample");
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
        if scene.draws.is_empty() || scene.size[0] > 40 {
            continue;
        }
        for (samples, pixel) in [(1, [13, 11]), (1, [3, 5]), (1, [20, 14]), (4, [13, 11]), (4, [3, 5])] {
            let pixel = [0, 1].map(|axis| pixel[axis] % scene.size[axis]);
            let scene = Scene { samples, ..scene.clone() };
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
