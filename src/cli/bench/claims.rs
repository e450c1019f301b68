//! The claims of the lectures, as sentences with numbers.

use rasterscope_figure::plot;
use rasterscope_measure::{
    claims::{CLAIMS, Finding, Number, Series},
    pictures, tables,
};
use std::io::{self, Write};

use super::{
    Bench, json,
    output::{File, file},
    short,
};
use crate::words::{self, WORDS};

/// Width and height of a diagram, in points.
const SIZE: [f32; 2] = [960.0, 600.0];

pub(super) fn write(bench: &mut Bench<'_, '_>) -> io::Result<Vec<File>> {
    let options = bench.options;
    let (mut files, mut all) = (Vec::new(), Vec::new());
    for (done, claim) in CLAIMS.iter().enumerate() {
        let sentence = words::of(&format!("bench-claim-{}", claim.name));
        bench.tell(done, CLAIMS.len(), &sentence);
        let Some(finding) = claim.examine(&bench.stopwatch) else { continue };
        bench.progress.clear();
        let Finding { series, verdict } = &finding;
        if options.json {
            let line = serde_json::json!({ "claim": claim.name, "series": series, "verdict": verdict });
            json(&line, bench.output)?;
        } else {
            writeln!(bench.output, "\n{sentence}")?;
            series.iter().try_for_each(|series| write_series(series, bench.output))?;
            let here = words::of(&format!("bench-claim-{}-here", claim.name));
            let verdict = words::of(&format!("bench-verdict-{}", verdict.name()));
            writeln!(bench.output, "  {verdict} {here}")?;
        }
        bench.output.flush()?;
        if let Some(folder) = &options.output {
            let path = folder.join(format!("{}.svg", claim.name));
            let picture = || {
                let chart = pictures::claim(claim, &finding, &bench.machine, options.rounds, &WORDS);
                plot::draw(&chart.plot, SIZE, options.theme.theme(), None).figure
            };
            files.push(file(&path, bench, picture, &()));
            all.extend(tables::claim_rows(claim, &finding));
        }
    }
    if let Some(folder) = &options.output {
        let no_picture = || plot::panels(&[], 1, SIZE, options.theme.theme()).figure;
        files.push(file(&folder.join("claims.csv"), bench, no_picture, &all));
    }
    Ok(files)
}

/// Its name, then each number below what was varied.
fn write_series(series: &Series, output: &mut dyn Write) -> io::Result<()> {
    write!(output, "  {:<44}", words::of(&format!("bench-series-{}", series.name)))?;
    for Number { at, value } in &series.numbers {
        write!(output, "  {at}: {}", short(*value))?;
    }
    writeln!(output)
}
