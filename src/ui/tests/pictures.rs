use super::*;
use egui::Key;
use egui_kittest::image_snapshot;
use image::{
    ImageEncoder as _, RgbImage, RgbaImage,
    codecs::png::{CompressionType, FilterType, PngEncoder},
    imageops,
};
use rasterscope_figure::theme::ThemeName;

fn wear(window: &mut Window, theme: ThemeName) {
    let ctx = window.ctx.clone();
    window.state_mut().app_mut().wear(&ctx, theme);
    window.run();
}

/// Compares the window, at half its size and in six levels a channel: enough to see what is
/// missing, cut off or in the wrong colour, in some 30 kB. `UPDATE_SNAPSHOTS=1` accepts.
fn picture(window: &mut Window, name: &str) {
    accept(&smaller(window, 2), name);
}

/// The window at a part of its size, in six levels a channel.
fn smaller(window: &mut Window, part: u32) -> RgbaImage {
    let image = window.render().expect("the CPU painter draws everything");
    let (width, height) = (image.width() / part, image.height() / part);
    let mut image = imageops::resize(&image, width, height, imageops::FilterType::Triangle);
    image.pixels_mut().for_each(|pixel| pixel.0 = pixel.0.map(|code| code.saturating_add(25) / 51 * 51));
    image
}

/// Compares with what was accepted.
fn accept(image: &RgbaImage, name: &str) {
    image_snapshot(image, name);
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        let path = format!("{}/tests/snapshots/{name}.png", env!("CARGO_MANIFEST_DIR"));
        std::fs::write(path, small(image)).expect("the folder of the pictures can be written");
    }
}

/// As few bytes as a PNG can be of these pixels.
fn small(image: &RgbaImage) -> Vec<u8> {
    let rgb = RgbImage::from_fn(image.width(), image.height(), |x, y| {
        let [r, g, b, _] = image.get_pixel(x, y).0;
        image::Rgb([r, g, b])
    });
    let mut bytes = Vec::new();
    PngEncoder::new_with_quality(&mut bytes, CompressionType::Best, FilterType::NoFilter)
        .write_image(&rgb, rgb.width(), rgb.height(), image::ExtendedColorType::Rgb8)
        .expect("writing to memory cannot fail");
    bytes
}

#[test]
fn cohen_sutherland_in_every_theme() {
    let mut window = window_with("cohen-sutherland");
    for _ in 0..6 {
        window.key_press(Key::ArrowLeft);
    }
    window.run();
    for theme in ThemeName::ALL {
        wear(&mut window, theme);
        picture(&mut window, &format!("cohen-sutherland-{}", theme.name()));
    }
}

#[test]
fn overview_in_every_theme() {
    let mut window = window(1280.0, 720.0);
    window.state_mut().app_mut().view.pixel = Some([13, 11]);
    for theme in ThemeName::ALL {
        wear(&mut window, theme);
        picture(&mut window, &format!("overview-{}", theme.name()));
    }
}

#[test]
fn narrow_window_on_a_projector() {
    let mut window = window(1024.0, 768.0);
    window.state_mut().app_mut().open_lab("scanline");
    wear(&mut window, ThemeName::Projector);
    picture(&mut window, "narrow-projector");
}

#[test]
fn split_view_in_every_theme() {
    let mut window = window(1280.0, 720.0);
    window.state_mut().app_mut().open_preset("two-sides-tie");
    for theme in ThemeName::ALL {
        wear(&mut window, theme);
        picture(&mut window, &format!("split-{}", theme.name()));
    }
}

#[test]
fn narrow_split_view_of_two_algorithms() {
    let mut window = window(1024.0, 768.0);
    window.state_mut().app_mut().open_preset("two-sides-corner");
    wear(&mut window, ThemeName::Light);
    picture(&mut window, "split-narrow-light");
}

/// One below the other and a third in size: enough to see what is empty, cut off or in a wrong colour.
#[test]
fn every_lab_in_every_theme() {
    for lab in rasterscope_core::labs::ALL {
        let mut window = window_with(lab.name);
        for _ in 0..4 {
            window.key_press(Key::ArrowLeft);
        }
        window.run();
        let parts = ThemeName::ALL.map(|theme| {
            wear(&mut window, theme);
            smaller(&mut window, 3)
        });
        let (width, height) = parts[0].dimensions();
        let mut sheet = RgbaImage::new(width, height * parts.len() as u32);
        for (part, row) in parts.iter().zip(0_i64..) {
            imageops::replace(&mut sheet, part, 0, row * i64::from(height));
        }
        accept(&sheet, &format!("lab-{}", lab.name));
    }
}
