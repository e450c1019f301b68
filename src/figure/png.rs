//! A figure as pixels: PNG through tiny-skia, text included.
//!
//! The same figure gives the same bytes on every machine: nothing is read from the system, not even
//! a font.

use tiny_skia::{
    FillRule, FilterQuality, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, PixmapPaint, PixmapRef,
    StrokeDash, Transform,
};

use crate::{
    figure::{Figure, Shape, Stroke},
    text::{self, Outline},
    theme::Color,
};

/// More pixels than this on a side are not drawn; the scale shrinks instead.
const LARGEST: f32 = 16_384.0;

/// The figure as a PNG file, `pixels_per_point` times its size.
pub fn png(figure: &Figure, pixels_per_point: f32) -> Vec<u8> {
    encode(&pixmap(figure, pixels_per_point))
}

/// An opaque pixmap as a PNG file.
pub(crate) fn encode(pixmap: &Pixmap) -> Vec<u8> {
    // Encoding into memory cannot fail: the size is that of the data.
    pixmap.encode_png().unwrap_or_default()
}

/// The figure as pixels, premultiplied RGBA8; every pixel is opaque.
///
/// A scale that is not positive counts as 1; one that would make a side longer than 16 384 pixels
/// is reduced.
pub fn pixmap(figure: &Figure, pixels_per_point: f32) -> Pixmap {
    let largest = LARGEST / figure.size[0].max(figure.size[1]).max(1.0);
    let scale = if pixels_per_point > 0.0 { pixels_per_point } else { 1.0 }.min(largest);
    let [width, height] = figure.size.map(|extent| (extent * scale).round().clamp(1.0, LARGEST) as u32);
    let mut pixmap = Pixmap::new(width, height).expect("both sides are from 1 to 16384");
    pixmap.fill(color(figure.background));
    let transform = Transform::from_scale(scale, scale);
    for shape in &figure.shapes {
        paint(&mut pixmap, shape, transform);
    }
    pixmap
}

fn paint(pixmap: &mut Pixmap, shape: &Shape, transform: Transform) {
    match shape {
        Shape::Fill { points, color } => {
            if let Some(path) = polyline(points, true) {
                fill(pixmap, &path, *color, FillRule::EvenOdd, transform);
            }
        }
        Shape::Line { points, closed, stroke } => {
            if let Some(path) = polyline(points, *closed) {
                line(pixmap, &path, *stroke, transform);
            }
        }
        Shape::Circle { center, radius, fill: inside, stroke } => {
            if let Some(path) = PathBuilder::from_circle(center[0], center[1], *radius) {
                area(pixmap, &path, *inside, *stroke, transform);
            }
        }
        Shape::Rect { min, max, radius, fill: inside, stroke } => {
            if let Some(path) = rectangle(*min, *max, *radius) {
                area(pixmap, &path, *inside, *stroke, transform);
            }
        }
        Shape::Text { at, align, text, font, size, color } => {
            let laid_out = text::layout(*font, *size, text);
            let [left, top] = text::corner(*at, *align, [laid_out.width, laid_out.height]);
            for glyph in laid_out.glyphs {
                if let Some(path) = glyph_path(&text::outline(glyph.font, glyph.id)) {
                    let units = size / text::units_per_em(glyph.font);
                    let place =
                        Transform::from_row(units, 0.0, 0.0, -units, left + glyph.x, top + laid_out.ascent);
                    fill(pixmap, &path, *color, FillRule::Winding, place.post_concat(transform));
                }
            }
        }
        Shape::Image { min, max, size, rgba } => image(pixmap, [*min, *max], *size, rgba, transform),
        Shape::Inset { at, figure } => {
            let drawing = self::pixmap(figure, transform.sx);
            let [x, y] = at.map(|c| (c * transform.sx).round() as i32);
            let paint = PixmapPaint::default();
            pixmap.draw_pixmap(x, y, drawing.as_ref(), &paint, Transform::identity(), None);
        }
    }
}

