//! The pages of measurements: nothing runs until asked, what is measured is drawn, saved and listed.

use super::{Memory, Window, click, window, window_on};
use crate::{
    face::Command,
    measure::{Page, Scope},
};
use egui_kittest::kittest::Queryable as _;
use rasterscope_figure::theme::ThemeName;

/// A window with a page open, whose work runs each thing once.
fn page(page: Page, platform: Memory) -> Window {
    let mut window = window_on(1280.0, 720.0, platform);
    window.state_mut().app_mut().measure.rounds = 1;
    ask(&mut window, Command::Measure(page));
    window
}

fn ask(window: &mut Window, command: Command) {
    let ctx = window.ctx.clone();
    let desk = window.state_mut();
    let (app, platform) = (desk.app.as_mut().expect("made in the first frame"), &mut desk.platform);
    app.execute(&ctx, vec![command], platform);
    window.run();
}

fn has_picture(window: &Window) -> bool {
    window.state().app().measure.picture().is_some()
}

#[test]
fn nothing_is_measured_until_somebody_asks() {
    let mut window = window(1280.0, 720.0);
    window.state_mut().app_mut().measure.rounds = 1;
    click(&mut window, "Measure");
    window.get_by_label_contains("Run time against error").click();
    window.run();
    assert!(!has_picture(&window) && window.query_by_label_contains("Nothing is measured yet").is_some());
    click(&mut window, "Measure now");
    assert!(has_picture(&window), "what was measured is drawn");
    assert!(window.query_by_label_contains("Nothing is measured yet").is_none());
    click(&mut window, "Back to the lab (Esc)");
    assert!(!window.state().app().measure.open);
}

#[test]
fn every_page_draws_its_results_in_every_theme() {
    for each in Page::ALL {
        let mut window = page(each, Memory::default());
        ask(&mut window, Command::StartMeasuring(Scope::Shown));
        assert!(has_picture(&window), "{each:?}");
        for theme in ThemeName::ALL {
            ask(&mut window, Command::Theme(theme));
            assert!(has_picture(&window), "{each:?} {theme:?}");
        }
    }
}

#[test]
fn picture_and_table_hold_what_is_shown() {
    let mut window = page(Page::Errors, Memory::default());
    ask(&mut window, Command::StartMeasuring(Scope::Shown));
    let shown = rasterscope_figure::svg::svg(window.state().app().measure.picture().expect("it is drawn"));
    for name in ["plot.svg", "plot.png", "table.csv", "table.json"] {
        ask(&mut window, Command::Picture(name.to_owned()));
    }
    let files = &window.state().platform.files;
    let text = |name: &str| String::from_utf8(files[name].clone()).expect("text");
    assert!(text("plot.svg") == shown, "the file is the screen");
    assert!(files["plot.png"].starts_with(b"\x89PNG"));
    // The machine, the names of fields, the fast call, and five algorithms in three arithmetics.
    assert_eq!(text("table.csv").lines().count(), 2 + 1 + 15);
    let json: serde_json::Value = serde_json::from_str(&text("table.json")).expect("JSON");
    assert_eq!(json["machine"]["processor"], "A test");
}

#[test]
fn work_can_be_stopped_and_the_page_be_left_meanwhile() {
    let mut window = page(Page::Errors, Memory { lazy: true, ..Memory::default() });
    ask(&mut window, Command::StartMeasuring(Scope::All));
    assert!(window.state().app().measure.is_busy());
    ask(&mut window, Command::Stop);
    window.state_mut().platform.work();
    window.run();
    assert!(
        !window.state().app().measure.is_busy() && !has_picture(&window),
        "stopped before its first part"
    );

    ask(&mut window, Command::StartMeasuring(Scope::Shown));
    ask(&mut window, Command::LeaveMeasure);
    window.state_mut().platform.work();
    window.run();
    ask(&mut window, Command::Measure(Page::Errors));
    assert!(has_picture(&window), "it was measured all the same");
}

#[test]
fn keys_of_the_lab_do_nothing_behind_a_page() {
    let mut window = page(Page::Claims, Memory::default());
    let before = super::cursor(&window);
    window.key_press(egui::Key::Home);
    window.run();
    assert_eq!(super::cursor(&window), before);
    window.key_press(egui::Key::Escape);
    window.run();
    assert!(!window.state().app().measure.open);
    window.key_press(egui::Key::Home);
    window.run();
    assert_eq!(super::cursor(&window), 0);
}
