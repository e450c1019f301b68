//! What leaves a page: its diagram as a picture, its results as a table.

use super::{Measure, Page};
use rasterscope_figure::figure::Figure;
use rasterscope_measure::{
    claims::CLAIMS,
    race::Row,
    tables::{claim_rows, to_csv, to_json},
};

/// A table for other programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// Comma-separated values.
    Csv,
    /// One object.
    Json,
}

impl Measure {
    /// The name that is offered for a file, without its ending.
    pub(crate) fn file_name(&self) -> String {
        let shown = &self.shown;
        match shown.page {
            Page::Errors => {
                let family = shown.family.map_or("all", |family| family.name());
                format!("{}-{family}", shown.stage().name)
            }
            Page::Claims => CLAIMS[shown.claim].name.to_owned(),
            Page::Growth => format!("growth-{}", shown.growing.name()),
        }
    }

    /// The diagram that is open, if something was measured.
    pub(crate) fn picture(&self) -> Option<&Figure> {
        self.figure()
    }

    /// The results that are shown; empty if nothing was measured.
    pub(crate) fn table(&self, format: Format) -> String {
        let Some(machine) = &self.machine else { return String::new() };
        let (shown, rounds) = (&self.shown, self.rounds);
        match shown.page {
            Page::Errors => {
                let filter = shown.filter();
                let rows: Vec<&Row> = self.rows.iter().filter(|row| filter.has(row)).collect();
                write(format, machine, rounds, &rows)
            }
            Page::Claims => {
                let found = CLAIMS.iter().zip(&self.findings);
                let rows = found.filter_map(|(claim, finding)| Some(claim_rows(claim, finding.as_ref()?)));
                write(format, machine, rounds, &rows.flatten().collect::<Vec<_>>())
            }
            Page::Growth => write(format, machine, rounds, &self.frames),
        }
    }
}

/// Results as a table.
pub(crate) fn write(
    format: Format,
    machine: &rasterscope_measure::Machine,
    rounds: u32,
    rows: &impl serde::Serialize,
) -> String {
    match format {
        Format::Csv => to_csv(machine, rounds, rows),
        Format::Json => to_json(machine, rounds, rows),
    }
}
