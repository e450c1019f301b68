use super::*;
use egui::{Key, Modifiers};

#[test]
fn keys_step_forward_and_back() {
    let mut window = window_with("cohen-sutherland");
    let last = len(&window);
    for (key, expected) in [
        (Key::Home, 0),
        (Key::ArrowRight, 1),
        (Key::ArrowRight, 2),
        (Key::ArrowLeft, 1),
        (Key::End, last),
        (Key::ArrowRight, last),
        (Key::ArrowLeft, last - 1),
    ] {
        window.key_press(key);
        window.run();
        assert_eq!(cursor(&window), expected, "after {key:?}");
    }
}

#[test]
fn a_key_shows_in_the_same_frame() {
    let mut window = window_with("cohen-sutherland");
    window.key_press(Key::Home);
    window.step();
    window.get_by_label("Step of the run");
    assert_eq!(cursor(&window), 0);
}

#[test]
fn a_text_field_keeps_its_keys() {
    let mut window = window_with("cohen-sutherland");
    let before = cursor(&window);
    window.key_press_modifiers(Modifiers::COMMAND, Key::O);
    window.run();
    assert!(window.ctx.text_edit_focused(), "the path field has the keyboard");
    for key in [Key::Home, Key::ArrowLeft, Key::Space, Key::F8] {
        window.key_press(key);
        window.run();
    }
    assert_eq!(cursor(&window), before);
    assert!(!window.state().app().view.playing());
}

#[test]
fn playing_steps_by_itself_and_ends() {
    let mut window = window_with("cohen-sutherland");
    window.state_mut().app_mut().view.speed = 10.0;
    window.key_press(Key::Space);
    window.step();
    assert!(window.state().app().view.playing());
    assert_eq!(cursor(&window), 0, "playing from the end begins at the start");
    let steps = len(&window) * 40;
    window.run_steps(steps);
    assert_eq!(cursor(&window), len(&window));
    assert!(!window.state().app().view.playing());
}

#[test]
fn nothing_repaints_while_nothing_changes() {
    for lab in rasterscope_core::labs::ALL {
        let mut window = window_with(lab.name);
        // Two seconds after the last change the work is kept; then nothing is due.
        window.run_steps(140);
        let drawn = window.state().app().canvas.drawn;
        window.step();
        let wait = window.output().viewport_output.values().map(|output| output.repaint_delay).min();
        assert_eq!(wait, Some(std::time::Duration::MAX), "{}", lab.name);
        assert_eq!(window.state().app().canvas.drawn, drawn, "{}: nothing is laid out anew", lab.name);
    }
}

#[test]
fn theme_key_cycles_through_all_themes() {
    let mut window = window_with("cohen-sutherland");
    let mut seen = Vec::new();
    for _ in 0..4 {
        seen.push(window.state().app().view.theme.name());
        window.key_press(Key::F8);
        window.run();
    }
    assert_eq!(seen, ["dark", "light", "projector", "dark"]);
}

#[test]
fn tab_reaches_a_handle_and_arrows_move_it() {
    let mut window = window_with("cohen-sutherland");
    window.get_by_label("P1").focus();
    window.run();
    let before = window.state().app().document.clone();
    let at = cursor(&window);
    window.key_press(Key::ArrowRight);
    window.run();
    let handles = |window: &Window| {
        let app = window.state().app();
        app.labs[app.lab()].handles(&app.document)
    };
    let moved = handles(&window).into_iter().find(|handle| handle.name == "P1").expect("it is there");
    let app = window.state().app();
    let old =
        app.labs[app.lab()].handles(&before).into_iter().find(|handle| handle.name == "P1").expect("it was");
    assert_eq!(moved.at, [old.at[0] + 0.5, old.at[1]], "half a unit to the right");
    assert_eq!(
        cursor(&window),
        len(&window),
        "the arrow moved the handle, not the step; at the end it stays there"
    );
    assert!(at > 0);
}

#[test]
fn a_handle_dragged_by_the_mouse_leaves_the_arrow_keys_to_the_steps() {
    let mut window = window_with("cohen-sutherland");
    let from = place(&window, "P1").center();
    drag(&mut window, from, from + vec2(20.0, -30.0));
    let document = window.state().app().document.clone();
    let last = len(&window);
    window.key_press(Key::ArrowLeft);
    window.run();
    assert_eq!((cursor(&window), &window.state().app().document), (last - 1, &document));
}
