//! What is lit in a table and named on the timeline belongs to the step that was just taken.

use crate::presets::scene;
use rasterscope_core::{
    labs,
    message::Value,
    replay::{Budget, Playback},
    scene::PRESETS,
};

/// Calls `look` after each step of the presets whose names begin with `family`.
fn each_step(family: &str, mut look: impl FnMut(&dyn Playback)) {
    let presets: Vec<_> = PRESETS.iter().filter(|preset| preset.name.starts_with(family)).collect();
    assert!(!presets.is_empty(), "{family}");
    for preset in presets {
        let mut run = labs::play(&scene(preset.name), Budget::default()).expect("it runs");
        for step in 1..=run.len() {
            run.seek(step);
            look(run.as_ref());
        }
    }
}

/// The last name on the timeline that is not behind the cursor.
fn current_name(run: &dyn Playback) -> Option<&'static str> {
    run.captions().iter().rfind(|(step, _)| *step <= run.cursor()).map(|(_, name)| name.id)
}

#[test]
fn the_named_back_face_test_is_the_one_being_made() {
    let mut looked_at = 0;
    each_step("facing-", |run| {
        let sentence = run.sentence();
        let of_test = ["back-face-value", "back-face-no-image", "back-face-no-eye", "back-face-answer"];
        if of_test.iter().any(|prefix| sentence.id.starts_with(prefix)) {
            let Value::Word(test) = sentence.args[0].1 else { panic!("{sentence:?}") };
            let name = test.replace("-test-", "-marker-");
            assert_eq!(current_name(run), Some(name.as_str()), "step {}", run.cursor());
            looked_at += 1;
        }
    });
    assert!(looked_at > 0);
}

#[test]
fn the_named_course_is_that_of_the_edge_in_hand() {
    let mut looked_at = 0;
    each_step("convex-", |run| {
        let expected = match run.sentence().id {
            "cyrus-beck-measure-enters" | "cyrus-beck-enter-later" | "cyrus-beck-enter-earlier" => "enter",
            "cyrus-beck-measure-leaves" | "cyrus-beck-leave-later" | "cyrus-beck-leave-earlier" => "leave",
            _ => return,
        };
        let name = current_name(run).and_then(|name| name.strip_prefix("cyrus-beck-marker-"));
        assert_eq!(name, Some(expected), "step {}", run.cursor());
        looked_at += 1;
    });
    assert!(looked_at > 0);
}

/// Until its tests, what the stencil will hold after a fragment is not known.
#[test]
fn a_fragment_that_arrives_at_the_stencil_has_no_after() {
    let mut looked_at = 0;
    each_step("stencil-outline-scale", |run| {
        let expected = match run.sentence().id {
            "stencil-fragment" => "row-before",
            id if id.starts_with("stencil-fail") || id.starts_with("stencil-pass") => "row-after",
            _ => return,
        };
        let table = run.tables().swap_remove(0);
        let lit: Vec<_> = table.rows.iter().filter(|row| row.active).map(|row| &*row.name).collect();
        assert_eq!(lit, [expected], "step {}", run.cursor());
        let after = table.rows.iter().find(|row| row.name == "row-after").expect("it is there");
        assert_eq!(after.cells.contains(&Value::None), expected == "row-before", "step {}", run.cursor());
        looked_at += 1;
    });
    assert!(looked_at > 0);
}
