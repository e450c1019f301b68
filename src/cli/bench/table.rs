//! The table: a row for each algorithm in each arithmetic, operation by operation, family by family.

use rasterscope_core::stress::Family;
use rasterscope_figure::plot::{self, Plot};
use rasterscope_measure::{
    pictures::{self, Filter},
    race::{Row, STAGES, Stage},
};
use std::io::{self, Write};

use super::{
    Bench, json,
    output::{File, file},
    short,
};
use crate::words::{self, WORDS};

/// Width and height of one diagram, in points.
const ONE: [f32; 2] = [1_000.0, 680.0];

pub(super) fn write(bench: &mut Bench<'_, '_>) -> io::Result<Vec<File>> {
    let options = bench.options;
    let wanted = |stage: &&Stage| options.operation.is_none_or(|operation| operation.name == stage.name);
    let stages: Vec<&'static Stage> = STAGES.iter().filter(wanted).collect();
    let heats = stages.iter().flat_map(|stage| stage.families.iter().map(move |family| (*stage, *family)));
    let heats: Vec<_> =
        heats.filter(|(_, family)| options.family.is_none_or(|only| only == *family)).collect();
    let mut all = Vec::new();
    for (done, (stage, family)) in heats.iter().enumerate() {
        bench.tell(done, heats.len(), &words::of(&format!("bench-stage-{}", stage.name)));
        let rows = stage.measure(*family, &bench.stopwatch).unwrap_or_default();
        bench.progress.clear();
        if options.json {
            rows.iter().try_for_each(|row| json(row, bench.output))?;
        } else {
            write_rows(stage, *family, &rows, bench.output)?;
        }
        bench.output.flush()?;
        all.extend(rows);
    }
    let Some(path) = &options.output else { return Ok(Vec::new()) };
    let picture = || {
        let plot = |stage: &&'static Stage| -> Plot {
            let filter = Filter { stage, family: options.family, error: options.error };
            pictures::errors(&all, &filter, &bench.machine, options.rounds, &WORDS).plot
        };
        let plots: Vec<Plot> = stages.iter().map(plot).collect();
        let columns = plots.len().clamp(1, 2);
        let size = [ONE[0] * columns as f32, ONE[1] * plots.len().div_ceil(columns) as f32];
        plot::panels(&plots, columns, size, options.theme.theme()).figure
    };
    Ok(vec![file(path, bench, picture, &all)])
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
