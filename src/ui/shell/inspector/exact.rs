//! A table with every digit: one line a value, binary32 with its bits.

use super::table::{self, INSET};
use crate::{face::Face, theme::Text};
use egui::{
    Align, Align2, Sense, Ui, pos2,
    text::{LayoutJob, TextFormat},
    vec2,
};
use rasterscope_figure::tables::{TextRow, TextTable};

/// Room between a heading and its value.
const GAP: f32 = 12.0;

/// Shows one row.
pub(super) fn show(ui: &mut Ui, face: &Face<'_>, table: &TextTable, row: &TextRow) {
    let look = face.look;
    let lines = table.columns.iter().zip(&row.cells).filter(|(_, cell)| !cell.text.is_empty());
    let room = ui.available_width() - 2.0 * INSET;
    let lines: Vec<_> = lines
        .map(|(heading, cell)| {
            let heading = ui.painter().layout_no_wrap(heading.clone(), look.font(Text::SmallMono), look.dim);
            let mut job = LayoutJob::default();
            job.wrap.max_width = room - heading.size().x - GAP;
            job.wrap.break_anywhere = true;
            job.halign = Align::RIGHT;
            let font = look.font(if table::news(cell) { Text::MonoStrong } else { Text::SmallMono });
            job.append(&cell.exact, 0.0, TextFormat::simple(font, look.text));
            (heading, ui.painter().layout_job(job))
        })
        .collect();
    let line = look.line_height(Text::Mono) + 4.0;
    let height = line + lines.iter().map(|(_, value)| value.size().y + 3.0).sum::<f32>();
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    response.widget_info(|| table::spoken(row));
    table::ground(ui, face, row, rect, &response);
    let style = if row.active { Text::MonoStrong } else { Text::Mono };
    let at = pos2(rect.left() + INSET, rect.top() + line / 2.0);
    ui.painter().text(at, Align2::LEFT_CENTER, &row.name, look.font(style), look.text);
    let mut y = rect.top() + line;
    for (heading, value) in lines {
        let size = value.size();
        ui.painter().galley(pos2(rect.left() + INSET, y), heading, look.dim);
        ui.painter().galley(pos2(rect.right() - INSET, y), value, look.text);
        y += size.y + 3.0;
    }
}
