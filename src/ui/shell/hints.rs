//! The hints of the first start: where to drag, how to step, what a pixel tells. A calm strip at the
//! foot of the canvas that covers nothing, never a window in the way; the help menu brings it back.

use crate::{
    face::{Command, Face},
    theme::Text,
    widgets::{Icon, State, icon_button, text_lines},
};
use egui::{Painter, Rect, Role as Part, Sense, StrokeKind, Ui, WidgetInfo, pos2, vec2};

/// What a hint shows before its sentence.
#[derive(Clone, Copy, Debug)]
enum Sign {
    Handle,
    Step,
    Pixel,
}

/// The sentences.
const HINTS: [(Sign, &str); 3] =
    [(Sign::Handle, "ui-hint-drag"), (Sign::Step, "ui-hint-step"), (Sign::Pixel, "ui-hint-pixel")];
/// Room for a sign.
const SIGN: f32 = 30.0;
/// Room for the button at the right.
const CLOSE: f32 = 40.0;

/// The height of the strip.
pub(crate) fn height(face: &Face<'_>) -> f32 {
    let lines = if face.look.projector() { 4.0 } else { 3.0 };
    lines * face.look.line_height(Text::Label) + 16.0
}

/// Shows the strip.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>) {
    let (rect, look) = (ui.max_rect(), face.look);
    let width = (rect.width() - CLOSE) / HINTS.len() as f32;
    for (i, (sign, id)) in HINTS.into_iter().enumerate() {
        let at =
            Rect::from_min_size(pos2(rect.left() + i as f32 * width, rect.top()), vec2(width, rect.height()));
        let text = face.say(id);
        let response = ui.interact(at, ui.scope_id().with(id), Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Part::Label, true, &text));
        paint(ui.painter(), face, sign, pos2(at.left() + 22.0, at.center().y));
        let room = Rect::from_min_max(pos2(at.left() + 12.0 + SIGN, at.top()), at.max - vec2(8.0, 0.0));
        text_lines(ui.painter(), room, &text, look.font(Text::Label), look.text);
        if i > 0 {
            let x = ui.painter().round_to_pixel_center(at.left());
            ui.painter().vline(x, at.shrink(10.0).y_range(), egui::Stroke::new(1.0, look.line));
        }
    }
    let close = Rect::from_center_size(pos2(rect.right() - 20.0, rect.top() + 20.0), vec2(28.0, 28.0));
    ui.scope_builder(egui::UiBuilder::new().max_rect(close), |ui| {
        let name = face.say("ui-hints-close");
        if icon_button(ui, face, Icon::Cross, close.size(), &name, State::Off).clicked() {
            face.ask(Command::Hints);
        }
    });
}

/// What to look for on the screen, as it is painted there.
fn paint(painter: &Painter, face: &Face<'_>, sign: Sign, at: egui::Pos2) {
    let look = face.look;
    match sign {
        Sign::Handle => {
            painter.circle(at, 7.0, look.canvas, look.stroke(2.0, look.text));
            painter.circle_filled(at, 2.2, look.text);
        }
        Sign::Step => Icon::Forward.paint(painter, at, look.text),
        Sign::Pixel => {
            let cell = Rect::from_center_size(at, vec2(15.0, 15.0));
            painter.rect(cell, 0, look.raised, look.stroke(2.0, look.text), StrokeKind::Inside);
        }
    }
}
