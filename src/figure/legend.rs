//! The legend at the foot of a drawing: what its signs mean, in one line.

use rasterscope_core::{
    explain::{Mark, Sign, Tone},
    message::{Message, Value},
};

use crate::{
    canvas::{Canvas, Layer, TextStyle, narrow},
    figure::{Font, Stroke},
    geometry::Rect,
    markers, numbers,
};

/// Width of a sign, and the room behind it and behind an entry.
const MARKER: f64 = 14.0;
const LINE: f64 = 30.0;
const GAP: f64 = 7.0;
/// Length of a ramp of shades, and how many are drawn of them.
const RAMP: f64 = 72.0;
const SHADES: usize = 12;
const APART: f64 = 22.0;
/// The middle of the legend is so far from the foot.
const FOOT: f64 = 15.0;

/// Keeps the foot clear of labels if there will be a legend: in the window it is the readout's, too.
pub(crate) fn reserve(canvas: &mut Canvas<'_>, marks: &[Mark]) {
    if marks.iter().any(|mark| matches!(mark, Mark::Key { .. } | Mark::Ramp { .. })) {
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
        if let Mark::Ramp { tone, ends, meaning } = mark {
            left = ramp(canvas, [left, y], *tone, ends, meaning) + APART;
            continue;
        }
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

/// A ramp of shades between its ends, and what they mean; answers where it ends.
fn ramp(
    canvas: &mut Canvas<'_>,
    [mut x, y]: [f64; 2],
    tone: Tone,
    [weak, strong]: &[Value; 2],
    meaning: &Message,
) -> f64 {
    let theme = canvas.theme;
    let size = theme.sizes.label;
    let meaning = canvas.words.message(meaning);
    let ends = [weak, strong].map(numbers::short);
    let styles = [(Font::Mono, &ends[0]), (Font::Mono, &ends[1]), (Font::Sans, &meaning)];
    let styles = styles.map(|(font, text)| TextStyle { text, font, size, color: theme.text });
    let [weak, strong, meaning] = styles.map(|style| style.measure());
    // Equal ends need one number.
    let first = if ends[0] == ends[1] { 0.0 } else { weak[0] + GAP };
    let width = first + RAMP + GAP + strong[0] + 2.0 * GAP + meaning[0];
    let half = meaning[1] / 2.0 + 3.0;
    canvas.ground(Rect { min: [x - 4.0, y - half], max: [x + width + 4.0, y + half] });
    if first > 0.0 {
        canvas.text(Layer::Text, [x + weak[0] / 2.0, y], styles[0]);
        x += first;
    }
    for step in 0..SHADES {
        let part = |step: usize| (x + RAMP * step as f64 / SHADES as f64).round();
        let rect = Rect { min: [part(step), y - 6.0], max: [part(step + 1), y + 6.0] };
        let color = theme.tone(tone, if first > 0.0 { step as f32 / (SHADES - 1) as f32 } else { 1.0 });
        canvas.push(Layer::Text, Canvas::rect_shape(rect, 0.0, Some(color), None));
    }
    let frame = Rect { min: [x, y - 6.0], max: [x + RAMP, y + 6.0] };
    let stroke = Stroke::solid(theme.edge, 1.0);
    canvas.push(Layer::Text, Canvas::rect_shape(frame, 0.0, None, Some(stroke)));
    x += RAMP + GAP;
    canvas.text(Layer::Text, [x + strong[0] / 2.0, y], styles[1]);
    x += strong[0] + 2.0 * GAP;
    canvas.text(Layer::Text, [x + meaning[0] / 2.0, y], styles[2]);
    x + meaning[0]
}
