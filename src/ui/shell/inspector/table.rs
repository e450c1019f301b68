//! A table of values: numbers right-aligned under each other, changed ones marked.

use super::{exact, inset};
use crate::{face::Face, link::Thing, paint, theme::Text};
use egui::{
    Align2, Color32, FontId, Rect, Response, Role as Part, Sense, Stroke, Ui, WidgetInfo, pos2, vec2,
};
use rasterscope_core::explain::Role;
use rasterscope_figure::{
    numbers,
    tables::{TextCell, TextRow, TextTable},
};

/// Room at both edges.
pub(super) const INSET: f32 = 16.0;
/// Least room between two columns.
const GAP: f32 = 12.0;

/// Shows a table; `most` rows of it, round the active one. `key` explains the mark of changes.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, table: &TextTable, most: Option<usize>, key: bool) {
    if table.rows.is_empty() {
        return;
    }
    ui.add_space(8.0);
    title(ui, face, table, key);
    let rows = window(table, most);
    let columns = columns(ui, face, table, &table.rows[rows.clone()]);
    if !face.exact {
        heading(ui, face, table, &columns);
    }
    if rows.start > 0 {
        more(ui, face, rows.start);
    }
    for row in &table.rows[rows.clone()] {
        if face.exact {
            exact::show(ui, face, table, row);
        } else {
            show_row(ui, face, table, row, &columns);
        }
    }
    if rows.end < table.rows.len() {
        more(ui, face, table.rows.len() - rows.end);
    }
    ui.add_space(8.0);
}

/// The rows to show: round the active one, or the last ones.
fn window(table: &TextTable, most: Option<usize>) -> std::ops::Range<usize> {
    let (len, most) = (table.rows.len(), most.unwrap_or(usize::MAX));
    if len <= most {
        return 0..len;
    }
    let active = table.rows.iter().rposition(|row| row.active || changed(row)).unwrap_or(0);
    let first = (active + 2).saturating_sub(most).min(len - most);
    first..first + most
}

/// Whether a cell says something that it did not say before; that a value ended is no news.
pub(super) fn news(cell: &TextCell) -> bool {
    cell.changed && !cell.text.is_empty() && cell.text != numbers::UNDEFINED
}

/// Whether any of a row's cells does.
pub(super) fn changed(row: &TextRow) -> bool {
    row.cells.iter().any(news)
}

fn title(ui: &mut Ui, face: &Face<'_>, table: &TextTable, key: bool) {
    let note = face.say("ui-changed");
    let wide = |text: &str, style| {
        ui.painter().layout_no_wrap(text.to_owned(), face.look.font(style), face.look.text).size().x
    };
    let both = wide(&table.title, Text::LabelStrong) + GAP + wide(&note, Text::Label) + 18.0;
    let beside = both <= ui.available_width() - 2.0 * INSET;
    let noted = key && table.rows.iter().any(changed);
    let mark = |ui: &mut Ui| {
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let color = face.look.role(Role::Changed);
            ui.label(face.rich(&note, Text::Label).color(color));
            let (rect, _) = ui.allocate_exact_size(vec2(10.0, 10.0), Sense::hover());
            paint::marker(ui.painter(), rect.center(), Role::Changed, 8.0, face.look);
        });
    };
    inset(ui, |ui| {
        ui.horizontal(|ui| {
            let title = ui.label(face.dim(&table.title, Text::LabelStrong));
            if let Some(meaning) = table.meanings.first().cloned().flatten() {
                title.on_hover_text(meaning);
            }
            if noted && beside {
                mark(ui);
            }
        });
        // Beside a long title there is no room.
        if noted && !beside {
            ui.spacing_mut().interact_size.y = 0.0;
            ui.horizontal(mark);
        }
    });
}

/// Whether a cell holds words, not numbers.
fn is_words(text: &str) -> bool {
    text.chars().filter(|c| c.is_lowercase()).count() > 2
}

/// The font of a cell; `dense` where a row would not fit otherwise.
fn font(face: &Face<'_>, text: &str, strong: bool, dense: bool) -> FontId {
    face.look.font(match (is_words(text), strong) {
        (true, _) if dense => Text::Small,
        (false, _) if dense => Text::SmallMono,
        (true, false) => Text::Label,
        (true, true) => Text::LabelStrong,
        (false, false) => Text::Mono,
        (false, true) => Text::MonoStrong,
    })
}

/// Where the columns of a table stand.
struct Columns {
    /// The right edge of each column, from the left edge of the table; the names come first.
    right: Vec<f32>,
    /// Whether the smallest font is needed.
    dense: bool,
    /// How many columns stand with the name in a line of their own above the others, if any line
    /// has to be folded.
    above: Option<usize>,
}

impl Columns {
    /// The first column that does not stand beside the name.
    fn first(&self) -> usize {
        self.above.unwrap_or(0)
    }
}

