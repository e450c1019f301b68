use super::*;
use crate::{face::Command, link::Thing, shell::notice::Notice};
use egui::{Key, OutputCommand, Shape};
use rasterscope_core::labs;
use rasterscope_figure::words::Words;

fn first_start(width: f32, height: f32) -> Window {
    window_on(width, height, Memory { hints: true, ..Memory::default() })
}

/// The next start after this window was killed.
fn next_start(window: &Window) -> Window {
    let kept = window.state().platform.kept.clone();
    let (width, height) = (1280.0, 720.0);
    window_on(width, height, Memory { kept, hints: true, ..Memory::default() })
}

fn ask(window: &mut Window, command: Command) {
    let ctx = window.ctx.clone();
    let Desk { app, platform } = window.state_mut();
    app.as_mut().expect("made").execute(&ctx, vec![command], platform);
    window.run();
}

/// Every text on the screen.
fn painted(window: &Window) -> Vec<String> {
    fn texts(shape: &Shape, out: &mut Vec<String>) {
        match shape {
            Shape::Text(text) => out.push(text.galley.text().to_owned()),
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| texts(shape, out)),
            _ => {}
        }
    }
    let mut out = Vec::new();
    window.output().shapes.iter().for_each(|clipped| texts(&clipped.shape, &mut out));
    out
}

const CLOSE: &str = "Close the hints; the help menu has them";

#[test]
fn hints_are_there_at_the_first_start_until_they_are_closed() {
    let mut first = first_start(1280.0, 720.0);
    first.get_by_label_contains("Drag a ring");
    let canvas = place(&first, "Canvas");
    assert!(canvas.bottom() <= place(&first, CLOSE).top(), "they cover nothing");
    first.key_press(Key::ArrowLeft);
    first.run();
    assert_eq!(cursor(&first), len(&first) - 1, "and keep nothing from being used");
    click(&mut first, CLOSE);
    assert!(first.query_by_label_contains("Drag a ring").is_none());
    first.run_steps(140);
    let mut second = next_start(&first);
    assert!(second.query_by_label_contains("Drag a ring").is_none());
    ask(&mut second, Command::Hints);
    second.get_by_label_contains("Drag a ring");
}

#[test]
fn a_large_window_offers_bigger_text_once() {
    let mut first = first_start(2560.0, 1440.0);
    assert_eq!(first.state().app().notice, Some(Notice::Large));
    click(&mut first, "150 %");
    assert_eq!((first.ctx.zoom_factor(), &first.state().app().notice), (1.5, &None));
    first.run_steps(140);
    assert_eq!(next_start(&first).state().app().notice, None);
    assert_eq!(first_start(1280.0, 720.0).state().app().notice, None);
}

#[test]
fn step_and_listing_stand_side_by_side_where_there_is_room() {
    for (width, beside) in [(1280.0, false), (2560.0, true)] {
        let mut window = window(width, 1440.0);
        ask(&mut window, Command::Dismiss);
        window.state_mut().app_mut().open_lab("cohen-sutherland");
        window.run();
        let row = place(&window, "P1 3.5 2.9 0 0 0 0");
        let line = place(&window, "1: c1 ← code(P1)");
        assert_eq!(line.left() > row.right(), beside, "at {width}");
        assert!(line.right() <= width);
    }
}

#[test]
fn exact_values_have_every_digit_and_their_bits() {
    let mut window = window_with("cohen-sutherland");
    let exact = "3.5 (0x40600000)".to_owned();
    assert!(!painted(&window).contains(&exact));
    window.key_press(Key::F2);
    window.run();
    assert!(painted(&window).contains(&exact), "{:?}", painted(&window));
    assert!(painted(&window).contains(&"2.900000095367431640625 (0x4039999A)".to_owned()));
    window.key_press(Key::F2);
    window.run();
    assert!(!painted(&window).contains(&exact));
}

#[test]
fn a_click_on_a_value_copies_it() {
    let mut window = window_with("cohen-sutherland");
    let row = place(&window, "P1 3.5 2.9 0 0 0 0");
    let mut copied = Vec::new();
    for part in [0.3, 0.55] {
        let at = egui::pos2(row.left() + part * row.width(), row.center().y);
        window.hover_at(at);
        window.run();
        window.drag_at(at);
        window.step();
        window.event(egui::Event::PointerButton {
            pos: at,
            button: egui::PointerButton::Primary,
            pressed: false,
            modifiers: egui::Modifiers::NONE,
        });
        window.step();
        copied.extend(window.output().platform_output.commands.iter().find_map(|command| match command {
            OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        }));
        window.run();
    }
    assert_eq!(copied, ["3.5", "2.900000095367431640625"]);
}

