//! The digest of one step: sentence, formula with this step's numbers, values, listing.

use super::{Digest, inset, listing, part_line, table};
use crate::{
    face::Face,
    run::Shown,
    theme::Text,
    widgets::{follow_focus, rule},
};
use egui::{
    ScrollArea, Sense, Stroke, Ui, UiBuilder,
    text::{LayoutJob, TextFormat},
    vec2,
};
use rasterscope_figure::tables::{Run as Piece, TextTable};

/// Most rows of a table that the digest shows; the tab Values shows all.
const MOST_ROWS: usize = 9;

/// From this width on the listing stands beside the rest.
const BESIDE: f32 = 620.0;

/// The part of the height that the listing has at least, if it needs it.
const LISTING: f32 = 0.3;

/// Shows the digest.
///
/// What happened and the listing scroll by themselves: whatever is long, the sentence and the lit
/// line are in sight together.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, shown: &Shown, digest: &Digest) {
    let scrolled = |ui: &mut Ui, name: &str, most: f32, content: &mut dyn FnMut(&mut Ui)| {
        let area = ScrollArea::vertical().id_salt(name).max_height(most).auto_shrink([false, true]);
        area.show(ui, |ui| {
            ui.set_width(ui.available_width());
            content(ui);
            follow_focus(ui);
        });
    };
    let rect = ui.available_rect_before_wrap();
    if rect.width() < BESIDE {
        let [whole, least] = listing::heights(ui, face, shown);
        let least = least.max(whole.min(LISTING * rect.height())) + 1.0;
        scrolled(ui, "happened", rect.height() - least, &mut |ui| happened(ui, face, digest));
        let (line, _) = ui.allocate_exact_size(vec2(rect.width(), 1.0), Sense::hover());
        let rest = ui.available_height();
        scrolled(ui, "listing", rest, &mut |ui| listing::show(ui, face, shown));
        // Last, or what fades out at the edge of the listing would lie over it.
        return rule(ui, line, face.look);
    }
    let middle = ui.painter().round_to_pixel_center(rect.left() + rect.width() * 0.54);
    let [left, right] = [rect.with_max_x(middle), rect.with_min_x(middle + 1.0)];
    for (part, half) in [left, right].into_iter().enumerate() {
        ui.scope_builder(UiBuilder::new().max_rect(half), |ui| {
            let name = ["happened", "listing"][part];
            scrolled(ui, name, half.height(), &mut |ui| {
                if part == 0 { happened(ui, face, digest) } else { listing::show(ui, face, shown) }
            });
        });
    }
    ui.painter().vline(middle, rect.y_range(), Stroke::new(1.0, face.look.line));
}

/// Sentence, formulas and the values that they are about.
fn happened(ui: &mut Ui, face: &Face<'_>, digest: &Digest) {
    inset(ui, |ui| {
        ui.add_space(12.0);
        sentence(ui, face, &digest.sentence);
        for [general, numbers] in &digest.formulas {
            ui.add_space(6.0);
            formula(ui, face, general, true);
            formula(ui, face, numbers, false);
        }
        ui.add_space(12.0);
    });
    // What the step is about; if it is about no table, the first one says where the run stands.
    let about = |table: &&TextTable| table.rows.iter().any(|row| row.active || table::changed(row));
    let mut tables: Vec<_> = digest.tables.iter().filter(about).collect();
    if tables.is_empty() {
        tables.extend(digest.tables.iter().find(|table| !table.rows.is_empty()));
    }
    for (i, one) in tables.into_iter().enumerate() {
        part_line(ui, face);
        table::show(ui, face, one, Some(MOST_ROWS), i == 0);
    }
}

/// What just happened; what it is about is bold.
pub(super) fn sentence(ui: &mut Ui, face: &Face<'_>, pieces: &[Piece]) {
    let look = face.look;
    let mut job = LayoutJob::default();
    job.wrap.max_width = ui.available_width();
    for piece in pieces {
        let style = if piece.strong { Text::SentenceStrong } else { Text::Sentence };
        let mut format = TextFormat::simple(look.font(style), look.text);
        format.line_height = Some(look.line_height(Text::Sentence));
        job.append(&piece.text, 0.0, format);
    }
    ui.label(job);
}

fn formula(ui: &mut Ui, face: &Face<'_>, pieces: &[Piece], general: bool) {
    let look = face.look;
    let mut job = LayoutJob::default();
    job.wrap.max_width = ui.available_width();
    let mut depth = 0;
    for piece in pieces {
        let mut format =
            TextFormat::simple(look.font(Text::Mono), if general { look.dim } else { look.text });
        format.line_height = Some(look.line_height(Text::Mono));
        // A value stays on one row, and so does what stands in parentheses; else a row may end.
        let mut text = together(&piece.text, &mut depth);
        if piece.strong {
            format.font_id = look.font(Text::MonoStrong);
            text = text.replace(' ', "\u{a0}");
        }
        if piece.highlighted {
            // On a dark ground yellow is the ink; on a light one it is the paper.
            if look.theme.canvas == look.theme.panel || look.lit == look.now {
                format.background = look.lit;
                format.expand_bg = 2.0;
            } else {
                format.color = look.now;
            }
        }
        job.append(&text, 0.0, format);
    }
    ui.label(job);
}

/// A text whose spaces between parentheses end no row. `depth`: how many of these are open.
fn together(text: &str, depth: &mut usize) -> String {
    let kept = |letter: char| {
        match letter {
            '(' => *depth += 1,
            ')' => *depth = depth.saturating_sub(1),
            ' ' if *depth > 0 => return '\u{a0}',
            _ => {}
        }
        letter
    };
    text.chars().map(kept).collect()
}
