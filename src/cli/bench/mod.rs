//! `rasterscope bench`: run time against error, and the claims of the lectures, as text and JSON.
//!
//! What is measured, and how, stands in [`rasterscope_measure`]; the clock is here. Each part is written as
//! soon as it is there, and a reader that leaves ends the work.

mod claims;
mod machine;
mod table;

use rasterscope_core::message::{Message, Value};
use rasterscope_measure::Stopwatch;
use serde::Serialize;
use std::{
    io::{self, Write},
    time::Instant,
};

use crate::{Failure, failure::written, progress::Progress, words};
pub use machine::machine;

/// What to measure, and how it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BenchOptions {
    /// The claims of the lectures instead of the table.
    pub claims: bool,
    /// One JSON object a line: the machine, then a row or a claim each.
    pub json: bool,
    /// How often each contender runs, at least once.
    pub rounds: u32,
}

impl BenchOptions {
    /// Enough for a steady median, in less than a minute.
    pub const ROUNDS: u32 = 15;
}

/// Measures, and writes each part as soon as it is there. A reader that leaves ends the work.
pub fn bench(
    options: &BenchOptions,
    output: &mut dyn Write,
    progress: Option<&mut dyn Write>,
) -> Result<(), Failure> {
    let start = Instant::now();
    let stopwatch =
        Stopwatch { rounds: options.rounds.max(1), now: &|| start.elapsed().as_secs_f64(), wanted: &|| true };
    let mut progress = Progress(progress);
    let result = write_machine(options, output).and_then(|()| {
        if options.claims {
            claims::write(options, &stopwatch, output, &mut progress)
        } else {
            table::write(options, &stopwatch, output, &mut progress)
        }
    });
    progress.clear();
    written(result)
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

/// Where the numbers were made: with them always, for they mean nothing elsewhere.
fn write_machine(options: &BenchOptions, output: &mut dyn Write) -> io::Result<()> {
    let machine = machine();
    if options.json {
        return json(&serde_json::json!({ "machine": machine, "rounds": options.rounds.max(1) }), output);
    }
    writeln!(output, "{}", words::say(&machine.message()))
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
