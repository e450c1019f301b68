//! Bars over names, the bars of one name side by side.

use super::{Plot, Spot, draw::mark, ruler::Ruler};
use crate::{
    figure::{Align, Font, Shape},
    numbers, text,
    theme::Theme,
};

/// How much of the room of a name its bars fill, and the widest bar.
const FILLED: f32 = 0.72;
const WIDEST: f32 = 64.0;

/// Draws each point as a bar with its number and its marker above; the spots are in the bars' middles.
/// Answers what each bar takes with its number.
pub(super) fn draw(
    plot: &Plot,
    [x, up]: [&Ruler; 2],
    theme: &Theme,
    shapes: &mut Vec<Shape>,
    spots: &mut Vec<Spot>,
) -> Vec<[[f32; 2]; 2]> {
    let mut taken = Vec::new();
    let each = (x.room() * FILLED / plot.series.len().max(1) as f32).min(WIDEST);
    let base = up.ends()[0];
    for (i, series) in plot.series.iter().enumerate() {
        let color = theme.style(series.role).color;
        let aside = (i as f32 - (plot.series.len() as f32 - 1.0) / 2.0) * each;
        for (j, point) in series.points.iter().enumerate() {
            let (Some(middle), Some(top)) = (x.at(point.at[0]), up.at(point.at[1])) else { continue };
            let middle = middle + aside;
            let half = each * 0.44;
            shapes.push(Shape::Rect {
                min: [middle - half, top.min(base - 1.0)],
                max: [middle + half, base],
                radius: 0.0,
                fill: Some(color),
                stroke: None,
            });
            let number = numbers::measured(point.at[1]);
            let size = theme.sizes.label;
            let [width, height] = text::measure(Font::Mono, size, &number);
            // A line right through the diagram must not cross the number.
            shapes.push(Shape::Rect {
                min: [middle - width / 2.0 - 2.0, top - height - 2.0],
                max: [middle + width / 2.0 + 2.0, top - 2.0],
                radius: 2.0,
                fill: Some(theme.canvas.alpha(0.9)),
                stroke: None,
            });
            shapes.push(Shape::Text {
                at: [middle, top - 3.0],
                align: [Align::Center, Align::Max],
                text: number,
                font: Font::Mono,
                size,
                color: theme.text,
            });
            if plot.series.len() > 1 {
                shapes.extend(mark(series.role, [middle, top - height - 12.0], theme));
            }
            let half = half.max(width / 2.0 + 2.0);
            taken.push([[middle - half, top - height - 2.0], [middle + half, base]]);
            spots.push(Spot { at: [middle, (top + base) / 2.0], point: [i, j] });
        }
    }
    taken
}
