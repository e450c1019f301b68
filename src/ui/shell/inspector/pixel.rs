//! The history of the chosen pixel: every fragment in order, passed or why not.

use super::{inset, part_line};
use crate::{
    face::Face,
    overview::{Entry, History},
    paint,
    theme::{self, Text},
    widgets::text_in,
};
use egui::{Align2, Rect, Role as Part, Sense, StrokeKind, Ui, WidgetInfo, pos2, vec2};
use rasterscope_core::{explain::Role, message::Message};

/// Shows the history.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, history: Option<&History>) {
    let Some(history) = history else {
        return inset(ui, |ui| {
            ui.add_space(14.0);
            ui.label(face.dim(face.say("ui-pixel-none"), Text::Sentence));
        });
    };
    head(ui, face, history);
    part_line(ui, face);
    let clear = Entry {
        name: face.say("ui-pixel-clear"),
        reason: face.say_with(
            "ui-pixel-clear-depth",
            "depth",
            rasterscope_core::message::Value::text(&history.clear),
        ),
        role: Role::Skipped,
        details: Vec::new(),
    };
    for entry in std::iter::once(&clear).chain(&history.entries) {
        show_entry(ui, face, entry);
        part_line(ui, face);
    }
    inset(ui, |ui| {
        ui.add_space(10.0);
        ui.label(face.rich(&history.sentence, Text::Sentence));
        ui.add_space(10.0);
    });
}

fn head(ui: &mut Ui, face: &Face<'_>, history: &History) {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), 48.0), Sense::hover());
    let swatch = Rect::from_center_size(pos2(rect.left() + 29.0, rect.center().y), vec2(24.0, 24.0));
    ui.painter().rect_filled(swatch, 0, theme::code(history.color));
    let ring =
        egui::Stroke::new(2.5, if face.look.now == face.look.lit { face.look.text } else { face.look.now });
    ui.painter().rect_stroke(swatch, 0, ring, StrokeKind::Outside);
    let [x, y] = history.pixel;
    let title = face.words.message(&Message::new("ui-pixel-title").with("x", x).with("y", y));
    response.widget_info(|| WidgetInfo::labeled(Part::Label, true, &title));
    let room = rect.with_min_x(swatch.right() + 12.0).with_max_x(rect.right() - 16.0);
    text_in(ui.painter(), room, Align2::LEFT_CENTER, &title, face.look.font(Text::Title), face.look.text);
}

fn show_entry(ui: &mut Ui, face: &Face<'_>, entry: &Entry) {
    let look = face.look;
    let line = look.line_height(Text::Mono);
    let room = ui.available_width() - 56.0;
    let details = entry
        .details
        .iter()
        .map(|text| ui.painter().layout(text.clone(), look.font(Text::Listing), look.text, room));
    let details: Vec<_> = details.collect();
    let height = 14.0 + line + details.iter().map(|galley| galley.size().y + 3.0).sum::<f32>();
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    response
        .widget_info(|| WidgetInfo::labeled(Part::Label, true, format!("{}: {}", entry.name, entry.reason)));
    if !ui.is_rect_visible(rect) {
        return;
    }
    let painter = ui.painter();
    let color = look.role(entry.role);
    painter.rect_filled(Rect::from_min_size(rect.min, vec2(4.0, height)), 0, color);
    let y = rect.top() + 7.0 + line / 2.0;
    paint::marker(painter, pos2(rect.left() + 22.0, y), entry.role, 12.0, look);
    let row = |y: f32| {
        Rect::from_min_max(
            pos2(rect.left() + 40.0, y - line / 2.0),
            pos2(rect.right() - 16.0, y + line / 2.0),
        )
    };
    let name = painter.text(
        row(y).left_center(),
        Align2::LEFT_CENTER,
        &entry.name,
        look.font(Text::Strong),
        look.text,
    );
    let beside = row(y).with_min_x(name.right() + 10.0);
    let reason = if entry.role == Role::Skipped { look.dim } else { color };
    text_in(painter, beside, Align2::RIGHT_CENTER, &entry.reason, look.font(Text::Strong), reason);
    let mut at = pos2(rect.left() + 40.0, rect.top() + 9.0 + line);
    for detail in details {
        let height = detail.size().y;
        painter.galley(at, detail, look.text);
        at.y += height + 3.0;
    }
}
