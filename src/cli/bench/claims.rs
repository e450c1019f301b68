//! The claims of the lectures, as sentences with numbers.

use rasterscope_measure::{
    Stopwatch,
    claims::{CLAIMS, Finding, Number, Series},
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
    for (done, claim) in CLAIMS.iter().enumerate() {
        let sentence = words::of(&format!("bench-claim-{}", claim.name));
        tell(progress, done, CLAIMS.len(), &sentence);
        let Some(Finding { series, verdict }) = claim.examine(stopwatch) else { return Ok(()) };
        progress.clear();
        if options.json {
            json(&serde_json::json!({ "claim": claim.name, "series": series, "verdict": verdict }), output)?;
        } else {
            writeln!(output, "\n{sentence}")?;
            series.iter().try_for_each(|series| write_series(series, output))?;
            let here = words::of(&format!("bench-claim-{}-here", claim.name));
            writeln!(output, "  {} {here}", words::of(&format!("bench-verdict-{}", verdict.name())))?;
        }
        output.flush()?;
    }
    Ok(())
}

/// Its name, then each number below what was varied.
fn write_series(series: &Series, output: &mut dyn Write) -> io::Result<()> {
    write!(output, "  {:<44}", words::of(&format!("bench-series-{}", series.name)))?;
    for Number { at, value } in &series.numbers {
        write!(output, "  {at}: {}", short(*value))?;
    }
    writeln!(output)
}
