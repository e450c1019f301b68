use super::*;
use crate::{face::Command, shell::notice::Notice};
use egui::{Key, Modifiers};

fn ask(window: &mut Window, command: Command) {
    let ctx = window.ctx.clone();
    let Desk { app, platform } = window.state_mut();
    app.as_mut().expect("made").execute(&ctx, vec![command], platform);
}

fn said(window: &Window) -> String {
    match &window.state().app().notice {
        Some(Notice::Failed(text) | Notice::Done(text)) => text.clone(),
        _ => String::new(),
    }
}

/// How many frames an animated PNG says that it has: eight bytes behind the name of the chunk.
fn frames(png: &[u8]) -> Option<usize> {
    let at = png.windows(4).position(|name| name == b"acTL")? + 4;
    Some(u32::from_be_bytes(png.get(at..at + 4)?.try_into().ok()?) as usize)
}

#[test]
fn a_run_is_written_as_an_animated_picture() {
    let mut window = window_with("cohen-sutherland");
    ask(&mut window, Command::Film("run.png".into()));
    window.run();
    let steps = len(&window) + 1;
    assert_eq!(said(&window), format!("Saved to run.png: {steps} frames."));
    let desk = window.state();
    assert_eq!(frames(&desk.platform.files["run.png"]), Some(steps));
}

#[test]
fn an_animated_picture_shows_its_progress_and_can_be_stopped() {
    let mut window = window_with("cohen-sutherland");
    window.state_mut().platform.lazy = true;
    ask(&mut window, Command::Film("run.png".into()));
    window.run_steps(20);
    window.get_by_label_contains("Animated picture: frame 1 of");
    ask(&mut window, Command::Film("other.png".into()));
    assert!(said(&window).contains("is being made"), "one at a time: {}", said(&window));
    window.key_press(Key::ArrowLeft);
    window.run_steps(2);
    assert_eq!(cursor(&window), len(&window) - 1, "the window answers meanwhile");
    click_once(&mut window, "Stop");
    window.state_mut().platform.work();
    window.run_steps(2);
    assert!(said(&window).contains("nothing was written"), "{}", said(&window));
    assert!(window.state().platform.files.is_empty());
    assert!(window.query_by_label("Stop").is_none());
}

/// A click in a window that does not come to rest.
fn click_once(window: &mut Window, label: &str) {
    window.get_by_label(label).click();
    window.run_steps(4);
}

#[test]
fn what_cannot_be_exported_is_said_in_a_sentence() {
    for (command, part) in [
        (Command::Film("/read-only/run.png".into()), "/read-only/run.png cannot be written: no permission."),
        (Command::Picture("/read-only/a.svg".into()), "/read-only/a.svg cannot be written: no permission."),
        (Command::Film("run.gif".into()), "ends in .png"),
        (Command::Picture("a.jpg".into()), "ends in .svg or .png"),
    ] {
        let mut window = window_with("cohen-sutherland");
        ask(&mut window, command.clone());
        window.run();
        assert!(said(&window).contains(part), "{command:?}: {:?}", said(&window));
        assert!(window.state().platform.files.is_empty());
    }
}

#[test]
fn values_are_written_as_they_are_copied() {
    let mut window = window_with("cohen-sutherland");
    ask(&mut window, Command::Picture("a.csv".into()));
    window.run();
    let text = String::from_utf8(window.state().platform.files["a.csv"].clone()).expect("it is text");
    assert!(text.starts_with("Ends,x,y,T B R L\nP1,3.5"), "{text}");
}

#[test]
fn the_path_that_is_offered_says_what_the_picture_shows() {
    let mut window = window(1280.0, 720.0);
    ask(&mut window, Command::Preset("line-three-cuts"));
    ask(&mut window, Command::Seek(6));
    window.run();
    for (modifiers, expected) in [
        (Modifiers::COMMAND, "cohen-sutherland-line-three-cuts-step6.svg"),
        (Modifiers::COMMAND | Modifiers::SHIFT, "cohen-sutherland-line-three-cuts-run.png"),
    ] {
        window.key_press_modifiers(modifiers, Key::E);
        window.run();
        let notice = window.state().app().notice.clone();
        assert!(
            matches!(&notice, Some(Notice::Path { path, .. }) if path == expected),
            "{notice:?} is not {expected}"
        );
        window.key_press(Key::Enter);
        window.run();
        assert!(window.state().platform.files.contains_key(expected), "{}", said(&window));
    }
}

#[test]
fn where_the_skips_stand_they_are_exported() {
    let mut window = window(1280.0, 720.0);
    ask(&mut window, Command::Preset("two-through-each-other"));
    ask(&mut window, Command::MeasureSkips);
    window.run();
    for name in ["a.svg", "a.csv", "a.json"] {
        ask(&mut window, Command::Picture(name.into()));
    }
    let desk = window.state();
    let text = |name: &str| String::from_utf8(desk.platform.files[name].clone()).expect("text");
    assert!(text("a.svg").contains("without it") && text("a.svg").contains("Skip"), "{}", text("a.svg"));
    let csv = text("a.csv");
    assert_eq!(csv.lines().count(), 2 + rasterscope_core::pipeline::Skip::ALL.len(), "{csv}");
    assert!(csv.contains(",true,back-face,triangles\n"), "{csv}");
    let json: serde_json::Value = serde_json::from_str(&text("a.json")).expect("JSON");
    assert!(json["results"][0]["ratio"].is_number() && json["machine"]["processor"] == "A test");

    ask(&mut window, Command::Preset("line-three-cuts"));
    window.run();
    ask(&mut window, Command::Picture("b.csv".into()));
    let text = String::from_utf8(window.state().platform.files["b.csv"].clone()).expect("text");
    assert!(!text.contains("back-face"), "another lab has other values: {text}");
}
