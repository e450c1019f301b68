//! `rasterscope trace`: the events of a run, one a line.

use rasterscope_core::{
    explain::{Level, Row, Table},
    labs,
    message::{Message, Value},
    replay::{Budget, Playback},
};
use rasterscope_figure::{
    numbers,
    tables::{self, TextTable},
};
use serde::Serialize;
use serde_json::json;
use std::{
    io::{self, Write},
    path::PathBuf,
};

use crate::{
    Failure,
    failure::written,
    files,
    words::{WORDS, say},
};

/// How a trace is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TraceFormat {
    /// For people: step, listing line, sentence and the values that changed.
    #[default]
    Text,
    /// For programs: one object a line, with all values.
    Json,
}

impl TraceFormat {
    /// Both formats, the default first.
    pub const ALL: [Self; 2] = [Self::Text, Self::Json];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Json => "json",
        }
    }
}

/// What to trace.
#[derive(Clone, Debug)]
pub struct TraceOptions {
    /// The lab's name.
    pub algorithm: String,
    /// A scene or a `compute` request.
    pub file: PathBuf,
    /// How it is written.
    pub format: TraceFormat,
}

/// Writes every event of a run, one a line, in order.
pub fn trace(options: &TraceOptions, output: &mut dyn Write) -> Result<(), Failure> {
    let mut run = play(&options.algorithm, &options.file)?;
    written(match options.format {
        TraceFormat::Text => write_text(&mut *run, output),
        TraceFormat::Json => write_json(&mut *run, output),
    })
}

/// The run of a lab on a FILE, at step 0.
pub(crate) fn play(lab: &str, file: &std::path::Path) -> Result<Box<dyn Playback>, Failure> {
    check_name(lab)?;
    let scene = files::open_lab(lab, file)?;
    labs::play(&scene, Budget::default()).map_err(|message| Failure::work(&message))
}

/// Refuses what is no lab's name.
pub(crate) fn check_name(lab: &str) -> Result<(), Failure> {
    if labs::find(lab).is_some() {
        return Ok(());
    }
    let known: Vec<_> = labs::ALL.iter().map(|lab| lab.name).collect();
    let message = Message::new("error-unknown-lab").with("lab", Value::text(lab));
    Err(Failure::usage(&message.with("known", Value::text(known.join(", ")))))
}

/// Step, line of the listing, sentence, and the values that changed, in columns.
fn write_text(run: &mut dyn Playback, output: &mut dyn Write) -> io::Result<()> {
    let listing = run.listing();
    let step_width = run.len().to_string().len();
    let code_width = listing.iter().map(|line| line.trim().chars().count()).max().unwrap_or(0);
    let mut before = run.tables();
    for step in 1..=run.len() {
        run.seek(step);
        let after = run.tables();
        let line = run.line().unwrap_or(0);
        let code = listing.get(line).map_or("", |code| code.trim());
        let changes = changes(&tables::format(&after, &before, &WORDS));
        let (number, sentence) = (line + 1, say(&run.sentence()));
        write!(output, "{step:>step_width$}  {number:>2} {code:<code_width$}  {sentence}")?;
        writeln!(output, "{}{changes}", if changes.is_empty() { "" } else { "  " })?;
        before = after;
    }
    output.flush()
}

/// `[P1 x 0, y 1.5; OR 0010]`, or nothing.
fn changes(tables: &[TextTable]) -> String {
    let rows = tables.iter().flat_map(|table| table.rows.iter().map(move |row| (table, row)));
    let rows = rows.filter(|(_, row)| row.changed()).map(|(table, row)| {
        let cells = row.cells.iter().zip(&table.columns).filter(|(cell, _)| cell.changed);
        let cells: Vec<_> = cells.map(|(cell, column)| format!("{column} {}", cell.text)).collect();
        format!("{} {}", row.name, cells.join(", "))
    });
    let rows: Vec<_> = rows.collect();
    if rows.is_empty() { String::new() } else { format!("[{}]", rows.join("; ")) }
}

/// One event for programs.
#[derive(Serialize)]
struct Line<'a> {
    /// The step that the event leads to, from 1.
    step: usize,
    /// The line of the listing, from 1.
    line: Option<usize>,
    code: &'a str,
    level: &'static str,
    sentence: String,
    event: serde_json::Value,
    values: Vec<serde_json::Value>,
}

fn write_json(run: &mut dyn Playback, output: &mut dyn Write) -> io::Result<()> {
    let listing = run.listing();
    for step in 1..=run.len() {
        run.seek(step);
        let line = run.line();
        let line = Line {
            step,
            line: line.map(|line| line + 1),
            code: line.and_then(|line| listing.get(line)).map_or("", |code| code.trim()),
            level: run.level().unwrap_or(Level::Detail).name(),
            sentence: say(&run.sentence()),
            event: run.event_json().unwrap_or_default(),
            values: run.tables().iter().map(table_json).collect(),
        };
        serde_json::to_writer(&mut *output, &line)?;
        output.write_all(b"\n")?;
    }
    output.flush()
}

fn table_json(table: &Table) -> serde_json::Value {
    let heading =
        |id: &&'static str| if id.starts_with("column-") { WORDS.word(id) } else { (*id).to_owned() };
    let row = |row: &Row| json!({"name": tables::row_name(&row.name, &WORDS), "active": row.active, "cells": row.cells.iter().map(value_json).collect::<Vec<_>>()});
    json!({
        "title": WORDS.word(table.title),
        "columns": table.columns.iter().map(heading).collect::<Vec<_>>(),
        "rows": table.rows.iter().map(row).collect::<Vec<_>>(),
    })
}

/// The value itself where JSON has it, else as it is shown.
fn value_json(value: &Value) -> serde_json::Value {
    match value {
        Value::None => serde_json::Value::Null,
        Value::Int(n) => json!(n),
        Value::F32(x) if x.is_finite() => json!(f64::from(*x)),
        Value::F64(x) if x.is_finite() => json!(x),
        Value::Vector(list) => list.iter().map(|&x| value_json(&Value::F32(x))).collect(),
        Value::Bits { bits, width } => json!(format!("{bits:0width$b}", width = usize::from(*width))),
        Value::Word(id) => json!(WORDS.word(id)),
        Value::F32(_) | Value::F64(_) | Value::Code { .. } | Value::Text(_) => json!(numbers::short(value)),
    }
}
