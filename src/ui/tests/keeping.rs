use super::*;
use crate::{face::Command, shell::notice::Notice};
use egui::{Key, Modifiers};
use rasterscope_core::labs::LabInput;

/// Edits the document as a drag does, all at once.
fn edit(window: &mut Window) {
    let Desk { app, .. } = window.state_mut();
    let document = &mut app.as_mut().expect("made").document;
    document.scene.clear.depth = 0.25;
    window.run();
}

fn ask(window: &mut Window, command: Command) {
    let ctx = window.ctx.clone();
    let Desk { app, platform } = window.state_mut();
    app.as_mut().expect("made").execute(&ctx, vec![command], platform);
    window.run();
}

fn notice(window: &Window) -> Option<Notice> {
    window.state().app().notice.clone()
}

fn depth(window: &Window) -> f32 {
    window.state().app().document.scene.clear.depth
}

/// Long enough that what is due is kept.
fn wait(window: &mut Window) {
    window.run_steps(140);
}

/// The machine as the next start finds it, after this window was killed.
fn killed(window: Window) -> Memory {
    let platform = &window.state().platform;
    Memory { files: platform.files.clone(), kept: platform.kept.clone(), ..Memory::default() }
}

#[test]
fn opening_with_unsaved_edits_asks() {
    let other = rasterscope_core::scene::PRESETS[1].name;
    let title = |window: &Window| window.state().app().document.scene.name.clone();
    let mut window = window(1280.0, 720.0);
    let first = title(&window);
    edit(&mut window);
    ask(&mut window, Command::Preset(other));
    assert!(matches!(notice(&window), Some(Notice::Unsaved(_))));
    assert_eq!(title(&window), first);
    click(&mut window, "Cancel");
    assert_eq!((title(&window), notice(&window), depth(&window)), (first, None, 0.25));
    ask(&mut window, Command::Preset(other));
    click(&mut window, "Discard");
    assert_ne!(depth(&window), 0.25);
    assert_eq!(window.state().app().preset.as_ref().map(|(name, _)| *name), Some(other));
}

#[test]
fn saving_first_saves_then_goes_on() {
    let other = rasterscope_core::scene::PRESETS[1].name;
    let mut window = window(1280.0, 720.0);
    edit(&mut window);
    ask(&mut window, Command::Preset(other));
    window.get_by_label("There are unsaved edits.");
    ask(&mut window, Command::SaveFirst);
    assert!(
        matches!(notice(&window), Some(Notice::Path { .. })),
        "there is no file yet: its path is asked for"
    );
    ask(&mut window, Command::SaveAs("mine.json".into()));
    assert!(window.state().platform.files.contains_key("mine.json"));
    assert_eq!(window.state().app().preset.as_ref().map(|(name, _)| *name), Some(other));
}

#[test]
fn a_save_that_fails_takes_nothing_away() {
    let mut window = window(1280.0, 720.0);
    edit(&mut window);
    ask(&mut window, Command::Preset(rasterscope_core::scene::PRESETS[1].name));
    ask(&mut window, Command::SaveFirst);
    ask(&mut window, Command::SaveAs("/read-only/mine.json".into()));
    assert!(matches!(notice(&window), Some(Notice::Failed(_))));
    assert_eq!(depth(&window), 0.25);
    assert!(window.state().app().modified());
}

#[test]
fn looking_around_is_no_edit() {
    let mut window = window(1280.0, 720.0);
    for lab in rasterscope_core::labs::ALL {
        window.state_mut().app_mut().open_lab(lab.name);
        window.run();
        window.key_press(Key::ArrowLeft);
        window.run();
        assert!(!window.state().app().modified(), "{}", lab.name);
    }
}

#[test]
fn an_undone_edit_is_no_edit() {
    let mut window = window_with("cohen-sutherland");
    let from = place(&window, "P1").center();
    drag(&mut window, from, from + vec2(20.0, -30.0));
    assert!(window.state().app().modified());
    window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.run();
    assert!(!window.state().app().modified());
}

