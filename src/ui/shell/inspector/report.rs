//! Why the chosen pixel is drawn or not.

use super::{inset, step, table};
use crate::{face::Face, theme::Text};
use egui::Ui;
use rasterscope_core::{
    explain::{PixelReport, Role},
    message::Message,
};
use rasterscope_figure::tables;

/// Shows the verdict and the numbers behind it.
pub(super) fn show(ui: &mut Ui, face: &Face<'_>, report: Option<&([u32; 2], PixelReport)>) {
    let Some(([x, y], report)) = report else {
        return inset(ui, |ui| {
            ui.add_space(14.0);
            ui.label(face.dim(face.say("ui-pixel-click"), Text::Sentence));
        });
    };
    inset(ui, |ui| {
        ui.add_space(12.0);
        let title = Message::new("ui-pixel-title").with("x", *x).with("y", *y);
        ui.label(face.rich(face.words.message(&title), Text::Title));
        ui.add_space(8.0);
        step::sentence(ui, face, &face.words.runs(&report.sentence));
        if let Some(warning) = &report.warning {
            ui.add_space(6.0);
            let warning = face.rich(face.words.message(warning), Text::Sentence);
            ui.label(warning.color(face.look.role(Role::Rejected)));
        }
        ui.add_space(8.0);
    });
    for one in &tables::format(&report.tables, &report.tables, face.words) {
        super::part_line(ui, face);
        table::show(ui, face, one, None, false);
    }
}
