//! The history of a pixel: found by number and by keys, and its rows go to their steps.

use super::*;
use crate::document::Tab;
use egui::{Key, Modifiers};
use rasterscope_core::message::Value;

fn at(window: &mut Window, pixel: [u32; 2]) {
    let view = &mut window.state_mut().app_mut().view;
    (view.pixel, view.tab) = (Some(pixel), Tab::Pixel);
    window.run();
}

#[test]
fn a_row_of_the_history_goes_to_the_step_of_its_fragment() {
    let mut window = window(1280.0, 720.0);
    at(&mut window, [13, 11]);
    window.get_by_label_contains("B: depth test failed").click();
    window.run();
    let shown = window.state().app().run.shown().expect("it runs");
    assert_eq!(shown.sentence.id, "z-buffer-fail");
    let place: Vec<_> = shown.sentence.args.iter().filter(|(name, _)| ["x", "y"].contains(name)).collect();
    assert_eq!(place, [&("x", Value::Int(13)), &("y", Value::Int(11))]);
}

#[test]
fn a_scene_with_a_stencil_is_stepped_at_a_pixel_too() {
    let mut window = window(1280.0, 720.0);
    window.state_mut().app_mut().open_preset("stencil-mask");
    at(&mut window, [16, 13]);
    window.get_by_label_contains("B 1: passed").click();
    window.run();
    let shown = window.state().app().run.shown().expect("it runs");
    assert!(shown.sentence.id.starts_with("stencil-pass"), "{}", shown.sentence.id);
}

#[test]
fn shift_and_the_arrows_move_the_pixel_and_stop_at_the_border() {
    let mut window = window(1280.0, 720.0);
    at(&mut window, [1, 1]);
    let step = cursor(&window);
    for (key, pixel) in [
        (Key::ArrowRight, [2, 1]),
        (Key::ArrowDown, [2, 2]),
        (Key::ArrowLeft, [1, 2]),
        (Key::ArrowLeft, [0, 2]),
        (Key::ArrowLeft, [0, 2]),
        (Key::ArrowUp, [0, 1]),
    ] {
        window.key_press_modifiers(Modifiers::SHIFT, key);
        window.run();
        assert_eq!(window.state().app().view.pixel, Some(pixel));
    }
    assert_eq!(cursor(&window), step, "the run stays where it is");
}

#[test]
fn a_row_whose_step_the_open_lab_lacks_opens_the_lab_that_has_it() {
    let mut sentence = None;
    for (row, lab) in [
        ("C: culled: back-facing", "back-face"),
        ("A.2: outside an edge", "aabb"),
        ("B: depth test failed", "pipeline"),
    ] {
        let mut window = window(1280.0, 720.0);
        at(&mut window, [13, 11]);
        window.get_by_label_contains(row).click();
        window.run();
        let app = window.state().app();
        assert_eq!(app.document.input().name(), lab, "{row}");
        assert_eq!(app.view.pixel, Some([13, 11]), "the pixel stays chosen");
        sentence = app.run.shown().map(|shown| shown.sentence.id);
    }
    assert_eq!(sentence, Some("z-buffer-fail"));
}

#[test]
fn a_click_tells_why_a_pixel_is_black() {
    let mut window = window(1280.0, 720.0);
    at(&mut window, [0, 0]);
    window.get_by_label_contains("Nothing comes to this pixel");
}
