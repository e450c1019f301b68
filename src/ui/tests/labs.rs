use super::*;
use crate::document::Tab;
use egui::{Key, Modifiers};
use rasterscope_core::labs::LabInput;

/// Every registered lab: step, back, scrub, edit by handle, undo, redo.
#[test]
fn every_lab_can_be_driven() {
    for lab in rasterscope_core::labs::ALL {
        let mut window = window_with(lab.name);
        assert_eq!(window.state().app().problem(), None, "{}", lab.name);
        step_and_scrub(&mut window, lab.name);
        edit_and_undo(&mut window, lab.name);
    }
}

fn step_and_scrub(window: &mut Window, name: &str) {
    click(window, "To the start");
    assert_eq!(cursor(window), 0, "{name}");
    click(window, "Step forward");
    let first = cursor(window);
    assert!(first > 0, "{name}");
    click(window, "Step back");
    assert_eq!(cursor(window), 0, "{name}");
    let bar = place(window, "Step of the run");
    let y = bar.center().y;
    drag(window, egui::pos2(bar.left() + 10.0, y), egui::pos2(bar.center().x, y));
    let middle = cursor(window);
    assert!(middle > 0 && middle < len(window), "{name}: {middle} of {}", len(window));
    let sentence = window.state().app().run.shown().map(|shown| shown.sentence.clone());
    let line = window.state().app().run.shown().and_then(|shown| shown.line);
    assert!(sentence.is_some() && line.is_some(), "{name}");
    click(window, "Step forward");
    click(window, "Step back");
    assert_eq!(cursor(window), middle, "{name}: forward and back");
}

fn edit_and_undo(window: &mut Window, name: &str) {
    let app = window.state().app();
    let Some(handle) = app.labs[app.lab()].handles(&app.document).pop() else { return };
    let before = app.document.clone();
    let (step, runs) = (cursor(window), app.run.runs());
    let from = place(window, &handle.name).center();
    drag(window, from, from + vec2(-40.0, 30.0));
    let app = window.state().app();
    assert_ne!(app.document, before, "{name}: the drag edits the document");
    assert!(app.run.runs() > runs, "{name}: and runs again");
    assert_eq!(cursor(window), step.min(len(window)), "{name}: at the same step");
    let after = app.document.clone();
    window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.run();
    assert_eq!(window.state().app().document, before, "{name}: one undo takes the whole drag back");
    window.key_press_modifiers(Modifiers::COMMAND, Key::Y);
    window.run();
    assert_eq!(window.state().app().document, after, "{name}: redo");
}

#[test]
fn moving_the_cursor_runs_nothing_again() {
    let mut window = window_with("cohen-sutherland");
    let runs = window.state().app().run.runs();
    for key in [Key::Home, Key::ArrowRight, Key::End, Key::ArrowLeft] {
        window.key_press(key);
        window.run();
    }
    assert_eq!(window.state().app().run.runs(), runs);
}

#[test]
fn a_click_on_a_listing_line_goes_to_its_next_execution() {
    let mut window = window_with("cohen-sutherland");
    click(&mut window, "To the start");
    let listing = window.state().app().run.shown().expect("it runs").listing;
    click(&mut window, &format!("2: {}", listing[1].trim_start()));
    assert_eq!(window.state().app().run.shown().and_then(|shown| shown.line), Some(1));
}

#[test]
fn escape_puts_a_drag_back() {
    let mut window = window_with("cohen-sutherland");
    let before = window.state().app().document.clone();
    let from = place(&window, "P2").center();
    window.hover_at(from);
    window.run();
    window.drag_at(from);
    window.step();
    window.hover_at(from + vec2(-80.0, 40.0));
    window.step();
    window.step();
    assert_ne!(window.state().app().document, before);
    window.key_press(Key::Escape);
    window.run();
    assert_eq!(window.state().app().document, before);
    window.drop_at(from + vec2(-80.0, 40.0));
    window.run();
    assert!(!window.state().app().history.can_undo());
}

#[test]
fn every_preset_opens_and_runs() {
    let mut window = window(1280.0, 720.0);
    for preset in rasterscope_core::scene::PRESETS {
        window.state_mut().app_mut().open_preset(preset.name);
        window.run();
        let app = window.state().app();
        assert_eq!(app.notice, None, "{}", preset.name);
        assert!(!app.modified(), "{}: to look at it is no edit", preset.name);
        // A scene that is not one depth test has no steps of its own, but its picture.
        let has_picture = app.overview.outputs().frame.size == app.document.scene.size;
        assert!(
            app.problem().is_none() || app.document.input().name() == "pipeline" && has_picture,
            "{}",
            preset.name
        );
    }
    assert_eq!(window.state().app().presets.len(), rasterscope_core::scene::PRESETS.len(), "all can be read");
}

#[test]
fn a_narrow_window_folds() {
    let mut window = window(1024.0, 768.0);
    assert!(window.query_by_label("Preset").is_none(), "the choices are folded");
    click(&mut window, "Choices");
    assert!(window.query_by_label("Preset").is_some());
    window.key_press(Key::Escape);
    window.run();
    assert!(window.query_by_label("Preset").is_none());
}

