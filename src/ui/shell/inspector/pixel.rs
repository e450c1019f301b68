//! The history of the chosen pixel: every fragment in order, passed or why not.

use super::{inset, part_line};
use crate::{
    face::{Command, Face},
    overview::History,
    paint,
    theme::{self, Text},
    widgets::text_in,
};
use egui::{Align2, DragValue, Rect, Role as Part, Sense, StrokeKind, Ui, WidgetInfo, pos2, vec2};
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
    inset(ui, |ui| {
        ui.label(face.rich(&history.sentence, Text::Sentence));
        ui.add_space(4.0);
    });
    go_to(ui, face, history);
    ui.add_space(8.0);
    part_line(ui, face);
    let clear = face.say_with(
        "ui-pixel-clear-depth",
        "depth",
        rasterscope_core::message::Value::text(&history.clear),
    );
    show_entry(ui, face, [&face.say("ui-pixel-clear"), &clear], (Role::Skipped, &[]), None);
    part_line(ui, face);
    for (index, entry) in history.entries.iter().enumerate() {
        let texts = [&entry.name[..], &entry.reason];
        show_entry(ui, face, texts, (entry.role, &entry.details), Some(index));
        part_line(ui, face);
    }
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

/// Goes to a pixel by its number.
fn go_to(ui: &mut Ui, face: &Face<'_>, history: &History) {
    let mut pixel = history.pixel;
    inset(ui, |ui| {
        ui.horizontal(|ui| {
            let label = face.say("ui-pixel-go");
            ui.label(face.dim(&label, Text::Label));
            for (axis, name) in ["x", "y"].into_iter().enumerate() {
                let last = history.size[axis].saturating_sub(1);
                let drag =
                    DragValue::new(&mut pixel[axis]).range(0..=last).speed(0.1).prefix(format!("{name} "));
                ui.add(drag.update_while_editing(false)).accessible_name(format!("{label} {name}"));
            }
        });
    });
    if pixel != history.pixel {
        face.ask(Command::Pixel(pixel));
    }
}

/// One entry, by name and reason; a numbered one goes to the step, or the lab, that decided about it.
fn show_entry(
    ui: &mut Ui,
    face: &Face<'_>,
    [name, reason]: [&str; 2],
    (role, details): (Role, &[String]),
    index: Option<usize>,
) {
    let look = face.look;
    let line = look.line_height(Text::Mono);
    let room = ui.available_width() - 56.0;
    let details = details
        .iter()
        .map(|text| ui.painter().layout(text.clone(), look.font(Text::Listing), look.text, room));
    let details: Vec<_> = details.collect();
    let height = 14.0 + line + details.iter().map(|galley| galley.size().y + 3.0).sum::<f32>();
    let sense = if index.is_some() { Sense::click() } else { Sense::hover() };
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), sense);
    let part = if index.is_some() { Part::Button } else { Part::Label };
    response.widget_info(|| WidgetInfo::labeled(part, true, format!("{name}: {reason}")));
    if let Some(index) = index {
        if response.clicked() {
            face.ask(Command::ToEntry(index));
        }
        if response.hovered() || response.has_focus() {
            ui.painter().rect_filled(rect, 0, look.raised);
        }
    }
    if !ui.is_rect_visible(rect) {
        return;
    }
    let painter = ui.painter();
    let color = look.role(role);
    painter.rect_filled(Rect::from_min_size(rect.min, vec2(4.0, height)), 0, color);
    let y = rect.top() + 7.0 + line / 2.0;
    paint::marker(painter, pos2(rect.left() + 22.0, y), role, 12.0, look);
    let row = |y: f32| {
        Rect::from_min_max(
            pos2(rect.left() + 40.0, y - line / 2.0),
            pos2(rect.right() - 16.0, y + line / 2.0),
        )
    };
    let named =
        painter.text(row(y).left_center(), Align2::LEFT_CENTER, name, look.font(Text::Strong), look.text);
    let beside = row(y).with_min_x(named.right() + 10.0);
    let tone = if role == Role::Skipped { look.dim } else { color };
    text_in(painter, beside, Align2::RIGHT_CENTER, reason, look.font(Text::Strong), tone);
    let mut at = pos2(rect.left() + 40.0, rect.top() + 9.0 + line);
    for detail in details {
        let height = detail.size().y;
        painter.galley(at, detail, look.text);
        at.y += height + 3.0;
    }
}
