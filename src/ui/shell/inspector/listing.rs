//! The pseudocode, the current line lit. A click on a line goes to its next execution.

use crate::{
    face::{Command, Face},
    run::Shown,
    theme::Text,
    widgets::{focus_ring, text_in},
};
use egui::{Align2, Rect, Role as Part, Sense, Ui, WidgetInfo, pos2, vec2};

/// Shows the listing.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, shown: &Shown) {
    let look = face.look;
    ui.add_space(8.0);
    for (i, line) in shown.listing.iter().enumerate() {
        let size = vec2(ui.available_width(), look.line_height(Text::Listing));
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        let lit = shown.line == Some(i);
        let name = line.trim_start();
        response.widget_info(|| WidgetInfo::selected(Part::Button, true, lit, format!("{}: {name}", i + 1)));
        if !ui.is_rect_visible(rect) {
            continue;
        }
        if lit {
            ui.painter().rect_filled(rect, 0, look.lit);
            let bar = if look.now == look.lit { look.text } else { look.now };
            ui.painter().rect_filled(Rect::from_min_size(rect.min, vec2(4.0, size.y)), 0, bar);
        } else if response.hovered() {
            ui.painter().rect_filled(rect, 0, look.raised);
        }
        let font = look.font(Text::Listing);
        let number = if lit { look.text } else { look.dim };
        let at = pos2(rect.left() + 28.0, rect.center().y);
        ui.painter().text(at, Align2::RIGHT_CENTER, (i + 1).to_string(), font.clone(), number);
        let room =
            Rect::from_min_max(pos2(rect.left() + 38.0, rect.top()), pos2(rect.right() - 6.0, rect.bottom()));
        text_in(ui.painter(), room, Align2::LEFT_CENTER, line, font, look.text);
        focus_ring(ui, &response, rect, look);
        if response.on_hover_text(face.say("ui-listing-hint")).clicked() {
            face.ask(Command::ToLine(i));
        }
    }
    ui.add_space(8.0);
}
