use super::*;
use egui::{Key, Modifiers};

#[test]
fn a_command_is_found_by_its_words() {
    let mut window = window(1280.0, 720.0);
    window.key_press_modifiers(Modifiers::COMMAND, Key::K);
    window.run();
    assert!(window.ctx.text_edit_focused(), "one can type at once");
    window.event(egui::Event::Text("scan line".to_owned()));
    window.run();
    window.key_press(Key::Enter);
    window.run();
    let app = window.state().app();
    assert_eq!(app.document.input().name(), "scanline");
    assert_eq!(app.view.palette, None, "and the palette is gone");
}

#[test]
fn the_palette_is_driven_by_arrows_and_closed_by_escape() {
    let mut window = window(1280.0, 720.0);
    window.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::P);
    window.run();
    window.event(egui::Event::Text("theme: ".to_owned()));
    window.run();
    window.key_press(Key::ArrowDown);
    window.run();
    window.key_press(Key::Enter);
    window.run();
    assert_eq!(window.state().app().view.theme.name(), "light", "the second of them");
    window.key_press_modifiers(Modifiers::COMMAND, Key::K);
    window.run();
    window.key_press(Key::Escape);
    window.run();
    assert_eq!(window.state().app().view.palette, None);
}

#[test]
fn words_that_no_command_has_are_said_to_be_so() {
    let mut window = window(1280.0, 720.0);
    window.key_press_modifiers(Modifiers::COMMAND, Key::K);
    window.run();
    window.event(egui::Event::Text("no such words".to_owned()));
    window.run();
    window.get_by_label("No command has these words.");
}

#[test]
fn the_text_size_has_keys() {
    let mut window = window(1280.0, 720.0);
    for (key, expected) in [
        (Key::Plus, 1.25),
        (Key::Equals, 1.5),
        (Key::Minus, 1.25),
        (Key::Num0, 1.0),
        (Key::Minus, 0.75),
        (Key::Minus, 0.75),
    ] {
        window.key_press_modifiers(Modifiers::COMMAND, key);
        window.run();
        assert_eq!(window.ctx.zoom_factor(), expected, "after {key:?}");
    }
}

/// What is painted, layer by layer.
fn shapes(window: &Window) -> Vec<egui::epaint::ClippedShape> {
    window.output().shapes.clone()
}

/// Tab goes round everything, and each stop paints something new where it is.
#[test]
fn the_focus_is_seen_everywhere() {
    for lab in ["pipeline", "transform", "cohen-sutherland"] {
        let mut window = window_with(lab);
        let mut seen = Vec::new();
        let mut before = shapes(&window);
        for _ in 0..200 {
            window.key_press(Key::Tab);
            window.run();
            let Some(id) = window.ctx.memory(egui::Memory::focused) else { continue };
            if seen.contains(&id) {
                break;
            }
            let after = shapes(&window);
            let rect = window.ctx.read_response(id).expect("what has the focus is there").rect;
            let same = before.iter().zip(&after).take_while(|(a, b)| a == b).count();
            let rest = after.iter().rev().zip(before.iter().rev());
            let end = after.len()
                - rest.take(after.len().min(before.len()) - same).take_while(|(a, b)| a == b).count();
            let visible = |shape: &egui::epaint::ClippedShape| {
                shape.clip_rect.contains(rect.center()) && shape.shape.visual_bounding_rect().intersects(rect)
            };
            let changed = after[same..end].iter().any(visible);
            assert!(changed, "{lab}: nothing at {rect:?}, stop {}", seen.len());
            seen.push(id);
            before = after;
        }
        assert!(seen.len() > 30, "{lab}: only {} stops", seen.len());
    }
}
