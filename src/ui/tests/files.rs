use super::*;
use crate::face::Command;
use crate::opening::When;
use crate::shell::notice::Notice;
use rasterscope_core::scene::Scene;

fn open(window: &mut Window, path: &str, bytes: &[u8]) {
    let ctx = window.ctx.clone();
    let desk = window.state_mut();
    desk.platform.files.insert(path.to_owned(), bytes.to_owned());
    let Desk { app, platform } = desk;
    app.as_mut().expect("made").open(&ctx, path, When::Later, platform);
    window.run();
}

fn failure(window: &Window) -> Option<String> {
    match &window.state().app().notice {
        Some(Notice::Failed(text)) => Some(text.clone()),
        _ => None,
    }
}

#[test]
fn a_bad_file_says_what_is_wrong_and_the_document_stays() {
    let cases: [(&str, &[u8]); 7] = [
        ("empty.json", b""),
        ("not.json", b"hello"),
        ("cut.json", b"{\"rasterscope\":1, \"size\":[8"),
        ("nan.json", b"{\"rasterscope\":1,\"size\":[8,8],\"draws\":[{\"vertices\":[[null,0,0]]}]}"),
        ("binary.json", b"\x00\xFF\x13\x37"),
        ("cut.obj", b"v 0 0 0\nv 1 0 0\nf 1 2 9\n"),
        ("binary.obj", b"\x7FELF\x00\x00\xFF"),
    ];
    for (path, bytes) in cases {
        let mut window = window(1280.0, 720.0);
        let before = window.state().app().document.clone();
        open(&mut window, path, bytes);
        let text = failure(&window).unwrap_or_default();
        assert!(text.len() > 10 && !text.contains('⟨'), "{path}: {text:?}");
        assert_eq!(window.state().app().document, before, "{path}");
        click(&mut window, "Dismiss");
        assert_eq!(window.state().app().notice, None);
    }
}

#[test]
fn a_missing_file_is_named() {
    let mut window = window(1280.0, 720.0);
    let ctx = window.ctx.clone();
    let Desk { app, platform } = window.state_mut();
    app.as_mut().expect("made").open(&ctx, "nowhere/scene.json", When::Later, platform);
    window.run();
    assert!(failure(&window).is_some_and(|text| text.contains("nowhere/scene.json")));
}

#[test]
fn what_is_saved_opens_as_it_was() {
    let mut window = window_with("cohen-sutherland");
    click(&mut window, "Step back");
    let (step, scene) = (cursor(&window), window.state().app().document.scene.clone());
    let ctx = window.ctx.clone();
    let Desk { app, platform } = window.state_mut();
    app.as_mut().expect("made").execute(&ctx, vec![Command::SaveAs("a.json".into())], platform);
    let bytes = platform.files["a.json"].clone();
    open(&mut window, "a.json", &bytes);
    let saved = Scene::from_json(&bytes).expect("what was saved can be read");
    assert_eq!(saved.lab.and_then(|lab| lab.step), Some(step));
    assert_eq!(window.state().app().document.scene, scene);
    assert_eq!(cursor(&window), step);
}

#[test]
fn a_failed_save_says_so() {
    let mut window = window_with("cohen-sutherland");
    let ctx = window.ctx.clone();
    let Desk { app, platform } = window.state_mut();
    app.as_mut().expect("made").execute(&ctx, vec![Command::SaveAs("/read-only/a.json".into())], platform);
    window.run();
    assert!(failure(&window).is_some_and(|text| text.contains("/read-only/a.json")));
}

#[test]
fn a_model_opens_in_the_overview() {
    let mut window = window(1280.0, 720.0);
    open(&mut window, "models/one.OBJ", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_eq!(failure(&window), None);
    let app = window.state().app();
    assert_eq!(app.document.scene.draws.len(), 1);
    assert_eq!(app.document.input().name(), "pipeline");
}

#[test]
fn a_product_that_leaves_binary32_is_told_until_it_is_back_in_range() {
    let mut window = window(1280.0, 720.0);
    let said = |window: &Window| match &window.state().app().notice {
        Some(Notice::Beyond(text)) => Some(text.clone()),
        _ => None,
    };
    let stretch = |window: &mut Window, scale: f32| {
        let Desk { app, .. } = window.state_mut();
        let draw = &mut app.as_mut().expect("made").document.scene.draws[1];
        draw.transform = rasterscope_core::scene::Transform::Parts {
            translate: [0.0; 3],
            rotate_degrees: [0.0; 3],
            scale: [scale; 3],
        };
        window.run();
    };
    stretch(&mut window, 3e38);
    assert!(said(&window).is_some_and(|text| text.contains("draws[1]: the vertices of B leave")));
    click(&mut window, "Dismiss");
    window.run();
    assert_eq!(said(&window), None, "it is said once");
    stretch(&mut window, 2e38);
    assert_eq!(said(&window), None);
    stretch(&mut window, 1.0);
    stretch(&mut window, 3e38);
    assert!(said(&window).is_some());
    stretch(&mut window, 1.0);
    assert_eq!(window.state().app().notice, None);
}

#[test]
fn a_full_disk_leaves_the_old_file_and_the_edit() {
    let mut window = window_with("cohen-sutherland");
    let ctx = window.ctx.clone();
    let save = |window: &mut Window| {
        let Desk { app, platform } = window.state_mut();
        app.as_mut().expect("made").execute(&ctx, vec![Command::SaveAs("a.json".into())], platform);
        window.run();
    };
    save(&mut window);
    let old = window.state().platform.files["a.json"].clone();
    window.state_mut().app_mut().document.scene.clear.depth = 0.25;
    window.state_mut().platform.full = true;
    save(&mut window);
    let text = failure(&window).unwrap_or_default();
    assert_eq!(text, "a.json cannot be written: the disk is full. Save under another path.");
    assert!(window.state().app().modified());
    assert_eq!(window.state().platform.files["a.json"], old);
}