fn color(color: Color) -> tiny_skia::Color {
    let [red, green, blue, alpha] = color.0;
    tiny_skia::Color::from_rgba8(red, green, blue, alpha)
}

fn solid(color_: Color) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color(color(color_));
    paint
}

fn fill(pixmap: &mut Pixmap, path: &Path, color: Color, rule: FillRule, transform: Transform) {
    pixmap.fill_path(path, &solid(color), rule, transform, None);
}

fn line(pixmap: &mut Pixmap, path: &Path, stroke: Stroke, transform: Transform) {
    let dash =
        if stroke.dash.is_empty() { None } else { StrokeDash::new(stroke.dash.to_vec(), stroke.phase) };
    let stroke_style = tiny_skia::Stroke {
        width: stroke.width,
        line_cap: LineCap::Butt,
        line_join: LineJoin::Miter,
        dash,
        ..Default::default()
    };
    pixmap.stroke_path(path, &solid(stroke.color), &stroke_style, transform, None);
}

fn area(
    pixmap: &mut Pixmap,
    path: &Path,
    inside: Option<Color>,
    stroke: Option<Stroke>,
    transform: Transform,
) {
    if let Some(color) = inside {
        fill(pixmap, path, color, FillRule::Winding, transform);
    }
    if let Some(stroke) = stroke {
        line(pixmap, path, stroke, transform);
    }
}

fn polyline(points: &[[f32; 2]], closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    for (i, &[x, y]) in points.iter().enumerate() {
        if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
    }
    if closed {
        path.close();
    }
    path.finish()
}

fn rectangle([left, top]: [f32; 2], [right, bottom]: [f32; 2], radius: f32) -> Option<Path> {
    let r = radius.min((right - left) / 2.0).min((bottom - top) / 2.0).max(0.0);
    if r == 0.0 {
        return polyline(&[[left, top], [right, top], [right, bottom], [left, bottom]], true);
    }
    // A quarter of a circle as one cubic curve: its control points lie 0.5523 radii from its ends.
    let c = r * (1.0 - 0.552_284_8);
    let mut path = PathBuilder::new();
    path.move_to(left + r, top);
    path.line_to(right - r, top);
    path.cubic_to(right - c, top, right, top + c, right, top + r);
    path.line_to(right, bottom - r);
    path.cubic_to(right, bottom - c, right - c, bottom, right - r, bottom);
    path.line_to(left + r, bottom);
    path.cubic_to(left + c, bottom, left, bottom - c, left, bottom - r);
    path.line_to(left, top + r);
    path.cubic_to(left, top + c, left + c, top, left + r, top);
    path.close();
    path.finish()
}

fn glyph_path(outline: &[Outline]) -> Option<Path> {
    let mut path = PathBuilder::new();
    for piece in outline {
        match *piece {
            Outline::Move([x, y]) => path.move_to(x, y),
            Outline::Line([x, y]) => path.line_to(x, y),
            Outline::Quad([cx, cy], [x, y]) => path.quad_to(cx, cy, x, y),
            Outline::Cubic([ax, ay], [bx, by], [x, y]) => path.cubic_to(ax, ay, bx, by, x, y),
            Outline::Close => path.close(),
        }
    }
    path.finish()
}

fn image(
    pixmap: &mut Pixmap,
    [min, max]: [[f32; 2]; 2],
    size: [usize; 2],
    rgba: &[u8],
    transform: Transform,
) {
    let premultiplied = premultiplied(rgba);
    let [columns, rows] = size.map(|n| u32::try_from(n).unwrap_or(0));
    if let Some(source) = PixmapRef::from_bytes(&premultiplied, columns, rows) {
        let [x, y] = [0, 1].map(|axis| (max[axis] - min[axis]) / size[axis] as f32);
        let place = Transform::from_row(x, 0.0, 0.0, y, min[0], min[1]).post_concat(transform);
        let paint = PixmapPaint { quality: FilterQuality::Nearest, ..Default::default() };
        pixmap.draw_pixmap(0, 0, source, &paint, place, None);
    }
}

