//! What goes to files: the picture or the table, as the name ends.

use rasterscope_core::message::{Message, Value};
use rasterscope_figure::{figure::Figure, png, svg};
use rasterscope_measure::tables;
use serde::Serialize;
use std::path::{Path, PathBuf};

use super::{Bench, BenchOptions, Subject};
use crate::{Failure, files};

/// What is written in the end.
#[derive(Debug)]
pub(super) struct File {
    path: PathBuf,
    bytes: Vec<u8>,
}

const ENDINGS: [&str; 4] = ["svg", "png", "csv", "json"];

fn ending(path: &Path) -> Option<&'static str> {
    let ending = path.extension()?.to_ascii_lowercase();
    ENDINGS.into_iter().find(|each| ending == **each)
}

/// Refuses an input, and a name with another ending, before anything is measured.
pub(super) fn check(options: &BenchOptions) -> Result<(), Failure> {
    if let Some(file) = &options.file {
        let what = Value::text(options.subject.name().unwrap_or_default());
        let message = Message::new("error-bench-file").with("what", what);
        return Err(Failure::usage(&message.with("file", Value::text(file.display()))));
    }
    match &options.output {
        Some(path) if options.subject != Subject::Claims && ending(path).is_none() => {
            let file = Value::text(path.display());
            Err(Failure::usage(&Message::new("error-bench-ending").with("file", file)))
        }
        _ => Ok(()),
    }
}

/// Results as the path ends: as a picture, or as a table.
pub(super) fn file(
    path: &Path,
    bench: &Bench<'_, '_>,
    picture: impl FnOnce() -> Figure,
    results: &impl Serialize,
) -> File {
    let (machine, rounds) = (&bench.machine, bench.stopwatch.rounds);
    let bytes = match ending(path) {
        Some("svg") => svg::svg(&picture()).into_bytes(),
        Some("png") => png::png(&picture(), crate::figure::PIXELS_PER_POINT),
        Some("csv") => tables::to_csv(machine, rounds, results).into_bytes(),
        _ => tables::to_json(machine, rounds, results).into_bytes(),
    };
    File { path: path.to_owned(), bytes }
}

/// Writes each file whole or not at all.
pub(super) fn write(options: &BenchOptions, all: Vec<File>) -> Result<(), Failure> {
    if let (Some(folder), Subject::Claims) = (&options.output, options.subject) {
        files::make_folder(folder)?;
    }
    all.iter().try_for_each(|File { path, bytes }| files::write(path, bytes))
}
