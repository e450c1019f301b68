//! `rasterscope bench`: run time against error, every algorithm in every arithmetic, side by side.
//!
//! A stage is measured family by family. All contenders of a family take turns, round by round, so that
//! a busy moment of the machine hits them all; only times of one family are to be compared. Inputs are
//! the same on every run and machine. Each answer is held against the exact one, which is found in
//! another way than the row's own: with the vertices in another order, or by another algorithm. This is
//! the only module that reads a clock.

mod attributes;
mod claims;
mod coverage;
mod depth;
mod family;
mod homogeneous;
mod lines;
mod machine;
mod polygons;
mod race;
mod random;

use rasterscope_core::message::{Message, Value};
use serde::Serialize;
use std::io::{self, Write};

use crate::{Failure, failure::written, progress::Progress, words};
use family::Family;
use machine::Machine;
use race::Row;

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

/// One stage of the table.
struct Stage {
    name: &'static str,
    families: &'static [Family],
    run: fn(Family, u32) -> Vec<Row>,
}

const STAGES: [Stage; 6] = [
    Stage { name: lines::STAGE, families: lines::FAMILIES, run: lines::run },
    Stage { name: polygons::STAGE, families: polygons::FAMILIES, run: polygons::run },
    Stage { name: homogeneous::STAGE, families: homogeneous::FAMILIES, run: homogeneous::run },
    Stage { name: coverage::STAGE, families: coverage::FAMILIES, run: coverage::run },
    Stage { name: depth::STAGE, families: depth::FAMILIES, run: depth::run },
    Stage { name: attributes::STAGE, families: attributes::FAMILIES, run: attributes::run },
];

/// Measures, and writes each part as soon as it is there. A reader that leaves ends the work.
pub fn bench(
    options: &BenchOptions,
    output: &mut dyn Write,
    progress: Option<&mut dyn Write>,
) -> Result<(), Failure> {
    let options = BenchOptions { rounds: options.rounds.max(1), ..*options };
    let mut progress = Progress(progress);
    let result = if options.claims {
        claims::write(&options, output, &mut progress)
    } else {
        table(&options, output, &mut progress)
    };
    progress.clear();
    written(result)
}

fn table(options: &BenchOptions, output: &mut dyn Write, progress: &mut Progress<'_>) -> io::Result<()> {
    write_machine(options, output)?;
    let all = STAGES.iter().map(|stage| stage.families.len()).sum();
    let mut done = 0;
    for stage in &STAGES {
        for &family in stage.families {
            let what = format!("bench-stage-{}", stage.name);
            tell(progress, done, all, &words::of(&what));
            let rows = (stage.run)(family, options.rounds);
            progress.clear();
            if options.json {
                rows.iter().try_for_each(|row| json(row, output))?;
            } else {
                write_rows(stage, family, &rows, output)?;
            }
            output.flush()?;
            done += 1;
        }
    }
    Ok(())
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
    let machine = Machine::here();
    if options.json {
        return json(&serde_json::json!({ "machine": machine, "rounds": options.rounds }), output);
    }
    let Machine { processor, processors, system, architecture, version, build, vectors } = machine;
    let message = Message::new("bench-machine")
        .with(
            "processor",
            Value::text(if processor.is_empty() { architecture.to_string() } else { processor }),
        )
        .with("count", Value::Int(processors as i64))
        .with("system", Value::text(format!("{system} {architecture}")))
        .with("version", Value::text(version))
        .with("build", Value::text(build))
        .with("vectors", Value::text(vectors));
    writeln!(output, "{}", words::say(&message))
}

const COLUMNS: [&str; 6] = ["ns", "quartiles", "wrong", "mean", "max", "exact"];

fn write_rows(stage: &Stage, family: Family, rows: &[Row], output: &mut dyn Write) -> io::Result<()> {
    let Some(first) = rows.first() else { return Ok(()) };
    let of = |kind: &str, name: &str| words::of(&format!("bench-{kind}-{name}"));
    writeln!(output, "\n{}, {}", of("stage", stage.name), of("family", family.name()))?;
    let item = of("item", first.item);
    let [ns, quartiles, wrong, mean, max, exact] = COLUMNS.map(|column| of("column", column));
    writeln!(
        output,
        "{:<34} {:>10} {quartiles:>17} {wrong:>11} {mean:>11} {max:>11} {exact:>10}",
        "",
        format!("{ns} {item}"),
    )?;
    for row in rows {
        let name = format!("{}, {}", row.algorithm, row.arithmetic.name());
        let name = if row.call == "fast" { format!("{name}, {}", of("call", "fast")) } else { name };
        let [low, high] = row.quartiles;
        let wrong = if row.decisions == 0 { String::new() } else { format!("{:.0}", row.wrong_per_million) };
        let mean = if row.values == 0 { String::new() } else { short(row.mean_ulps) };
        let max = match (row.values, row.not_finite) {
            (0, _) => String::new(),
            (_, 0) => short(row.max_ulps as f64),
            (..) => of("column", "not-finite"),
        };
        let exact = row.exact_share.map_or(String::new(), |share| format!("{:.3} %", share * 100.0));
        writeln!(
            output,
            "{name:<34} {:>10.1} {:>17} {wrong:>11} {mean:>11} {max:>11} {exact:>10}",
            row.ns,
            format!("{low:.1} - {high:.1}"),
        )?;
    }
    Ok(())
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
