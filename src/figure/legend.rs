//! The legend at the foot of a drawing: what its signs mean, in one line.

use rasterscope_core::explain::{Mark, Sign};

use crate::{
    canvas::{Canvas, Layer, TextStyle, narrow},
    figure::{Font, Stroke},
    geometry::Rect,
    markers,
};

/// Width of a sign, and the room behind it and behind an entry.
const MARKER: f64 = 14.0;
const LINE: f64 = 30.0;
const GAP: f64 = 7.0;
const APART: f64 = 22.0;
/// The middle of the legend is so far from the foot.
const FOOT: f64 = 15.0;

/// Keeps the foot clear of labels if there will be a legend: in the window it is the readout's, too.
pub(crate) fn reserve(canvas: &mut Canvas<'_>, marks: &[Mark]) {
    if marks.iter().any(|mark| matches!(mark, Mark::Key { .. })) {
        let Rect { min, max } = canvas.rect;
        canvas.kept_clear.push(Rect { min: [min[0], max[1] - 2.0 * FOOT], max });
    }
}

/// Draws the entries of the legend, as many as fit in one line.
pub(crate) fn draw(canvas: &mut Canvas<'_>, marks: &[Mark]) {
    let theme = canvas.theme;
    let size = theme.sizes.label;
    let mut left = canvas.frame.min[0].max(12.0);
    let y = canvas.rect.max[1] - FOOT;
    for mark in marks {
        let Mark::Key { role, sign, meaning } = mark else { continue };
        let text = canvas.words.message(meaning);
        let style = TextStyle { text: &text, font: Font::Sans, size, color: theme.text };
        let [width, height] = style.measure();
        let wide = if *sign == Sign::Line { LINE } else { MARKER };
        let end = left + wide + GAP + width;
        if end > canvas.rect.max[0] - 8.0 {
            return;
        }
        let ground =
            Rect { min: [left - 4.0, y - height / 2.0 - 3.0], max: [end + 4.0, y + height / 2.0 + 3.0] };
        canvas.ground(ground);
        let look = theme.style(*role);
        match sign {
            Sign::Marker => {
                let at = narrow([left + MARKER / 2.0, y]);
                let radius = 6.5 + theme.extra_stroke;
                canvas
                    .extend(Layer::Text, markers::marker(look.marker, at, radius, look.color, theme.canvas));
            }
            Sign::Line => {
                let ends = [[left, y], [left + LINE, y]];
                if let Some((color, width)) = look.underlay {
                    canvas.line(Layer::Text, &ends, false, Stroke::solid(color, width));
                }
                let stroke = Stroke { color: look.color, width: look.width, dash: look.dash, phase: 0.0 };
                canvas.line(Layer::Text, &ends, false, stroke);
            }
        }
        canvas.text(Layer::Text, [left + wide + GAP + width / 2.0, y], style);
        left = end + APART;
    }
}
