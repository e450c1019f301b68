//! The table: a row for each algorithm in each arithmetic, operation by operation, family by family.

use rasterscope_core::stress::Family;
use rasterscope_measure::{
    Stopwatch,
    race::{Row, STAGES, Stage},
};
use std::io::{self, Write};

use super::{BenchOptions, json, short, tell};
use crate::{progress::Progress, words};

pub(super) fn write(
    options: &BenchOptions,
    stopwatch: &Stopwatch<'_>,
    output: &mut dyn Write,
    progress: &mut Progress<'_>,
) -> io::Result<()> {
    let all = STAGES.iter().map(|stage| stage.families.len()).sum();
    let mut done = 0;
    for stage in &STAGES {
        for &family in stage.families {
            tell(progress, done, all, &words::of(&format!("bench-stage-{}", stage.name)));
            let rows = stage.measure(family, stopwatch).unwrap_or_default();
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
