use super::*;
use crate::document::Tab;
use egui::{Key, Modifiers};
use rasterscope_core::{
    compare::{Setting, Side, settings},
    labs,
    math::Arithmetic,
    raster::FillRule,
};

/// A window with a preset of two sides open.
fn split(preset: &'static str) -> Window {
    let mut window = window(1280.0, 720.0);
    window.state_mut().app_mut().open_preset(preset);
    window.run();
    assert!(window.state().app().split(), "{preset} opens split");
    window
}

fn compared(window: &Window) -> Option<Setting> {
    window.state().app().document.scene.compared()
}

fn cursors(window: &Window) -> [usize; 2] {
    let pair = window.state().app().run.pair().expect("two runs");
    Side::ALL.map(|side| pair.run(side).cursor())
}

#[test]
fn every_lab_splits_steps_and_leaves() {
    for lab in labs::ALL {
        let mut window = window_with(lab.name);
        let app = window.state_mut().app_mut();
        let all = settings(&app.document.scene);
        let setting = *all.first().unwrap_or_else(|| panic!("{} compares nothing", lab.name));
        let before = app.document.clone();
        window.key_press(Key::C);
        window.run();
        window.key_press(Key::Enter);
        window.run();
        assert_eq!(compared(&window), Some(setting), "{}: the first of the list", lab.name);
        assert_eq!(window.state().app().view.tab, Tab::Difference, "{}", lab.name);
        window.get_by_label("Counts");
        let ends = cursors(&window);
        window.key_press(Key::Home);
        window.run();
        assert_eq!(cursors(&window), [0, 0], "{}", lab.name);
        window.key_press(Key::ArrowRight);
        window.run();
        assert!(cursors(&window).into_iter().max() > Some(0), "{}", lab.name);
        window.key_press(Key::End);
        window.run();
        assert_eq!(cursors(&window), ends, "{}: both at their ends", lab.name);
        drag_on_both_sides(&mut window, lab.name);
        window.key_press(Key::Escape);
        window.run();
        assert_eq!(compared(&window), None, "{}", lab.name);
        assert_eq!(window.state().app().view.tab, Tab::Step, "{}", lab.name);
        while window.state().app().document != before {
            let app = window.state().app();
            assert!(app.history.can_undo(), "{}: every edit can be taken back", lab.name);
            window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
            window.run();
        }
    }
}

/// A handle on either side edits the one document, which both show.
fn drag_on_both_sides(window: &mut Window, name: &str) {
    let app = window.state().app();
    let Some(handle) = app.labs[app.lab()].handles(&app.document).pop() else { return };
    for label in [handle.name.clone(), format!("{} on side B", handle.name)] {
        let before = window.state().app().document.clone();
        let from = place(window, &label).center();
        drag(window, from, from + vec2(-24.0, 18.0));
        let app = window.state().app();
        assert_ne!(app.document, before, "{name}: dragging {label} edits");
        assert_eq!(app.document.scene.compared(), before.scene.compared(), "{name}: and stays split");
        let mut scene = app.document.scene.clone();
        let setting = scene.compared().expect("it is split");
        assert_eq!(setting.of(&scene), setting.of(&before.scene), "{name}: side A keeps its own setting");
        assert!(rasterscope_core::compare::side_b(&scene).is_some());
        scene.lab = None;
        assert_eq!(app.problem(), None, "{name}");
    }
}

#[test]
fn turning_it_on_and_off_is_undone_like_any_edit() {
    let mut window = window_with("cohen-sutherland");
    let key = |window: &mut Window, key| {
        window.key_press_modifiers(Modifiers::COMMAND, key);
        window.run();
    };
    click(&mut window, "Split view");
    window.get_by_label("Algorithm: Liang–Barsky").click();
    window.run();
    let on = Some(Setting::Algorithm("liang-barsky"));
    assert_eq!(compared(&window), on);
    click(&mut window, "One side");
    for (undo, expected) in [(Key::Z, on), (Key::Z, None), (Key::Y, on), (Key::Y, None)] {
        key(&mut window, undo);
        assert_eq!(compared(&window), expected);
    }
}