#[test]
fn work_survives_a_kill() {
    let mut before = window_with("cohen-sutherland");
    let from = place(&before, "P1").center();
    drag(&mut before, from, from + vec2(20.0, -30.0));
    before.key_press(Key::ArrowLeft);
    before.run();
    wait(&mut before);
    let (input, step) = (before.state().app().document.input().clone(), cursor(&before));
    let mut after = window_on(1280.0, 720.0, killed(before));
    assert_eq!(after.state().app().document.input(), &input);
    assert_eq!(notice(&after), Some(Notice::Back));
    assert!(after.state().app().modified());
    assert!(cursor(&after) == step || cursor(&after) == len(&after));
    click(&mut after, "Discard");
    assert_ne!(after.state().app().document.input(), &input);
    assert!(!after.state().app().modified());
}

#[test]
fn work_is_kept_seldom_and_only_when_it_changed() {
    let mut window = window_with("cohen-sutherland");
    wait(&mut window);
    let before = window.state().platform.writes;
    wait(&mut window);
    assert_eq!(window.state().platform.writes, before, "nothing changed");
    for i in 0..120 {
        let app = window.state_mut().app_mut();
        if let LabInput::ClipLine(input) = app.document.input_mut() {
            input.segment[0] = i as f32 / 100.0;
        }
        window.step();
    }
    wait(&mut window);
    let writes = window.state().platform.writes - before;
    assert!((1..=3).contains(&writes), "{writes} times in some four seconds");
}

#[test]
fn a_file_at_the_start_sets_unsaved_work_aside() {
    let mut before = window(1280.0, 720.0);
    edit(&mut before);
    wait(&mut before);
    let mut platform = killed(before);
    platform.files.insert("a.obj".into(), b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec());
    let mut after = window_on(1280.0, 720.0, platform);
    let ctx = after.ctx.clone();
    let Desk { app, platform } = after.state_mut();
    let mut fresh = App::new(&ctx);
    fresh.start(&ctx, Some("a.obj"), platform);
    *app = Some(fresh);
    after.run();
    assert_eq!(notice(&after), Some(Notice::Aside));
    assert_ne!(depth(&after), 0.25);
    click(&mut after, "Bring it back");
    assert_eq!(depth(&after), 0.25);
    assert!(after.state().app().modified());
}

#[test]
fn settings_and_the_last_file_are_there_again() {
    let mut before = window(1280.0, 720.0);
    let bytes = before.state().app().document.scene.to_json().into_bytes();
    before.state_mut().platform.files.insert("mine.json".into(), bytes);
    ask(&mut before, Command::Open("mine.json".into()));
    ask(&mut before, Command::Theme(rasterscope_figure::theme::ThemeName::Light));
    ask(&mut before, Command::Bigger);
    wait(&mut before);
    let after = window_on(1280.0, 720.0, killed(before));
    let app = after.state().app();
    assert_eq!(app.view.theme.name(), "light");
    assert_eq!((app.path.as_deref(), app.modified(), notice(&after)), (Some("mine.json"), false, None));
    assert_eq!(after.ctx.zoom_factor(), 1.25);
}

#[test]
fn a_full_disk_is_said_once() {
    let mut window = window(1280.0, 720.0);
    window.state_mut().platform.full = true;
    edit(&mut window);
    wait(&mut window);
    assert!(matches!(notice(&window), Some(Notice::Failed(text)) if text.contains("the disk is full")));
    click(&mut window, "Dismiss");
    window.state_mut().app_mut().document.scene.clear.depth = 0.5;
    wait(&mut window);
    assert_eq!(notice(&window), None);
}

#[test]
fn work_whose_model_is_gone_is_set_aside() {
    let mut before = window(1280.0, 720.0);
    let model = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec();
    before.state_mut().platform.files.insert("a.obj".into(), model.clone());
    ask(&mut before, Command::Open("a.obj".into()));
    edit(&mut before);
    wait(&mut before);
    let mut platform = killed(before);
    platform.files.clear();
    let mut without = window_on(1280.0, 720.0, platform);
    assert!(matches!(notice(&without), Some(Notice::Failed(text)) if text.contains("a.obj")));
    wait(&mut without);
    let mut platform = killed(without);
    platform.files.insert("a.obj".into(), model);
    let mut after = window_on(1280.0, 720.0, platform);
    assert_eq!(notice(&after), Some(Notice::Aside), "nothing has written over it");
    click(&mut after, "Bring it back");
    assert_eq!(depth(&after), 0.25);
}
