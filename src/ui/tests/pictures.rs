use super::*;
use egui::Key;
use rasterscope_figure::theme::ThemeName;

fn wear(window: &mut Window, theme: ThemeName) {
    let ctx = window.ctx.clone();
    window.state_mut().app_mut().wear(&ctx, theme);
    window.run();
}

#[test]
fn cohen_sutherland_in_every_theme() {
    for theme in ThemeName::ALL {
        let mut window = window_with("cohen-sutherland");
        wear(&mut window, theme);
        window.key_press(Key::ArrowLeft);
        window.run();
        window.snapshot(format!("cohen-sutherland-{}", theme.name()));
    }
}

#[test]
fn overview_in_every_theme() {
    for theme in ThemeName::ALL {
        let mut window = window(1280.0, 720.0);
        wear(&mut window, theme);
        window.snapshot(format!("overview-{}", theme.name()));
    }
}

#[test]
fn narrow_window_on_a_projector() {
    let mut window = window(1024.0, 768.0);
    wear(&mut window, ThemeName::Projector);
    window.snapshot("narrow-projector");
}