#[test]
fn side_b_runs_only_while_it_is_shown() {
    let mut window = window_with("cohen-sutherland");
    let runs = |window: &Window| window.state().app().run.runs();
    let before = runs(&window);
    let compare = |window: &mut Window, setting| {
        window.state_mut().app_mut().document.compare(setting);
        window.run();
    };
    compare(&mut window, Some(Setting::Arithmetic(Arithmetic::F32)));
    assert_eq!(runs(&window), before + 1, "side A goes on as it is");
    compare(&mut window, Some(Setting::Arithmetic(Arithmetic::F64)));
    assert_eq!(runs(&window), before + 2);
    for key in [Key::Home, Key::ArrowRight, Key::End] {
        window.key_press(key);
        window.run();
    }
    assert_eq!(runs(&window), before + 2, "stepping runs nothing");
    compare(&mut window, None);
    assert_eq!(runs(&window), before + 2, "nor does leaving");
}

#[test]
fn nothing_repaints_while_two_sides_stand_still() {
    let mut window = split("two-sides-tie");
    window.run_steps(140);
    let drawn =
        |window: &Window| [&window.state().app().canvas, &window.state().app().beside].map(|c| c.drawn);
    let before = drawn(&window);
    window.step();
    let wait = window.output().viewport_output.values().map(|output| output.repaint_delay).min();
    assert_eq!(wait, Some(std::time::Duration::MAX));
    assert_eq!(drawn(&window), before, "nothing is laid out anew");
}

#[test]
fn one_camera_serves_both_sides() {
    let mut window = split("two-sides-corner");
    let scales = |window: &Window| {
        let app = window.state().app();
        [&app.canvas, &app.beside].map(|canvas| canvas.placement().expect("it is drawn"))
    };
    let [a, b] = scales(&window);
    assert_eq!(a, b);
    let at = egui::pos2(800.0, 500.0);
    drag(&mut window, at, at + vec2(30.0, -20.0));
    let [moved_a, moved_b] = scales(&window);
    assert_ne!(moved_a, a, "dragging the ground of B moves A");
    assert_eq!(moved_a, moved_b);
}

#[test]
fn a_pixel_that_is_clicked_is_explained_on_both_sides() {
    let mut window = split("two-sides-tie");
    let canvas = &window.state().app().beside;
    let [x, y] = canvas.placement().expect("it is drawn").to_points([7.5, 3.5]);
    let origin = place(&window, "upper0 on side B").center();
    let [ax, ay] = canvas.placement().expect("it is drawn").to_points([1.5, 1.5]);
    let at = origin + vec2(x - ax, y - ay);
    window.hover_at(at);
    window.run();
    window.drag_at(at);
    window.step();
    window.drop_at(at);
    window.run();
    window.get_by_label_contains("Pixel (7, 3), centre (7.5, 3.5)");
    window.get_by_label_contains("Only side B has it (Tie rule: inclusive).");
}

#[test]
fn the_header_chooses_what_a_side_has() {
    let mut window = split("two-sides-tie");
    click(&mut window, "A: Tie rule");
    window.get_by_label("strict").click();
    window.run();
    assert_eq!(window.state().app().document.scene.fill_rule, FillRule::Strict);
    assert_eq!(compared(&window), Some(Setting::FillRule(FillRule::Inclusive)));
}

#[test]
fn the_picture_of_two_sides_has_both() {
    let mut window = split("two-sides-tie");
    window.state_mut().app_mut().view.part = None;
    let figure = window.state().app().split_figure().expect("two drawings");
    let texts: Vec<&str> = figure.texts().collect();
    for text in ["A", "B", "top-left", "inclusive"] {
        assert!(texts.contains(&text), "{text}: {texts:?}");
    }
    let Desk { app, platform } = window.state_mut();
    app.as_mut().expect("it is there").write_picture("/both.svg", platform);
    let svg = String::from_utf8(platform.files["/both.svg"].clone()).expect("text");
    assert_eq!(svg.matches("stroke-dasharray=\"5 4\"").count(), 2 * 13, "a row and a column, on both sides");
}

#[test]
fn a_scene_that_cannot_be_stepped_says_so_in_both_panes() {
    let mut window = window(1280.0, 720.0);
    window.state_mut().app_mut().open_preset("order-of-blending");
    window.state_mut().app_mut().open_lab("z-buffer");
    let document = &mut window.state_mut().app_mut().document;
    // The lab's steps are those of one depth test; these are two.
    document.scene.draws[0].depth.write ^= true;
    document.compare(Some(Setting::FillRule(FillRule::Strict)));
    window.run();
    assert!(window.state().app().problem().is_some());
    window.key_press(Key::Escape);
    window.run();
    assert!(!window.state().app().split());
}
