//! What lies on the image: chosen by menu, key and palette, computed once, and kept.

use super::*;
use crate::document::Scenery;
use egui::{Key, Modifiers};
use rasterscope_core::{
    explain::Mark,
    message::Value,
    pipeline::{Overlay, Skip},
    raster::FillRule,
};
use rasterscope_figure::words::Words;

fn marks(window: &mut Window) -> Vec<Mark> {
    let app = window.state_mut().app_mut();
    let picture = app.overview.picture(&mut app.view).expect("there is a picture");
    picture.marks.clone()
}

/// What the legend says.
fn legend(window: &mut Window) -> String {
    let words = Words::default();
    let said = marks(window).into_iter().find_map(|mark| match mark {
        Mark::Key { meaning, .. } | Mark::Ramp { meaning, .. } => Some(words.message(&meaning)),
        _ => None,
    });
    said.unwrap_or_default()
}

fn press(window: &mut Window, key: Key) {
    window.key_press(key);
    window.run();
}

#[test]
fn each_overlay_has_a_key() {
    let mut window = window(1280.0, 720.0);
    let keys =
        [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8, Key::Num0];
    let overlays = Overlay::ALL.into_iter().skip(1).chain([Overlay::None]);
    for (key, overlay) in keys.into_iter().zip(overlays) {
        press(&mut window, key);
        assert_eq!(window.state().app().view.overlay, overlay);
    }
    assert!(legend(&mut window).is_empty(), "nothing lies on the image");
}

#[test]
fn the_menu_and_the_palette_have_them_all() {
    let mut window = window(1280.0, 720.0);
    click(&mut window, "On the image: nothing");
    click(&mut window, "3  fragments got");
    assert_eq!(window.state().app().view.overlay, Overlay::Generated);
    window.key_press_modifiers(Modifiers::COMMAND, Key::K);
    window.run();
    for overlay in Overlay::ALL {
        let app = window.state().app();
        let name = format!("On the image: {}", app.words.word(overlay.word()));
        window.state_mut().app_mut().view.palette.as_mut().expect("it is open").typed = name.clone();
        window.run();
        window.get_all_by_label(&name).next().expect("it is in the palette");
    }
}

#[test]
fn a_field_is_one_texture_with_numbers_and_a_legend() {
    let mut window = window(1280.0, 720.0);
    press(&mut window, Key::Num3);
    let all = marks(&mut window);
    assert_eq!(all.iter().filter(|mark| matches!(mark, Mark::Image { .. })).count(), 1);
    assert!(all.iter().any(|mark| matches!(mark, Mark::Numbers(_))));
    assert_eq!(legend(&mut window), "fragments that the pixel got");
    let made = window.state().app().textures.made();
    // Choosing a pixel moves a mark, and no texture.
    window.state_mut().app_mut().view.pixel = Some([3, 3]);
    window.run();
    assert_eq!(window.state().app().textures.made(), made);
    press(&mut window, Key::Num4);
    assert_eq!(window.state().app().textures.made(), made + 1);
}

#[test]
fn a_skip_changes_no_pixel_and_the_fill_rule_does() {
    let mut window = window(1280.0, 720.0);
    window.state_mut().app_mut().open_preset("acceptance-square");
    press(&mut window, Key::Num7);
    assert!(legend(&mut window).starts_with("Nothing was edited yet"), "{}", legend(&mut window));
    let skips = window.state().app().view.skips.with(Skip::BackFace, false);
    window.state_mut().app_mut().view.skips = skips;
    window.run();
    assert!(legend(&mut window).starts_with("No pixel differs"), "{}", legend(&mut window));
    window.state_mut().app_mut().document.scene.fill_rule = FillRule::Inclusive;
    window.run();
    let outlined = |mark: &&Mark| matches!(mark, Mark::Pixel { .. });
    let changed = marks(&mut window).iter().filter(outlined).count();
    assert_eq!(changed, 13, "the right column and the lower row are drawn, too");
    assert!(legend(&mut window).starts_with("13 pixels differ from before the last edit: 13 in colour"));
}

#[test]
fn a_drag_is_one_edit() {
    let mut window = window(1280.0, 720.0);
    press(&mut window, Key::Num7);
    let first = window.state().app().document.scene.clone();
    let at = place(&window, "A0");
    drag(&mut window, at.center(), at.center() + vec2(60.0, -40.0));
    assert_ne!(window.state().app().document.scene, first);
    let (before, _) = window.state().app().overview.before().expect("it was edited");
    assert!(before.same_picture(&first), "all of the drag counts");
}

#[test]
fn the_triangle_under_the_pointer_is_named() {
    let mut window = window(1280.0, 720.0);
    press(&mut window, Key::Num6);
    let app = window.state_mut().app_mut();
    let hover = app.overview.hover([13, 11], &Words::default()).expect("it is in the image");
    assert!(hover.text.contains("triangle 1 of 1 in A"), "{}", hover.text);
    assert!(hover.text.contains("fragments written"), "{}", hover.text);
    let (corners, name) = hover.triangle.clone().expect("a triangle is seen there");
    assert_eq!((corners.len() >= 3, name.as_str()), (true, "A"));
    let nothing = app.overview.hover([0, 0], &Words::default()).expect("it is in the image");
    assert!(nothing.triangle.is_none());
}

#[test]
fn an_overlay_is_kept_and_not_undone() {
    let mut window = window(1280.0, 720.0);
    press(&mut window, Key::Num1);
    assert!(!window.state().app().history.can_undo());
    let settings = crate::session::Settings::of(&window.state().app().view, 1.0);
    let mut view = crate::document::ViewState::default();
    settings.apply(&mut view);
    assert_eq!(view.overlay, Overlay::Depth);
}

#[test]
fn a_large_scene_is_counted_beside_the_window() {
    let mut window = window_on(1280.0, 720.0, Memory { lazy: true, ..Memory::default() });
    window.state_mut().app_mut().document.scene.size = [1600, 1200];
    window.run_steps(2);
    window.state_mut().platform.work();
    window.run_steps(2);
    press_now(&mut window, Key::Num4);
    assert_eq!(window.state().platform.waiting.len(), 1, "counting waits beside the window");
    assert!(legend(&mut window).is_empty());
    window.state_mut().platform.work();
    window.run_steps(2);
    assert_eq!(legend(&mut window), "fragments that were written to the pixel");
    assert_eq!(window.state().app().view.scenery, Scenery::Image);
    let value = marks(&mut window).into_iter().find_map(|mark| match mark {
        Mark::Ramp { ends, .. } => Some(ends),
        _ => None,
    });
    assert_eq!(value.map(|[weakest, _]| weakest), Some(Value::Int(1)));
}

fn press_now(window: &mut Window, key: Key) {
    window.key_press(key);
    window.run_steps(2);
}
