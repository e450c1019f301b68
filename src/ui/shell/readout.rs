//! What lies under the pointer, in one line at the foot of the canvas.

use super::{
    canvas::{Drawing, Maker, has_pixels, pixel_at},
    handles::Plane,
};
use crate::{face::Face, overview::Hover, theme::Text, widgets::text_in};
use egui::{Align2, Pos2, Rect, Response, Ui, pos2, vec2};
use rasterscope_core::{
    explain::{Grid, Mark},
    message::{Message, Value},
};

/// So near to a place the pointer is at it.
const HINT: f32 = 10.0;

/// What lies under the pointer, at the foot of the canvas; returns the pixel there.
pub(super) fn readout(
    ui: &Ui,
    face: &Face<'_>,
    plane: &Plane,
    ground: &Response,
    drawing: Drawing<'_>,
    known: Option<&Hover>,
) -> Option<[u32; 2]> {
    if drawing.rev.0 == Maker::Space || drawing.vantage.is_some() {
        foot(ui, face, plane.rect, &face.say("ui-readout-space"), false);
        return None;
    }
    let hover = ui.ctx().pointer_hover_pos();
    let at = hover.filter(|at| plane.rect.contains(*at) && ground.contains_pointer())?;
    if !has_pixels(drawing) {
        if drawing.view.grid == Grid::Units {
            let at = plane.point(at).map(|c| (c * 100.0).round() / 100.0);
            let text = face.words.message(&Message::new("ui-readout-point").with("at", at));
            // Above the plates of the guides, which stand at the foot.
            let above = plane.rect.with_max_y(plane.rect.bottom() - 34.0);
            foot(ui, face, above, &text, false);
        }
        return None;
    }
    let pixel = pixel_at(plane, at)?;
    let [x, y] = pixel;
    let centre = [x as f32 + 0.5, y as f32 + 0.5];
    let place = Message::new("ui-readout-pixel").with("x", x).with("y", y).with("centre", centre);
    let mut line = face.words.message(&place);
    if let Some(hint) = hint_at(drawing.marks, plane, at) {
        line = face.words.message(hint);
    } else if let Some(known) = known.filter(|known| known.pixel == pixel) {
        line = format!("{line}  {}", known.text);
    } else if let Some(value) = value_at(drawing.marks, pixel) {
        line = format!("{line}  {}", face.say_with("ui-readout-value", "value", value));
    }
    let legend = drawing.marks.iter().any(|mark| matches!(mark, Mark::Key { .. } | Mark::Ramp { .. }));
    foot(ui, face, plane.rect, &line, legend);
    Some(pixel)
}

/// What a drawing says of the place nearest to the pointer, if there is one near.
fn hint_at<'a>(marks: &'a [Mark], plane: &Plane, pointer: Pos2) -> Option<&'a Message> {
    let hints = marks.iter().filter_map(|mark| match mark {
        Mark::Hint { at, text } => Some((plane.place(*at).distance(pointer), text)),
        _ => None,
    });
    let (distance, text) = hints.min_by(|a, b| a.0.total_cmp(&b.0))?;
    (distance <= HINT).then_some(text)
}

/// The value that a drawing has at a pixel.
fn value_at(marks: &[Mark], pixel: [u32; 2]) -> Option<Value> {
    let here = |mark: &Mark| match mark {
        Mark::Pixel { at, value, .. } if at.map(i64::from) == pixel.map(i64::from) => Some(value.clone()),
        _ => None,
    };
    marks.iter().rev().find_map(here).filter(|value| *value != Value::None)
}

/// How much of the canvas's height one line at its foot takes.
pub(super) fn height(face: &Face<'_>) -> f32 {
    face.look.line_height(Text::Listing) + 14.0
}

/// One line at the foot of the canvas; it takes the whole width where a legend has its place.
fn foot(ui: &Ui, face: &Face<'_>, rect: Rect, message: &str, whole: bool) {
    let room = rect.width() - 28.0;
    let measure = |text| {
        let font = face.look.font(text);
        (ui.painter().layout_no_wrap(message.to_owned(), font.clone(), face.look.dim).size(), font)
    };
    let (size, font) = Some(measure(Text::Listing))
        .filter(|(size, _)| size.x <= room)
        .unwrap_or_else(|| measure(Text::SmallMono));
    let right = if whole { rect.right() } else { rect.left() + size.x.min(room) + 28.0 };
    let plate = Rect::from_min_max(
        pos2(rect.left(), rect.bottom() - size.y - 14.0),
        pos2(right, rect.bottom() - if whole { 0.0 } else { 4.0 }),
    );
    ui.painter().rect_filled(plate, 0, face.look.canvas);
    text_in(ui.painter(), plate.shrink2(vec2(14.0, 0.0)), Align2::LEFT_CENTER, message, font, face.look.dim);
}
