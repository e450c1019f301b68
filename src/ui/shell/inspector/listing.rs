//! The pseudocode, the current line lit. A click on a line goes to its next execution.

use crate::{
    face::{Command, Face},
    link::Thing,
    run::Shown,
    theme::Text,
    widgets::focus_ring,
};
use egui::{
    Align2, Rect, Role as Part, Sense, Ui, WidgetInfo, pos2,
    text::{LayoutJob, TextFormat},
    vec2,
};

/// Room for the line numbers.
const NUMBERS: f32 = 38.0;

/// Room above and below the listing.
const ROOM: f32 = 8.0;
/// At least so many lines stay in sight below what a step says.
const LEAST: f32 = 5.0;

/// How high the listing is, and how much of it must stay in sight.
pub(super) fn heights(ui: &Ui, face: &Face<'_>, shown: &Shown) -> [f32; 2] {
    let line = face.look.line_height(Text::Listing);
    let high = |text: &&str| layout(ui, face, text).1.size().y.max(line);
    let whole = shown.listing.iter().map(high).sum::<f32>() + 2.0 * ROOM;
    [whole, whole.min(LEAST * line + ROOM)]
}

/// Shows the listing; after a step the lit line is scrolled into sight, and then left to the user.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, shown: &Shown) {
    let look = face.look;
    let key = ui.scope_id().with("scrolled");
    // More room, or less, for the same step is as good as a step.
    let now = (shown.rev, ui.clip_rect().size().to_pos2());
    let stepped = ui.data(|data| data.get_temp(key)) != Some(now);
    ui.data_mut(|data| data.insert_temp(key, now));
    ui.add_space(ROOM);
    for (i, line) in shown.listing.iter().enumerate() {
        let (left, galley) = layout(ui, face, line);
        let size = vec2(ui.available_width(), galley.size().y.max(look.line_height(Text::Listing)));
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        let lit = shown.line == Some(i);
        if lit && stepped {
            // With a line above and below, so that it stands in its context. At once: a step is instant.
            let context = rect.expand2(vec2(0.0, look.line_height(Text::Listing)));
            ui.scroll_to_rect_animation(context, None, egui::style::ScrollAnimation::none());
        }
        let name = line.trim_start();
        response.widget_info(|| WidgetInfo::selected(Part::Button, true, lit, format!("{}: {name}", i + 1)));
        if !ui.is_rect_visible(rect) {
            continue;
        }
        if response.hovered() {
            face.links.point_at(Thing::Line(name.to_owned()));
        }
        if lit {
            ui.painter().rect_filled(rect, 0, look.lit);
            let bar = if look.now == look.lit { look.text } else { look.now };
            ui.painter().rect_filled(Rect::from_min_size(rect.min, vec2(4.0, size.y)), 0, bar);
        } else if response.hovered() || face.links.line(name) {
            ui.painter().rect_filled(rect, 0, look.raised);
        }
        let number = if lit { look.text } else { look.dim };
        let at = pos2(rect.left() + 28.0, rect.top() + look.line_height(Text::Listing) / 2.0);
        ui.painter().text(at, Align2::RIGHT_CENTER, (i + 1).to_string(), look.font(Text::Listing), number);
        ui.painter().galley(pos2(rect.left() + left, rect.top()), galley, look.text);
        focus_ring(ui, &response, rect, look);
        if response.on_hover_text(face.say("ui-listing-hint")).clicked() {
            face.ask(Command::ToLine(i));
        }
    }
    ui.add_space(ROOM);
}

/// One line and how far it is indented; what does not fit goes on below.
fn layout(ui: &Ui, face: &Face<'_>, line: &str) -> (f32, std::sync::Arc<egui::Galley>) {
    let code = line.trim_start();
    let font = face.look.font(Text::Listing);
    let digit = ui.painter().layout_no_wrap("0".to_owned(), font.clone(), face.look.text).size().x;
    let left = NUMBERS + digit * (line.len() - code.len()) as f32;
    let mut format = TextFormat::simple(font, face.look.text);
    format.line_height = Some(face.look.line_height(Text::Listing));
    let mut job = LayoutJob::default();
    job.wrap.max_width = ui.available_width() - left - 6.0;
    job.append(code, 0.0, format);
    (left, ui.painter().layout_job(job))
}
