//! The history of the chosen pixel: every fragment in order, passed or why not.

use super::inset;
use crate::{document::ViewState, face::Face, theme::Text};
use egui::Ui;

/// Shows the history of the chosen pixel.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, view: &ViewState) {
    inset(ui, |ui| {
        ui.add_space(14.0);
        if view.pixel.is_none() {
            ui.label(face.dim(face.say("ui-pixel-none"), Text::Sentence));
        }
    });
}