#[test]
fn choosing_a_pixel_draws_no_image_again() {
    let mut window = window(1280.0, 720.0);
    let counts = |window: &Window| {
        let app = window.state().app();
        (app.overview.image_runs(), app.textures.made(), app.run.runs())
    };
    let before = counts(&window);
    for pixel in [[13, 11], [20, 5]] {
        window.state_mut().app_mut().view.pixel = Some(pixel);
        window.state_mut().app_mut().view.tab = Tab::Pixel;
        window.run();
        window.get_by_label(&format!("Pixel ({}, {})", pixel[0], pixel[1]));
    }
    assert_eq!(counts(&window), before, "images, textures, runs");
}

#[test]
fn a_click_tells_why_a_pixel_is_as_it_is() {
    let mut window = window(1280.0, 720.0);
    let centre = place(&window, "Canvas").center();
    window.hover_at(centre);
    window.run();
    window.drag_at(centre);
    window.step();
    window.drop_at(centre);
    window.run();
    let app = window.state().app();
    assert!(app.view.pixel.is_some() && app.view.tab == Tab::Pixel);
    assert!(window.query_by_label_contains("A.1: passed").is_some());
}

#[test]
fn a_dragged_vertex_moves_the_counts_of_the_stages() {
    let mut window = window(1280.0, 720.0);
    let before = window.state().app().overview.outputs().frame.stats;
    let from = place(&window, "B0").center();
    drag(&mut window, from, from + vec2(60.0, -40.0));
    assert_ne!(window.state().app().overview.outputs().frame.stats, before);
}

#[test]
fn the_camera_outside_turns_and_comes_nearer() {
    let mut window = window(1280.0, 720.0);
    click(&mut window, "Space");
    let orbit = |window: &Window| window.state().app().view.orbit.expect("it is used");
    let before = orbit(&window);
    let centre = place(&window, "Canvas").center();
    drag(&mut window, centre, centre + vec2(80.0, 20.0));
    let turned = orbit(&window);
    assert!(turned.yaw != before.yaw && turned.pitch != before.pitch && turned.distance == before.distance);
    assert!(!window.state().app().history.can_undo(), "the view is no document");
}

#[test]
fn a_stage_opens_the_algorithm_that_was_open_last() {
    let name = |window: &Window| window.state().app().document.input().name();
    let mut window = window_with("cohen-sutherland");
    click(&mut window, "Algorithm: Cohen–Sutherland");
    click(&mut window, "Liang–Barsky");
    assert_eq!(name(&window), "liang-barsky");
    window.get_by_label_contains("Image: ").click();
    window.run();
    assert_eq!(name(&window), "pipeline");
    window.get_by_label_contains("Clip: ").click();
    window.run();
    assert_eq!(name(&window), "liang-barsky", "not the first one of the stage");
    window.key_press_modifiers(Modifiers::COMMAND, Key::PageUp);
    window.run();
    assert_eq!(name(&window), "cohen-sutherland");
}

#[test]
fn every_lab_has_its_sentence() {
    let words = rasterscope_figure::words::Words::default();
    for lab in rasterscope_core::labs::ALL {
        assert!(words.has(lab.name) && words.has(&format!("{}-about", lab.name)), "{}", lab.name);
    }
}

#[test]
fn the_triangles_of_a_run_are_named_on_the_timeline() {
    let window = window_with("z-buffer");
    let app = window.state().app();
    let captions = &app.run.shown().expect("it runs").captions;
    let captions: Vec<String> = captions.iter().map(|(_, caption)| app.words.message(caption)).collect();
    assert_eq!(captions, ["A.1", "A.2", "B"]);
}

#[test]
fn a_vertex_in_space_is_dragged_and_turning_the_camera_is_no_edit() {
    let mut window = window(1280.0, 720.0);
    window.state_mut().app_mut().open_preset("clip-one-in");
    window.run();
    let vertices = |window: &Window| match window.state().app().document.input() {
        LabInput::ClipTriangle(input) => input.vertices,
        other => panic!("{} is open", other.name()),
    };
    let (before, runs) = (vertices(&window), window.state().app().run.runs());
    let canvas = place(&window, "Canvas");
    let corner = canvas.min + vec2(30.0, 30.0);
    drag(&mut window, corner, corner + vec2(60.0, 20.0));
    let app = window.state().app();
    assert!(app.view.outside.is_some() && app.run.runs() == runs, "turned, not run");
    assert_eq!(vertices(&window), before);
    let from = place(&window, "v0").center();
    drag(&mut window, from, from + vec2(50.0, -40.0));
    assert_ne!(vertices(&window), before);
    assert!(window.state().app().history.can_undo());
}

/// A lab's own chip counts what the lab is about, and of one thing in the singular.
#[test]
fn a_chip_says_what_is_counted() {
    let mut window = window(1280.0, 720.0);
    for (preset, chip) in [
        ("pieces-three", "Clip: 1 → 3"),
        ("light-highlight", "Scene: 1 point"),
        ("light-highlight", "Fragments: 1 value"),
        ("tiles-nested", "tile rows"),
    ] {
        window.state_mut().app_mut().open_preset(preset);
        window.run();
        assert!(window.query_by_label_contains(chip).is_some(), "{preset}: {chip}");
        let plural = format!("{chip}s");
        assert!(window.query_by_label_contains(&plural).is_none(), "{preset}: {plural}");
    }
}
