//! Nothing is cut off: in the sizes and themes in which a hall sees the window.

use super::*;
use egui::{Key, Shape};
use rasterscope_core::{
    explain::{Mark, Role},
    labs,
};
use rasterscope_figure::theme::ThemeName;

const SIZES: [[f32; 2]; 2] = [[1280.0, 720.0], [1024.0, 768.0]];

fn window_in(size: [f32; 2], theme: ThemeName) -> Window {
    let mut window = window(size[0], size[1]);
    let ctx = window.ctx.clone();
    window.state_mut().app_mut().wear(&ctx, theme);
    window.run();
    window
}

fn press(window: &mut Window, key: Key) {
    window.key_press(key);
    window.run();
}

#[test]
fn all_keys_and_the_button_that_closes_them_are_in_the_window() {
    for (size, theme) in SIZES.into_iter().flat_map(|size| ThemeName::ALL.map(|theme| (size, theme))) {
        let mut window = window_in(size, theme);
        press(&mut window, Key::F1);
        let whole = window.ctx.content_rect();
        for label in ["Choose the next pixel", "Hold while dragging: no snapping", "Close"] {
            let place = place(&window, label);
            assert!(whole.contains_rect(place), "{label}: {place} in {size:?}, {theme:?}");
        }
        click(&mut window, "Close");
        assert!(window.query_by_label("Close").is_none());
    }
}

/// The lit line of the listing, as far as a step has one.
fn lit(window: &Window) -> Option<Rect> {
    let shown = window.state().app().run.shown().expect("something runs");
    let line = shown.line?;
    let name = format!("{}: {}", line + 1, shown.listing[line].trim_start());
    Some(place(window, &name))
}

#[test]
fn the_lit_line_and_the_sentence_are_in_sight_after_every_step() {
    for (preset, size, theme) in [
        ("line-three-cuts", SIZES[0], ThemeName::Projector),
        ("line-three-cuts", SIZES[1], ThemeName::Projector),
        ("span-left-tie", SIZES[0], ThemeName::Light),
    ] {
        let mut window = window_in(size, theme);
        window.state_mut().app_mut().open_preset(preset);
        window.run();
        press(&mut window, Key::Home);
        let foot = place(&window, "To the start").top() - 8.0;
        for step in 0..len(&window).min(24) {
            press(&mut window, Key::ArrowRight);
            let Some(line) = lit(&window) else { continue };
            assert!(line.bottom() <= foot, "{preset}, step {step}: {line} above {foot}");
            assert!(line.top() >= place(&window, "Step").bottom(), "{preset}, step {step}: {line}");
        }
    }
}

#[test]
fn between_steps_the_listing_is_the_users_to_scroll() {
    let mut window = window_in(SIZES[0], ThemeName::Projector);
    window.state_mut().app_mut().open_preset("line-three-cuts");
    window.run();
    press(&mut window, Key::Home);
    (0..6).for_each(|_| press(&mut window, Key::ArrowRight));
    let before = lit(&window).expect("a line is lit");
    window.hover_at(before.center());
    window.run();
    window.event(egui::Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: vec2(0.0, 60.0),
        phase: egui::TouchPhase::Move,
        modifiers: Default::default(),
        source: egui::MouseWheelSource::Unknown,
    });
    window.run();
    let scrolled = lit(&window).expect("it is still lit");
    assert!(scrolled.top() > before.top() + 20.0, "{scrolled}, {before}");
    window.run_steps(10);
    assert_eq!(lit(&window), Some(scrolled), "and stays there");
}

/// The texts above a height that are cut with an ellipsis.
fn cut(window: &Window, bottom: f32) -> Vec<String> {
    fn look(shape: &Shape, bottom: f32, out: &mut Vec<String>) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| look(shape, bottom, out)),
            Shape::Text(text) if text.pos.y < bottom && text.galley.elided => {
                out.push(text.galley.text().to_owned());
            }
            _ => {}
        }
    }
    let mut out = Vec::new();
    window.output().shapes.iter().for_each(|clipped| look(&clipped.shape, bottom, &mut out));
    out
}

#[test]
fn a_number_in_the_ribbon_is_never_cut() {
    for theme in ThemeName::ALL {
        for preset in ["tilt-floor", "frustum-straddles", "shade-mach-band"] {
            let mut window = window_in(SIZES[0], theme);
            window.state_mut().app_mut().open_preset(preset);
            window.run();
            let numbers: Vec<_> =
                cut(&window, 80.0).into_iter().filter(|text| text.contains(char::is_numeric)).collect();
            assert_eq!(numbers, [""; 0], "{preset}, {theme:?}");
        }
    }
}

#[test]
fn what_is_not_covered_is_black_and_each_marker_is_in_the_legend() {
    let mut window = window_with("msaa");
    press(&mut window, Key::Home);
    for step in 0..len(&window) {
        let shown = window.state().app().run.shown().expect("it runs");
        let has = |role: Role| {
            let point = |mark: &Mark| matches!(mark, Mark::Point { role: it, .. } if *it == role);
            let key = |mark: &Mark| matches!(mark, Mark::Key { role: it, .. } if *it == role);
            [shown.marks.iter().any(point), shown.marks.iter().any(key)]
        };
        for role in [Role::Accepted, Role::Rejected, Role::Candidate] {
            let [drawn, named] = has(role);
            assert!(named || !drawn, "{role:?} at {step}");
        }
        let [drawn, named] = has(Role::Rejected);
        assert_eq!(drawn, named, "a cross at {step}");
        let clear = |mark: &Mark| match mark {
            Mark::Image { rgba, .. } => rgba.chunks_exact(4).any(|pixel| pixel[3] != 255),
            _ => false,
        };
        assert!(!shown.marks.iter().any(clear), "the canvas shows through at {step}");
        press(&mut window, Key::ArrowRight);
    }
    assert!(labs::ALL.iter().any(|lab| lab.name == "msaa"));
}

#[test]
fn a_drawing_in_space_ends_above_the_line_at_the_foot() {
    for preset in ["tree-of-eight", "plane-two-in", "frustum-straddles"] {
        let mut window = window_in(SIZES[0], ThemeName::Projector);
        window.state_mut().app_mut().open_preset(preset);
        window.run();
        let app = window.state().app();
        let size = app.canvas.size().expect("it is drawn");
        let placement = app.canvas.placement().expect("it is placed");
        let [_, foot] = placement.to_points([0.0, -1.0]);
        assert!(foot <= size.y - 36.0, "{preset}: {foot} of {}", size.y);
    }
}

#[test]
fn every_claim_is_in_sight() {
    for (size, theme) in SIZES.into_iter().flat_map(|size| ThemeName::ALL.map(|theme| (size, theme))) {
        let mut window = window_in(size, theme);
        let last = rasterscope_measure::claims::CLAIMS.len() - 1;
        click(&mut window, "Measure");
        window.get_by_label_contains("Claims of the lectures").click();
        window.run();
        let app = window.state().app();
        let claim = rasterscope_measure::claims::CLAIMS[last].name;
        let row = place(&window, &app.words.word(&format!("bench-claim-{claim}")));
        let below = place(&window, &app.words.word("measure-start-all"));
        assert!(row.bottom() <= below.top(), "{row} above {below} in {size:?}, {theme:?}");
    }
}
