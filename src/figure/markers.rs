//! Markers as shapes: never glyphs, so that they are alike in every font and file.

use crate::{
    figure::{Shape, Stroke},
    theme::{Color, Marker, Theme, ThemeName},
};

/// The shapes of `marker` at a point, `radius` points large, in `color`; gaps show `ground`.
///
/// For lists, timelines and the corners of cells; [`point`] draws those of the canvas.
pub fn marker(marker: Marker, at: [f32; 2], radius: f32, color: Color, ground: Color) -> Vec<Shape> {
    let [x, y] = at;
    let r = radius;
    let thin = (r * 0.3).max(1.5);
    let line = |points: Vec<[f32; 2]>, color, width| Shape::Line {
        points,
        closed: false,
        stroke: Stroke::solid(color, width),
    };
    let outline = |points: Vec<[f32; 2]>, width| Shape::Line {
        points,
        closed: true,
        stroke: Stroke::solid(color, width),
    };
    match marker {
        Marker::RingedDot => vec![disc(at, r, color), disc(at, r * 0.72, ground), disc(at, r * 0.42, color)],
        Marker::DiscTick => {
            let tick =
                vec![[x - 0.45 * r, y + 0.05 * r], [x - 0.1 * r, y + 0.4 * r], [x + 0.5 * r, y - 0.35 * r]];
            vec![disc(at, r, color), line(tick, ground, (r * 0.26).max(1.3))]
        }
        Marker::Cross => {
            let (r, thick) = (r * 0.86, thin * 1.2);
            vec![
                line(vec![[x - r, y - r], [x + r, y + r]], color, thick),
                line(vec![[x - r, y + r], [x + r, y - r]], color, thick),
            ]
        }
        Marker::Ring => vec![ring(at, r - thin / 2.0, color, thin)],
        Marker::TriangleUp => vec![Shape::Fill {
            points: vec![[x, y - 0.9 * r], [x + r, y + 0.8 * r], [x - r, y + 0.8 * r]],
            color,
        }],
        Marker::Diamond => {
            vec![Shape::Fill { points: vec![[x, y - r], [x + r, y], [x, y + r], [x - r, y]], color }]
        }
        Marker::Bar => vec![line(vec![[x - r, y], [x + r, y]], color, thin)],
        Marker::Square => vec![Shape::Rect {
            min: [x - 0.85 * r, y - 0.85 * r],
            max: [x + 0.85 * r, y + 0.85 * r],
            radius: 0.0,
            fill: Some(color),
            stroke: None,
        }],
        Marker::TriangleDown => {
            vec![outline(
                vec![[x, y + 0.8 * r], [x + 0.9 * r, y - 0.7 * r], [x - 0.9 * r, y - 0.7 * r]],
                thin,
            )]
        }
        Marker::Handle => vec![ring(at, r - thin / 2.0, color, thin), disc(at, r * 0.36, color)],
    }
}

/// A point of the canvas: its marker over a gap in the canvas colour.
pub(crate) fn point(marker_shape: Marker, at: [f32; 2], color: Color, theme: &Theme) -> Vec<Shape> {
    let grown = theme.extra_stroke;
    match marker_shape {
        Marker::RingedDot if theme.name == ThemeName::Dark => {
            let gap = disc(at, 13.0, theme.canvas);
            vec![gap, disc(at, 12.0, color), disc(at, 9.2, theme.canvas), disc(at, 5.0, color)]
        }
        Marker::RingedDot => vec![
            Shape::Circle {
                center: at,
                radius: 11.0 + grown,
                fill: Some(theme.lit),
                stroke: Some(Stroke::solid(color, 2.0 + grown)),
            },
            disc(at, 4.5 + grown, color),
        ],
        Marker::Handle => vec![
            Shape::Circle {
                center: at,
                radius: 7.0 + grown,
                fill: Some(theme.canvas),
                stroke: Some(Stroke::solid(color, 2.5 + grown)),
            },
            disc(at, 2.5 + grown, color),
        ],
        Marker::DiscTick => vec![disc(at, 7.0 + grown, theme.canvas), disc(at, 5.0 + grown, color)],
        other => {
            let mut shapes = vec![disc(at, 8.5 + grown, theme.canvas.alpha(0.9))];
            shapes.extend(marker(other, at, 6.5 + grown, color, theme.canvas));
            shapes
        }
    }
}

/// A square handle, as on the sides and corners of a window that can be dragged.
pub fn square_handle(at: [f32; 2], theme: &Theme) -> Shape {
    let half = 5.0 + theme.extra_stroke;
    Shape::Rect {
        min: at.map(|c| c - half),
        max: at.map(|c| c + half),
        radius: 0.0,
        fill: Some(theme.canvas),
        stroke: Some(Stroke::solid(theme.text, 2.0 + theme.extra_stroke)),
    }
}

pub(crate) fn disc(center: [f32; 2], radius: f32, color: Color) -> Shape {
    Shape::Circle { center, radius, fill: Some(color), stroke: None }
}

pub(crate) fn ring(center: [f32; 2], radius: f32, color: Color, width: f32) -> Shape {
    Shape::Circle { center, radius, fill: None, stroke: Some(Stroke::solid(color, width)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        figure::Figure,
        png::pixmap,
        theme::{Color, ThemeName},
    };
    use rasterscope_core::explain::Role;

    const WHITE: Color = Color::hex(0xFFFFFF);
    const BLACK: Color = Color::hex(0x000000);

    /// The pixels of a marker 8 points large, in black and white.
    fn dark_pixels(shape: Marker) -> Vec<usize> {
        let shapes = marker(shape, [12.0, 12.0], 8.0, BLACK, WHITE);
        let figure = Figure { size: [24.0, 24.0], background: WHITE, shapes };
        let pixels = pixmap(&figure, 1.0);
        let dark = pixels.pixels().iter().enumerate().filter(|(_, pixel)| pixel.red() < 128);
        dark.map(|(index, _)| index).collect()
    }

    #[test]
    fn markers_stay_in_their_size_and_differ_without_colour() {
        let markers = Role::ALL.map(|role| ThemeName::Dark.theme().style(role).marker);
        for (i, &a) in markers.iter().enumerate() {
            let pixels = dark_pixels(a);
            assert!(pixels.len() > 20, "{a:?}");
            for &index in &pixels {
                let [x, y] = [index % 24, index / 24];
                assert!((3..21).contains(&x) && (3..21).contains(&y), "{a:?} reaches ({x}, {y})");
            }
            for &b in &markers[i + 1..] {
                let other = dark_pixels(b);
                let differ = pixels.iter().filter(|index| !other.contains(index)).count()
                    + other.iter().filter(|index| !pixels.contains(index)).count();
                assert!(differ >= 12, "{a:?} and {b:?} differ in {differ} pixels");
            }
        }
    }
}
