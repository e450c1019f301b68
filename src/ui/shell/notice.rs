//! Bars under the ribbon, never modal: what went wrong with a file, and where a path is typed.

use crate::{
    face::{Command, Face},
    paint,
    theme::Text,
    widgets::text_in,
};
use egui::{Align2, Key, Rect, Role as Part, Sense, TextEdit, Ui, WidgetInfo, vec2};
use rasterscope_core::explain::Role;

/// What lies under the ribbon.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Notice {
    /// Something failed; the document stays as it was.
    Failed(String),
    /// Something worked that leaves no trace on the screen.
    Done(String),
    /// A path is asked for.
    Path {
        /// To write rather than to read.
        save: bool,
        /// As typed so far.
        path: String,
        /// Whether the field still has to get the keyboard.
        fresh: bool,
    },
}

/// The height of the bar.
pub(crate) fn height(face: &Face<'_>) -> f32 {
    face.look.button_height() + 12.0
}

/// Shows the bar.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, notice: &mut Notice) {
    let rect = ui.max_rect();
    let bar = match notice {
        Notice::Failed(_) => Some(Role::Rejected),
        Notice::Done(_) => Some(Role::Accepted),
        Notice::Path { .. } => None,
    };
    let color = bar.map_or(face.look.text, |role| face.look.role(role));
    ui.painter().rect_filled(Rect::from_min_size(rect.min, vec2(4.0, rect.height())), 0, color);
    ui.horizontal_centered(|ui| {
        ui.add_space(14.0);
        if let Some(role) = bar {
            let (at, _) = ui.allocate_exact_size(vec2(14.0, 14.0), Sense::hover());
            paint::marker(ui.painter(), at.center(), role, 11.0, face.look);
        }
        match notice {
            Notice::Failed(text) | Notice::Done(text) => {
                let room = vec2(ui.available_width() - 110.0, face.look.button_height());
                let (rect, response) = ui.allocate_exact_size(room, Sense::hover());
                response.widget_info(|| WidgetInfo::labeled(Part::Label, true, text.as_str()));
                text_in(
                    ui.painter(),
                    rect,
                    Align2::LEFT_CENTER,
                    text,
                    face.look.font(Text::Body),
                    face.look.text,
                );
                response.on_hover_text(text.as_str());
                if ui.button(face.say("ui-dismiss")).clicked() {
                    face.ask(Command::Dismiss);
                }
            }
            Notice::Path { save, path, fresh } => ask(ui, face, *save, path, fresh),
        }
    });
}

fn ask(ui: &mut Ui, face: &Face<'_>, save: bool, path: &mut String, fresh: &mut bool) {
    let label = ui.label(face.rich(face.say(if save { "ui-path-save" } else { "ui-path-open" }), Text::Body));
    let width = (ui.available_width() - 330.0).max(160.0);
    let field = ui.add(TextEdit::singleline(path).desired_width(width).font(face.look.font(Text::Mono)));
    let field = field.labelled_by(label.id);
    if std::mem::take(fresh) {
        field.request_focus();
    }
    let enter = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    let done = ui.button(face.say(if save { "ui-save" } else { "ui-open" })).clicked();
    if (enter || done) && !path.trim().is_empty() {
        let path = path.trim().to_owned();
        face.ask(if save { Command::SaveAs(path) } else { Command::Open(path) });
    }
    if !save && ui.button(face.say("ui-choose-file")).clicked() {
        face.ask(Command::Choose);
    }
    if ui.button(face.say("ui-cancel")).clicked() {
        face.ask(Command::Dismiss);
    }
}
