//! What takes long is done beside the window.

use super::*;
use crate::{face::Command, opening::When, shell::notice::Notice};
use std::fmt::Write as _;

/// A bumpy square of some 25 000 triangles as an OBJ model.
fn model() -> Vec<u8> {
    const SIDE: usize = 113;
    let mut text = String::new();
    for i in 0..SIDE * SIDE {
        let (x, z) = (i % SIDE, i / SIDE);
        writeln!(text, "v {x} {} {z}", (x * 7 + z * 3) % 5).expect("a text takes everything");
    }
    for i in (0..SIDE * (SIDE - 1)).filter(|i| i % SIDE + 1 < SIDE) {
        let [a, b, c, d] = [i + 1, i + 2, i + SIDE + 2, i + SIDE + 1];
        writeln!(text, "f {a} {b} {c}\nf {a} {c} {d}").expect("a text takes everything");
    }
    text.into_bytes()
}

/// A window whose work waits until the test has it done.
fn lazy() -> Window {
    let mut window = window(1280.0, 720.0);
    let platform = &mut window.state_mut().platform;
    platform.files.insert("big.obj".into(), model());
    platform.lazy = true;
    window
}

fn open(window: &mut Window, path: &str) {
    let ctx = window.ctx.clone();
    let Desk { app, platform } = window.state_mut();
    app.as_mut().expect("made").open(&ctx, path, When::Later, platform);
}

fn work(window: &mut Window) {
    window.state_mut().platform.work();
    window.run_steps(2);
}

fn image(window: &Window) -> Vec<u8> {
    window.state().app().overview.outputs().frame.color.clone()
}

#[test]
fn a_large_model_is_opened_and_drawn_while_the_window_answers() {
    let mut window = lazy();
    let (title, runs) = (window.state().app().subtitle(), window.state().app().run.runs());
    open(&mut window, "big.obj");
    window.run_steps(20);
    window.get_by_label("Opening big.obj");
    assert_eq!(window.state().app().subtitle(), title, "what was open is still there");
    window.key_press(egui::Key::ArrowLeft);
    window.run_steps(2);
    assert_eq!(cursor(&window), len(&window) - 1, "and can be stepped");

    work(&mut window);
    assert_eq!(window.state().app().subtitle(), "big.obj");
    window.run_steps(20);
    window.get_by_label("Computing the image");
    assert!(window.state().app().run.shown().is_none(), "its steps are not there yet");
    work(&mut window);
    let app = window.state().app();
    assert_eq!(app.overview.outputs().draws[0].mesh().triangles.len(), 2 * 112 * 112);
    assert!(app.run.runs() > runs && app.run.shown().is_some() || app.problem().is_some());
    assert!(window.query_by_label("Computing the image").is_none());
}

/// A file may be read before the first frame: then nothing was counted yet that the ribbon could show.
#[test]
fn a_large_model_named_at_the_start_is_opened_in_a_window_of_any_size() {
    for [width, height] in [[1280.0, 720.0], [1024.0, 768.0], [2560.0, 1440.0]] {
        let files = [("big.obj".to_owned(), model())].into();
        let memory = Memory { files, lazy: true, named: Some("big.obj"), ..Memory::default() };
        let mut window = window_on(width, height, memory);
        work(&mut window);
        assert_eq!(window.state().app().subtitle(), "big.obj");
        assert_eq!(window.state().app().overview.outputs().draws.len(), 1);
    }
}

#[test]
fn edits_of_a_large_scene_show_the_old_image_until_the_new_one_is_there() {
    let mut window = lazy();
    open(&mut window, "big.obj");
    for _ in 0..2 {
        work(&mut window);
    }
    let before = image(&window);
    for fovy_degrees in [40.0, 20.0] {
        let scene = &mut window.state_mut().app_mut().document.scene;
        scene.camera.projection = rasterscope_core::transform::Projection::Perspective { fovy_degrees };
        window.run_steps(2);
    }
    assert_eq!(window.state().platform.waiting.len(), 1, "one at a time");
    work(&mut window);
    assert_eq!(window.state().platform.waiting.len(), 1, "the newest follows, and nothing between");
    work(&mut window);
    assert!(window.state().platform.waiting.is_empty());
    assert!(image(&window) != before);
    let scene = &window.state().app().document.scene;
    let fresh = rasterscope_core::pipeline::render(scene, &rasterscope_core::pipeline::Skips::ALL);
    assert!(image(&window) == fresh.color, "it is the image of the last edit");
}

#[test]
fn what_is_edited_while_a_file_opens_is_not_taken_away() {
    let mut window = lazy();
    open(&mut window, "big.obj");
    window.run_steps(2);
    window.state_mut().app_mut().document.scene.clear.depth = 0.25;
    work(&mut window);
    let app = window.state().app();
    assert_eq!(app.document.scene.clear.depth, 0.25);
    assert_eq!(app.notice, Some(Notice::Unsaved(Box::new(Command::Open("big.obj".into())))));
}

#[test]
fn opening_can_be_stopped() {
    let mut window = lazy();
    let title = window.state().app().subtitle();
    open(&mut window, "big.obj");
    window.run_steps(20);
    window.get_by_label("Stop").click();
    window.run_steps(2);
    work(&mut window);
    assert_eq!(window.state().app().subtitle(), title);
    assert!(window.query_by_label("Opening big.obj").is_none());
}

#[test]
fn work_that_ends_with_a_fault_is_said() {
    let mut window = lazy();
    open(&mut window, "big.obj");
    window.state_mut().platform.waiting.clear();
    window.run_steps(2);
    let notice = window.state().app().notice.clone();
    assert!(matches!(&notice, Some(Notice::Failed(text)) if text.contains("fault")), "{notice:?}");
}
