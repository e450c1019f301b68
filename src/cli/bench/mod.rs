//! `rasterscope bench`: run time against error, the claims of the lectures, and how cost grows; as text and
//! JSON, and as pictures and tables in files.
//!
//! What is measured, and how, stands in [`rasterscope_measure`]; the clock is here. Each part is written as
//! soon as it is there, and a reader that leaves ends the work.

mod claims;
mod growth;
mod machine;
mod output;
pub mod skips;
mod table;

use rasterscope_core::{
    message::{Message, Value},
    stress::Family,
};
use rasterscope_figure::theme::ThemeName;
use rasterscope_measure::{Machine, Stopwatch, pictures::ErrorKind, race::Stage};
use serde::Serialize;
use std::{
    io::{self, Write},
    path::PathBuf,
    time::Instant,
};

use crate::{Failure, failure::written, progress::Progress, words};
pub use machine::machine;

/// What is measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Subject {
    /// Run time against error.
    #[default]
    Table,
    /// The claims of the lectures.
    Claims,
    /// How cost grows.
    Growth,
}

impl Subject {
    /// Those that have a name; the table is what is measured without one.
    pub const NAMED: [(&'static str, Self); 2] = [("claims", Self::Claims), ("growth", Self::Growth)];

    /// The name, if it has one.
    fn name(self) -> Option<&'static str> {
        Self::NAMED.into_iter().find(|(_, subject)| *subject == self).map(|(name, _)| name)
    }
}

/// What to measure, and how it is written.
#[derive(Clone, Debug)]
pub struct BenchOptions {
    /// What is measured.
    pub subject: Subject,
    /// Of the table: one operation, or all of them.
    pub operation: Option<&'static Stage>,
    /// Of the table: one family of inputs, or all of them.
    pub family: Option<Family>,
    /// The error of the table's picture.
    pub error: ErrorKind,
    /// One JSON object a line: the machine, then a row, a claim or a frame each.
    pub json: bool,
    /// How often each contender runs, at least once.
    pub rounds: u32,
    /// Where the picture or the table goes, too: `.svg`, `.png`, `.csv` or `.json`; of claims a folder.
    pub output: Option<PathBuf>,
    /// The colours of the picture.
    pub theme: ThemeName,
    /// A scene or a model that was named: refused, for what is measured here has inputs of its own.
    pub file: Option<PathBuf>,
}

impl BenchOptions {
    /// The work without a file, as text.
    pub fn new(subject: Subject, rounds: u32) -> Self {
        Self {
            subject,
            operation: None,
            family: None,
            error: ErrorKind::default(),
            json: false,
            rounds,
            output: None,
            theme: ThemeName::default(),
            file: None,
        }
    }
}

/// What measures, and for whom.
struct Bench<'a, 'p> {
    options: &'a BenchOptions,
    stopwatch: Stopwatch<'a>,
    machine: Machine,
    output: &'a mut dyn Write,
    progress: &'a mut Progress<'p>,
}

/// Measures, and writes each part as soon as it is there, then the file if one is wanted. A reader that leaves
/// ends the work.
pub fn bench(
    options: &BenchOptions,
    output: &mut dyn Write,
    progress: Option<&mut dyn Write>,
) -> Result<(), Failure> {
    output::check(options)?;
    let start = Instant::now();
    let now = || start.elapsed().as_secs_f64();
    let stopwatch = Stopwatch { rounds: options.rounds.max(1), now: &now, wanted: &|| true };
    let progress = &mut Progress(progress);
    let mut bench = Bench { options, stopwatch, machine: machine(), output, progress };
    let files = bench.write_machine().and_then(|()| match options.subject {
        Subject::Table => table::write(&mut bench),
        Subject::Claims => claims::write(&mut bench),
        Subject::Growth => growth::write(&mut bench),
    });
    bench.progress.clear();
    match files {
        Ok(files) => output::write(options, files),
        Err(error) => written(Err(error)),
    }
}

impl Bench<'_, '_> {
    /// Where the numbers were made: with them always, for they mean nothing elsewhere.
    fn write_machine(&mut self) -> io::Result<()> {
        let machine = &self.machine;
        if self.options.json {
            let line = serde_json::json!({ "machine": machine, "rounds": self.stopwatch.rounds });
            return json(&line, self.output);
        }
        writeln!(self.output, "{}", words::say(&machine.message()))
    }

    /// A bar of a terminal, and what is being done.
    fn tell(&mut self, done: usize, all: usize, what: &str) {
        tell(self.progress, done, all, what);
    }
}

/// A bar of a terminal, and what is being done.
fn tell(progress: &mut Progress<'_>, done: usize, all: usize, what: &str) {
    const WIDTH: usize = 24;
    let full = done * WIDTH / all.max(1);
    let bar = format!("{}{}", "█".repeat(full), "░".repeat(WIDTH - full));
    let count = |count: usize| Value::Int(count as i64);
    let message = Message::new("bench-progress").with("bar", Value::text(bar));
    let message = message.with("done", count(done)).with("all", count(all));
    progress.say(&message.with("what", Value::text(what)));
}

fn json(value: &impl Serialize, output: &mut dyn Write) -> io::Result<()> {
    serde_json::to_writer(&mut *output, value)?;
    writeln!(output)
}

/// A number that may be large, in few characters.
fn short(number: f64) -> String {
    if number == 0.0 {
        "0".into()
    } else if number >= 1e5 {
        format!("{number:.1e}")
    } else if number == number.trunc() {
        format!("{number:.0}")
    } else {
        format!("{number:.3}")
    }
}