#[test]
fn a_heading_says_what_it_means() {
    let window = window_with("cohen-sutherland");
    window.get_by_label_contains("T B R L: Outcode");
}

/// Headings that say nothing but which coordinate it is, or what object.
const PLAIN: [&str; 8] = ["x", "y", "z", "", "column-object", "column-count", "v", "r"];

#[test]
fn the_glossary_has_the_headings_of_the_first_labs() {
    let words = Words::default();
    for name in ["cohen-sutherland", "liang-barsky", "scanline", "z-buffer"] {
        let mut document = crate::document::Document::new(rasterscope_core::scene::Scene::empty([8, 8]));
        document.scene =
            crate::files::scene(rasterscope_core::scene::PRESETS[0].json.as_bytes(), "", &mut |_| None)
                .expect("a preset");
        document.open_lab(name, || labs::default_input(name).expect("a lab"));
        let mut run = labs::play(&document.scene, Default::default()).expect("it runs");
        run.seek(run.len());
        for table in run.tables() {
            for column in table.columns.iter().filter(|column| !PLAIN.contains(column)) {
                assert!(words.meaning(column).is_some(), "{name}: {column}");
            }
        }
    }
}

#[test]
fn one_thing_is_lit_in_every_panel() {
    let mut window = window_with("cohen-sutherland");
    let hover = |window: &mut Window, at: egui::Pos2| {
        window.hover_at(at);
        window.run();
        window.state().app().links.now().cloned()
    };
    let row = place(&window, "P1 3.5 2.9 0 0 0 0").center();
    assert_eq!(hover(&mut window, row), Some(Thing::Name("P1".into())));
    assert!(window.state().app().links.line("c1 ← code(P1)"));
    let line = place(&window, "1: c1 ← code(P1)").center();
    assert_eq!(hover(&mut window, line), Some(Thing::Line("c1 ← code(P1)".into())));
    assert!(window.state().app().links.name("P1") && !window.state().app().links.name("P2"));
    let end = place(&window, "P1").center();
    assert_eq!(hover(&mut window, end), Some(Thing::Name("P1".into())));
    assert!(window.state().app().links.name("P1′"));
    let nothing = place(&window, "To the start").center();
    assert_eq!(hover(&mut window, nothing), None);
}

#[test]
fn a_row_of_the_span_table_is_a_row_of_pixels() {
    let mut window = window_with("scanline");
    let canvas = place(&window, "Canvas").center();
    window.hover_at(canvas);
    window.run();
    let Some(Thing::Row(row)) = window.state().app().links.now().cloned() else { panic!("a row") };
    assert!(window.state().app().links.name(&row.to_string()));
}

#[test]
fn a_vertex_in_space_is_a_row_of_its_table() {
    let mut window = window_with("clip-plane");
    let vertex = place(&window, "v1").center();
    window.hover_at(vertex);
    window.run();
    assert_eq!(window.state().app().links.now(), Some(&Thing::Name("v1".into())));
}

#[test]
fn less_motion_is_kept() {
    let mut first = window(1280.0, 720.0);
    assert!(first.ctx.global_style().animation_time > 0.0);
    ask(&mut first, Command::Still);
    assert_eq!(first.ctx.global_style().animation_time, 0.0);
    first.run_steps(140);
    assert_eq!(next_start(&first).ctx.global_style().animation_time, 0.0);
}

#[test]
fn a_lab_names_its_lectures() {
    let mut window = window_with("cohen-sutherland");
    click(&mut window, "Lectures (2): Clipping di un segmento (Cohen-Sutherland)");
    window.get_by_label("Cohen-Sutherlandi algoritm");
    window.get_by_label("Nähtamatute pindade eemaldamine");
    for lab in labs::ALL {
        for topic in lab.topics() {
            assert!(!topic.heading.is_empty() && !topic.lecture.is_empty(), "{}", lab.name);
        }
    }
}