/// In the usual font if that fits, else in the smallest, else in two lines a row.
fn columns(ui: &Ui, face: &Face<'_>, table: &TextTable, rows: &[TextRow]) -> Columns {
    let room = ui.available_width() - 2.0 * INSET;
    let words = |row: &TextRow| row.cells.first().is_some_and(|cell| is_words(&cell.text));
    let above = Some(usize::from(table.columns.len() > 1 && rows.iter().any(words)));
    let measured = |dense: bool, above: Option<usize>| {
        let mut widths = widths(ui, face, table, rows, dense);
        widths.drain(..above.map_or(0, |above| above + 1));
        (dense, above, widths)
    };
    let ways = [(false, None), (true, None), (false, above)];
    let fits = |widths: &[f32]| widths.iter().sum::<f32>() + GAP * (widths.len() as f32 - 1.0) <= room;
    let mut all = ways.into_iter().map(|(dense, above)| measured(dense, above));
    let found = all.find(|(.., widths)| fits(widths));
    let (dense, above, widths) = found.unwrap_or_else(|| measured(true, above));
    let gaps = (widths.len() as f32 - 1.0).max(1.0);
    let gap = ((room - widths.iter().sum::<f32>()) / gaps).max(4.0);
    let mut right = INSET - if above.is_some() { gap } else { 0.0 };
    let skip = usize::from(above.is_none());
    if let Some(names) = widths.first().filter(|_| skip == 1) {
        right += names;
    }
    let right = widths.iter().skip(skip).map(|width| {
        right += width + gap;
        right
    });
    Columns { right: right.collect(), dense, above }
}

/// The width of the names, then of each column.
fn widths(ui: &Ui, face: &Face<'_>, table: &TextTable, rows: &[TextRow], dense: bool) -> Vec<f32> {
    let measure = |text: &str, strong: bool| {
        ui.painter().layout_no_wrap(text.to_owned(), font(face, text, strong, dense), Color32::WHITE).size().x
    };
    let name = |row: &TextRow| {
        measure(&row.name, row.active) + if row.role.is_some() || changed(row) { 18.0 } else { 0.0 }
    };
    let names = rows.iter().map(name).fold(0.0, f32::max);
    let column = |(i, heading): (usize, &String)| {
        let cells = rows.iter().filter_map(|row| row.cells.get(i));
        cells.map(|cell| measure(&cell.text, true)).fold(measure(heading, false), f32::max)
    };
    std::iter::once(names).chain(table.columns.iter().enumerate().map(column)).collect()
}

fn heading(ui: &mut Ui, face: &Face<'_>, table: &TextTable, columns: &Columns) {
    if table.columns.iter().all(String::is_empty) {
        return;
    }
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), 20.0), Sense::hover());
    let headings = table.columns.iter().zip(table.meanings.iter().skip(1)).enumerate();
    for ((i, (text, meaning)), right) in headings.skip(columns.first()).zip(&columns.right) {
        let at = pos2(rect.left() + right, rect.center().y);
        let font = font(face, text, false, columns.dense);
        let galley = ui.painter().layout_no_wrap(text.clone(), font, face.look.dim);
        let place = Align2::RIGHT_CENTER.anchor_size(at, galley.size());
        let id = ui.scope_id().with((&table.title, i));
        let response = ui.interact(place.expand2(vec2(4.0, 2.0)), id, Sense::hover());
        if response.hovered() {
            face.links.point_at(Thing::Name(text.clone()));
        }
        if response.hovered() || face.links.name(text) && !text.is_empty() {
            ui.painter().rect_filled(place.expand2(vec2(4.0, 2.0)), 3, face.look.raised);
        }
        ui.painter().galley(place.min, galley, face.look.dim);
        if let Some(meaning) = meaning {
            response.widget_info(|| WidgetInfo::labeled(Part::Label, true, format!("{text}: {meaning}")));
            response.on_hover_text(meaning);
        }
    }
}

fn more(ui: &mut Ui, face: &Face<'_>, count: usize) {
    inset(ui, |ui| {
        ui.label(face.dim(face.say_with("ui-more-rows", "count", count), Text::Small));
    });
}

/// A row in words, for who cannot see it.
pub(super) fn spoken(row: &TextRow) -> WidgetInfo {
    let cells: Vec<&str> = row.cells.iter().map(|cell| cell.text.as_str()).collect();
    WidgetInfo::labeled(Part::Label, true, format!("{} {}", row.name, cells.join(" ")))
}

