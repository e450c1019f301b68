//! The title of what is open; where its stage has several labs, the menu of them.

use crate::{
    face::{Command, Face},
    recent,
    shell::Frame,
    theme::Text,
    widgets::{down, focus_ring, text_in},
};
use egui::{
    Align2, Popup, Rect, Response, Role as Part, ScrollArea, Sense, Ui, WidgetInfo, pos2,
    text::{LayoutJob, TextFormat},
    vec2,
};
use rasterscope_core::{
    labs::{self, LabInfo},
    message::Value,
};

/// Width of the menu, and on a projector.
const WIDTH: [f32; 2] = [330.0, 420.0];
/// Most of the window's height that the menu takes.
const HEIGHT: f32 = 0.7;

/// Shows the title.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, frame: &Frame<'_>) {
    let stage = labs::find(frame.lab).map(|lab| lab.stage);
    let all: Vec<LabInfo> = stage.into_iter().flat_map(recent::siblings).collect();
    if all.len() < 2 {
        ui.label(face.rich(&frame.title, Text::Title));
        return;
    }
    let size = vec2(ui.available_width(), face.look.line_height(Text::Title) + 6.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let name = face.say_with("ui-algorithm", "name", Value::text(&frame.title));
    response.widget_info(|| WidgetInfo::labeled(Part::ComboBox, true, &name));
    // The title stays in line with the sentence below; what answers the pointer reaches further.
    let ground = rect.expand2(vec2(6.0, 0.0));
    let open = Popup::is_id_open(ui.ctx(), Popup::default_response_id(&response));
    if response.hovered() || open {
        ui.painter().rect_filled(ground, 4, if open { face.look.raised } else { face.look.field });
    }
    let room = rect.with_max_x(rect.right() - 20.0);
    let font = face.look.font(Text::Title);
    text_in(ui.painter(), room, Align2::LEFT_CENTER, &frame.title, font, face.look.text);
    let sign = Rect::from_center_size(pos2(rect.right() - 8.0, rect.center().y), vec2(12.0, 12.0));
    down(ui, sign, ui.style().interact(&response), open);
    focus_ring(ui, &response, ground, face.look);
    let width = WIDTH[usize::from(face.look.projector())];
    Popup::menu(&response).width(width).show(|ui| {
        let most = ui.ctx().content_rect().height() * HEIGHT;
        ScrollArea::vertical().max_height(most).show(ui, |ui| {
            ui.set_width(width);
            ui.spacing_mut().item_spacing.y = 0.0;
            for lab in all {
                if entry(ui, face, lab, lab.name == frame.lab).clicked() {
                    face.ask(Command::Lab(lab.name));
                    ui.close();
                }
            }
        });
    });
}

/// One lab: its name, and its sentence below.
fn entry(ui: &mut Ui, face: &Face<'_>, lab: LabInfo, chosen: bool) -> Response {
    let look = face.look;
    let name = face.words.word(lab.name);
    let mut job = LayoutJob::default();
    job.wrap.max_width = ui.available_width() - 24.0;
    let style = if chosen { Text::Strong } else { Text::Body };
    job.append(&name, 0.0, TextFormat::simple(look.font(style), look.text));
    let about = format!("\n{}", face.words.word(&format!("{}-about", lab.name)));
    job.append(&about, 0.0, TextFormat::simple(look.font(Text::Small), look.dim));
    let galley = ui.painter().layout_job(job);
    let size = vec2(ui.available_width(), galley.size().y + 10.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| WidgetInfo::selected(Part::Button, true, chosen, &name));
    if chosen || response.hovered() || response.has_focus() {
        ui.painter().rect_filled(rect, 0, if chosen { look.raised } else { look.field });
    }
    if chosen {
        let bar = Rect::from_min_size(rect.min, vec2(4.0, rect.height()));
        ui.painter().rect_filled(bar, 0, look.text);
    }
    ui.painter().galley(rect.min + vec2(12.0, 5.0), galley, look.text);
    focus_ring(ui, &response, rect, look);
    response
}
