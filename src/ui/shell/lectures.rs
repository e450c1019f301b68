//! Where the lectures treat what is open: a line under its sentence, and the list behind it.

use crate::{
    face::Face,
    theme::Text,
    widgets::{down, focus_ring, text_in},
};
use egui::{Align2, Popup, Rect, Role as Part, Sense, Ui, WidgetInfo, pos2, vec2};
use rasterscope_core::{
    labs,
    message::{Message, Value},
};

/// Width of the list.
const WIDTH: f32 = 380.0;

/// Shows the line; nothing if no lecture treats the lab.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, lab: &str) {
    let topics = labs::find(lab).map_or(&[][..], |lab| lab.topics());
    let Some(first) = topics.first() else { return };
    let text =
        Message::new("ui-lecture").with("heading", Value::text(first.heading)).with("count", topics.len());
    let text = face.words.message(&text);
    let height = face.look.line_height(Text::Small) + 4.0;
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Part::Button, true, &text));
    let ground = rect.expand2(vec2(6.0, 0.0));
    if response.hovered() {
        ui.painter().rect_filled(ground, 4, face.look.field);
    }
    let font = face.look.font(Text::Small);
    let room = rect.with_max_x(rect.right() - 18.0);
    text_in(ui.painter(), room, Align2::LEFT_CENTER, &text, font, face.look.dim);
    let sign = Rect::from_center_size(pos2(rect.right() - 8.0, rect.center().y), vec2(10.0, 10.0));
    down(ui, sign, ui.style().interact(&response), false);
    focus_ring(ui, &response, ground, face.look);
    Popup::menu(&response).width(WIDTH).show(|ui| {
        ui.set_width(WIDTH);
        ui.label(face.dim(face.say("ui-lectures"), Text::LabelStrong));
        for topic in topics {
            ui.add_space(4.0);
            ui.label(face.rich(topic.heading, Text::Strong));
            ui.label(face.dim(topic.lecture, Text::Label));
        }
    });
}
