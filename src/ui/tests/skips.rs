//! What the skips leave out: counted at once, measured when asked.

use super::*;
use crate::document::Scenery;
use egui::Key;

fn lazy() -> Window {
    window_on(1280.0, 720.0, Memory { lazy: true, ..Memory::default() })
}

#[test]
fn bars_are_counted_at_once_and_nothing_is_measured_unasked() {
    let mut window = lazy();
    click(&mut window, "Skips");
    assert_eq!(window.state().app().view.scenery, Scenery::Skips);
    assert!(window.state().platform.waiting.is_empty());
    window.get_by_label_contains("Counts of this image");
}

#[test]
fn a_measurement_runs_beside_the_window_and_says_what_it_proved() {
    let mut window = lazy();
    click(&mut window, "Skips");
    window.get_by_label("Measure the time").click();
    window.run_steps(3);
    assert_eq!(window.state().platform.waiting.len(), 1);
    window.state_mut().platform.work();
    window.run();
    window.get_by_label_contains("byte for byte");
    // Of another scene nothing is known.
    window.state_mut().app_mut().document.scene.size = [20, 20];
    window.run();
    window.get_by_label_contains("Counts of this image");
}

#[test]
fn a_measurement_can_be_stopped() {
    let mut window = lazy();
    window.state_mut().app_mut().view.palette = Some(Default::default());
    window.run();
    window.state_mut().app_mut().view.palette.as_mut().expect("it is open").typed = "measure the".into();
    window.run();
    window.key_press(Key::Enter);
    window.run_steps(30);
    assert_eq!(window.state().app().view.scenery, Scenery::Skips);
    window.key_press(Key::Escape);
    window.run_steps(2);
    window.state_mut().platform.work();
    window.run();
    window.get_by_label_contains("Counts of this image");
    assert_eq!(window.state().app().notice, None);
}
