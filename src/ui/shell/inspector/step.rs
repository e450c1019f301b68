//! The digest of one step: sentence, formula with this step's numbers, values, listing.

use super::{Digest, inset, listing, part_line, table};
use crate::{face::Face, run::Shown, theme::Text};
use egui::{
    Ui,
    text::{LayoutJob, TextFormat},
};
use rasterscope_figure::tables::{Run as Piece, TextTable};

/// Most rows of a table that the digest shows; the tab Values shows all.
const MOST_ROWS: usize = 9;

/// Shows the digest.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, shown: &Shown, digest: &Digest) {
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
    part_line(ui, face);
    listing::show(ui, face, shown);
}

/// What just happened; what it is about is bold.
fn sentence(ui: &mut Ui, face: &Face<'_>, pieces: &[Piece]) {
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
    for piece in pieces {
        let mut format =
            TextFormat::simple(look.font(Text::Mono), if general { look.dim } else { look.text });
        format.line_height = Some(look.line_height(Text::Mono));
        if piece.strong {
            format.font_id = look.font(Text::MonoStrong);
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
        job.append(&piece.text, 0.0, format);
    }
    ui.label(job);
}
