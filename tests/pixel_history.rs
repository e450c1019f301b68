//! Why a pixel looks as it does: the reasons of known pixels, with their numbers.

use crate::presets::scene;
use rasterscope_core::{
    message::{Message, Value},
    pipeline::{Skips, pixel_history_of, render},
    scene::PRESETS,
};

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