/// What lies under a row: lit, changed, or raised while the pointer is on what it is about.
pub(super) fn ground(ui: &Ui, face: &Face<'_>, row: &TextRow, rect: Rect, response: &Response) {
    let look = face.look;
    if response.hovered() {
        let thing = row.name.parse().map_or_else(|_| Thing::Name(row.name.clone()), Thing::Row);
        face.links.point_at(thing);
    }
    let lit = match (row.active, changed(row)) {
        (true, _) => Some((look.lit, if look.now == look.lit { look.text } else { look.now })),
        (_, true) => Some((look.changed_bg, look.role(Role::Changed))),
        _ => None,
    };
    if let Some((fill, bar)) = lit {
        ui.painter().rect_filled(rect, 0, fill);
        ui.painter().rect_filled(Rect::from_min_size(rect.min, vec2(4.0, rect.height())), 0, bar);
    } else if response.hovered() || face.links.name(&row.name) {
        ui.painter().rect_filled(rect, 0, look.raised);
    }
}

fn show_row(ui: &mut Ui, face: &Face<'_>, table: &TextTable, row: &TextRow, columns: &Columns) {
    let look = face.look;
    let line = look.line_height(Text::Mono) + if row.role.is_some() { 5.0 } else { 4.0 };
    let height = if columns.above.is_some() { 2.0 * line - 4.0 } else { line };
    // A click copies; the keyboard has the command that copies all values.
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::CLICK);
    response.widget_info(|| spoken(row));
    if !ui.is_rect_visible(rect) {
        return;
    }
    ground(ui, face, row, rect, &response);
    let painter = ui.painter();
    let changed = changed(row);
    let strong = row.active || changed;
    let at = pos2(rect.left() + INSET, rect.top() + line / 2.0);
    let mut end = painter
        .text(at, Align2::LEFT_CENTER, &row.name, font(face, &row.name, strong, columns.dense), look.text)
        .right();
    for cell in &row.cells[..columns.first()] {
        let font = font(face, &cell.text, false, columns.dense);
        end = painter.text(pos2(end + GAP, at.y), Align2::LEFT_CENTER, &cell.text, font, look.text).right();
    }
    let marker = row.role.or(changed.then_some(Role::Changed));
    if let Some(role) = marker {
        paint::marker(painter, pos2(end + 11.0, at.y), role, 9.0, look);
    }
    let y = if columns.above.is_some() { rect.bottom() - line / 2.0 } else { at.y };
    for (cell, right) in row.cells.iter().skip(columns.first()).zip(&columns.right) {
        let font = font(face, &cell.text, strong || news(cell), columns.dense);
        show_cell(ui, face, cell, pos2(rect.left() + right, y), font, row.active);
    }
    let under = response.interact_pointer_pos().map(|at| at.x - rect.left());
    let cell = under.and_then(|x| columns.right.iter().position(|right| x <= *right + GAP / 2.0));
    let cell = cell.and_then(|i| row.cells.get(i + columns.first()));
    let copied = response.id.with("copied");
    if let Some(cell) = cell.filter(|cell| response.clicked() && !cell.text.is_empty()) {
        ui.ctx().copy_text(plain(cell));
        ui.data_mut(|data| data.insert_temp(copied, plain(cell)));
    } else if !response.hovered() {
        ui.data_mut(|data| data.remove::<String>(copied));
    }
    let copied = ui.data(|data| data.get_temp::<String>(copied));
    response.on_hover_ui(|ui| tooltip(ui, face, table, row, copied));
}

/// Every digit of every value, and that a click copies one.
fn tooltip(ui: &mut Ui, face: &Face<'_>, table: &TextTable, row: &TextRow, copied: Option<String>) {
    egui::Grid::new("exact").num_columns(2).spacing([12.0, 2.0]).show(ui, |ui| {
        for (heading, cell) in table.columns.iter().zip(&row.cells).filter(|(_, cell)| !cell.text.is_empty())
        {
            ui.label(face.dim(heading, Text::SmallMono));
            ui.label(face.rich(&cell.exact, Text::Mono));
            ui.end_row();
        }
    });
    let say = match copied {
        Some(value) => {
            face.say_with("ui-copied-value", "value", rasterscope_core::message::Value::text(value))
        }
        None => face.say("ui-copy-value"),
    };
    ui.label(face.dim(say, Text::Small));
}

/// A value as it is copied: every digit, without its bits, with a minus that others can read.
pub(super) fn plain(cell: &TextCell) -> String {
    let value = cell.exact.split(" (").next().unwrap_or_default();
    let number = value.starts_with(|c: char| c.is_ascii_digit() || c == numbers::MINUS);
    if number { value.replace(numbers::MINUS, "-") } else { cell.text.clone() }
}

fn show_cell(ui: &Ui, face: &Face<'_>, cell: &TextCell, at: egui::Pos2, font: FontId, lit: bool) {
    let look = face.look;
    let color = if news(cell) && !lit { look.role(Role::Changed) } else { look.text };
    let rect = ui.painter().text(at, Align2::RIGHT_CENTER, &cell.text, font, color);
    if news(cell) {
        let y = ui.painter().round_to_pixel_center(rect.bottom() + 1.0);
        ui.painter().hline(rect.x_range(), y, Stroke::new(2.0, look.role(Role::Changed)));
    }
}