/// Colours times alpha, as tiny-skia stores them.
fn premultiplied(rgba: &[u8]) -> Vec<u8> {
    let mut out = rgba.to_vec();
    for pixel in out.chunks_exact_mut(4) {
        let alpha = u32::from(pixel[3]);
        for channel in &mut pixel[..3] {
            *channel = ((u32::from(*channel) * alpha + 127) / 255) as u8;
        }
    }
    out
}

/// RGBA8 with straight alpha as a PNG file; empty if the sizes do not match.
pub fn rgba_png(size: [usize; 2], rgba: &[u8]) -> Vec<u8> {
    let [Ok(columns), Ok(rows)] = size.map(u32::try_from) else { return Vec::new() };
    let mut out = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut out, columns, rows);
    encoder.set_color(::png::ColorType::Rgba);
    encoder.set_depth(::png::BitDepth::Eight);
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(rgba));
    if written.is_err() {
        out.clear();
    }
    out
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::figure::{Align, Font};

    const RED: Color = Color::hex(0xFF0000);
    const WHITE: Color = Color::hex(0xFFFFFF);

    fn figure(shapes: Vec<Shape>) -> Figure {
        Figure { size: [20.0, 10.0], background: WHITE, shapes }
    }

    fn is_red(pixmap: &Pixmap, x: u32, y: u32) -> bool {
        let pixel = pixmap.pixel(x, y).unwrap();
        (pixel.red(), pixel.green(), pixel.blue(), pixel.alpha()) == (255, 0, 0, 255)
    }

    #[test]
    fn a_concave_fill_leaves_its_notch_free() {
        let points = vec![[0.0, 0.0], [20.0, 0.0], [20.0, 10.0], [10.0, 2.0], [0.0, 10.0]];
        let pixmap = pixmap(&figure(vec![Shape::Fill { points, color: RED }]), 1.0);
        assert!(is_red(&pixmap, 2, 4) && is_red(&pixmap, 17, 4));
        assert!(!is_red(&pixmap, 10, 8));
    }

    #[test]
    fn image_pixels_are_sharp_at_every_scale() {
        let rgba = Arc::new(vec![255, 0, 0, 255, 255, 255, 255, 255]);
        let shape = Shape::Image { min: [0.0, 0.0], max: [20.0, 10.0], size: [2, 1], rgba };
        for scale in [1.0, 2.0] {
            let pixmap = pixmap(&figure(vec![shape.clone()]), scale);
            let border = (10.0 * scale) as u32;
            assert!(is_red(&pixmap, border - 1, 3) && !is_red(&pixmap, border, 3));
        }
    }

    #[test]
    fn the_bytes_are_the_same_every_time_and_text_is_in_them() {
        let text = Shape::Text {
            at: [10.0, 5.0],
            align: [Align::Center, Align::Center],
            text: "⌈x⌉".to_owned(),
            font: Font::SansBold,
            size: 9.0,
            color: RED,
        };
        let with = png(&figure(vec![text.clone()]), 1.5);
        assert_eq!(with, png(&figure(vec![text]), 1.5));
        assert_ne!(with, png(&figure(vec![]), 1.5));
        assert!(with.starts_with(b"\x89PNG"));
    }

    #[test]
    fn absurd_scales_give_a_picture_all_the_same() {
        assert_eq!(pixmap(&figure(vec![]), f32::NAN).width(), 20);
        assert_eq!(pixmap(&figure(vec![]), 1e-9).width(), 1);
        assert!(pixmap(&Figure { size: [16_000.0, 1.0], ..figure(vec![]) }, 1e9).width() <= 16_384);
    }

    #[test]
    fn pictures_of_the_wrong_length_are_empty_files() {
        assert!(rgba_png([2, 2], &[0; 3]).is_empty());
        assert!(rgba_png([1, 1], &[0; 4]).starts_with(b"\x89PNG"));
    }
}
