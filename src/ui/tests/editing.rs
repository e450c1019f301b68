use super::*;
use crate::face::Command;
use egui::{Key, Modifiers};
use rasterscope_core::scene::Scene;

fn scene(window: &Window) -> &Scene {
    &window.state().app().document.scene
}

fn names(window: &Window) -> Vec<String> {
    scene(window).draws.iter().map(|draw| draw.name.clone()).collect()
}

fn ask(window: &mut Window, command: Command) {
    let ctx = window.ctx.clone();
    let Desk { app, platform } = window.state_mut();
    app.as_mut().expect("made").execute(&ctx, vec![command], platform);
    window.run();
}

/// Types a number into a field, as by a click and the keyboard.
fn type_number(window: &mut Window, field: &str, number: &str) {
    window.get_by_label(field).focus();
    window.run();
    // A field that gets the keyboard has its number selected.
    window.event(egui::Event::Text(number.to_owned()));
    window.run();
    window.key_press(Key::Enter);
    window.run();
}

#[test]
fn objects_are_added_removed_and_reordered() {
    let mut window = window(1280.0, 1400.0);
    assert_eq!(names(&window), ["A", "B", "C"]);
    click(&mut window, "Add a triangle");
    assert_eq!(names(&window), ["A", "B", "C", "D"]);
    click(&mut window, "Draw object 4 earlier");
    assert_eq!(names(&window), ["A", "B", "D", "C"]);
    click(&mut window, "Draw object 1 later");
    assert_eq!(names(&window), ["B", "A", "D", "C"]);
    click(&mut window, "Remove object 2");
    assert_eq!(names(&window), ["B", "D", "C"]);
    for _ in 0..4 {
        window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        window.run();
    }
    assert_eq!(names(&window), ["A", "B", "C"], "each of them is one undo");
}

#[test]
fn a_reset_takes_every_edit_back_and_can_be_undone() {
    let mut window = window(1280.0, 1400.0);
    let before = scene(&window).clone();
    click(&mut window, "Add a triangle");
    click(&mut window, "Remove object 1");
    let edited = scene(&window).clone();
    ask(&mut window, Command::Reset);
    assert_eq!(*scene(&window), before);
    window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.run();
    assert_eq!(*scene(&window), edited);
}

#[test]
fn the_last_object_can_go() {
    let mut window = window(1280.0, 1400.0);
    for _ in 0..3 {
        click(&mut window, "Remove object 1");
    }
    assert!(names(&window).is_empty());
    click(&mut window, "Add a triangle");
    assert_eq!(names(&window), ["A"]);
}

#[test]
fn numbers_of_the_transform_are_typed() {
    let mut window = window(1280.0, 1400.0);
    window.state_mut().app_mut().open_lab("transform");
    window.run();
    let runs = window.state().app().run.runs();
    type_number(&mut window, "move x", "0.75");
    type_number(&mut window, "turn z", "30");
    type_number(&mut window, "eye z", "6");
    type_number(&mut window, "fovy", "45");
    let draw = &scene(&window).draws[0];
    let rasterscope_core::scene::Transform::Parts { translate, rotate_degrees, .. } = draw.transform else {
        panic!("it stays in parts");
    };
    assert_eq!((translate[0], rotate_degrees[2]), (0.75, 30.0));
    let camera = scene(&window).camera;
    assert_eq!(camera.eye[2], 6.0);
    assert_eq!(
        camera.projection,
        rasterscope_core::transform::Projection::Perspective { fovy_degrees: 45.0 }
    );
    assert!(window.state().app().run.runs() >= runs + 4, "each edit runs again");
}

#[test]
fn a_camera_that_sees_nothing_stays_as_it_was() {
    let mut window = window(1280.0, 1400.0);
    window.state_mut().app_mut().open_lab("transform");
    window.run();
    let before = scene(&window).camera;
    type_number(&mut window, "near", "1.5");
    assert_eq!(scene(&window).camera.near, 1.5);
    type_number(&mut window, "near", "1");
    for (field, number) in [("near", "-1"), ("near", "100"), ("far", "0.5"), ("fovy", "180"), ("eye z", "0")]
    {
        type_number(&mut window, field, number);
        assert_eq!(scene(&window).camera, before, "{field} {number}");
    }
}

#[test]
fn the_picture_is_written_as_on_the_canvas() {
    let mut window = window_with("cohen-sutherland");
    for path in ["a.svg", "b.PNG"] {
        ask(&mut window, Command::Picture(path.into()));
    }
    ask(&mut window, Command::Picture("c.gif".into()));
    let files = &window.state().platform.files;
    assert!(files["a.svg"].starts_with(b"<svg") || files["a.svg"].starts_with(b"<?xml"));
    assert!(String::from_utf8_lossy(&files["a.svg"]).contains("ymax"), "with its texts");
    assert!(files["b.PNG"].starts_with(b"\x89PNG"));
    assert!(!files.contains_key("c.gif"));
}

#[test]
fn picture_and_values_are_copied() {
    let mut window = window_with("cohen-sutherland");
    let copied = |window: &mut Window, command| {
        let ctx = window.ctx.clone();
        let Desk { app, platform } = window.state_mut();
        app.as_mut().expect("made").execute(&ctx, vec![command], platform);
        window.step();
        window.output().platform_output.commands.clone()
    };
    let image = copied(&mut window, Command::CopyPicture);
    let size = place(&window, "Canvas").size();
    assert!(image.iter().any(|command| matches!(command, egui::OutputCommand::CopyImage(image)
        if image.size[0] as f32 == 2.0 * size.x)));
    let text = copied(&mut window, Command::CopyValues);
    let text = text.iter().find_map(|command| match command {
        egui::OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    assert!(text.is_some_and(|text| text.starts_with("Ends,x,y,T B R L\nP1,3.5")), "as in the tab");
}
