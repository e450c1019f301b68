//! `rasterscope bench claims`: what the lectures say about cost, measured here.

mod clipping;
mod culling;
mod pixels;

use serde::Serialize;
use std::{
    io::{self, Write},
    time::Instant,
};

use super::{BenchOptions, json, race::summary, short, tell, write_machine};
use crate::{progress::Progress, words};

/// Whether a claim is true on this machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Verdict {
    Holds,
    /// It holds where the claim's own words below the numbers say.
    UnderACondition,
    DoesNotHold,
}

impl Verdict {
    /// From what each case of a claim says.
    fn of(cases: impl IntoIterator<Item = bool>) -> Self {
        let (mut some, mut all) = (false, true);
        cases.into_iter().for_each(|holds| (some, all) = (some | holds, all & holds));
        match (some, all) {
            (true, true) => Self::Holds,
            (true, false) => Self::UnderACondition,
            (false, _) => Self::DoesNotHold,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::UnderACondition => "under-a-condition",
            Self::DoesNotHold => "does-not-hold",
        }
    }
}

/// One number of an experiment.
#[derive(Debug, Serialize)]
struct Number {
    /// What was varied, such as how many triangles there were.
    at: String,
    value: f64,
}

/// Numbers of one kind.
#[derive(Debug, Serialize)]
struct Series {
    /// `bench-series-NAME` is what it is and its unit.
    name: &'static str,
    /// Whether it counts, and so is the same on every machine.
    counted: bool,
    numbers: Vec<Number>,
}

impl Series {
    fn timed(name: &'static str, numbers: impl IntoIterator<Item = (impl ToString, f64)>) -> Self {
        let numbers = numbers.into_iter().map(|(at, value)| Number { at: at.to_string(), value }).collect();
        Self { name, counted: false, numbers }
    }

    fn counted(name: &'static str, numbers: impl IntoIterator<Item = (impl ToString, f64)>) -> Self {
        Self { counted: true, ..Self::timed(name, numbers) }
    }
}

/// What came out.
struct Finding {
    series: Vec<Series>,
    verdict: Verdict,
}

/// A claim and its experiment.
struct Claim {
    /// `bench-claim-NAME` is its sentence, `bench-claim-NAME-here` what was found about it.
    name: &'static str,
    run: fn(u32) -> Finding,
}

const CLAIMS: [Claim; 9] = [
    Claim { name: "culling-removes-half", run: culling::removes_half },
    Claim { name: "cull-before-clipping", run: culling::before_clipping },
    Claim { name: "outcodes-when-outside", run: clipping::outcodes_when_outside },
    Claim { name: "no-division-to-decide", run: clipping::no_division_to_decide },
    Claim { name: "z-buffer-constant", run: pixels::z_buffer_constant },
    Claim { name: "regions-save-tests", run: pixels::regions_save_tests },
    Claim { name: "fixed-point-is-enough", run: pixels::fixed_point_is_enough },
    Claim { name: "additions-are-cheap", run: pixels::additions_are_cheap },
    Claim { name: "row-coherence", run: pixels::row_coherence },
];

pub(super) fn write(
    options: &BenchOptions,
    output: &mut dyn Write,
    progress: &mut Progress<'_>,
) -> io::Result<()> {
    write_machine(options, output)?;
    for (done, claim) in CLAIMS.iter().enumerate() {
        let sentence = words::of(&format!("bench-claim-{}", claim.name));
        tell(progress, done, CLAIMS.len(), &sentence);
        let Finding { series, verdict } = (claim.run)(options.rounds);
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

/// The median time of each of some runs, which take turns, in ns.
fn times<const N: usize>(rounds: u32, mut runs: [&mut dyn FnMut(); N]) -> [f64; N] {
    let mut times: [Vec<f64>; N] = std::array::from_fn(|_| Vec::new());
    for round in 0..=rounds {
        for (run, times) in runs.iter_mut().zip(&mut times) {
            let start = Instant::now();
            run();
            let elapsed = start.elapsed().as_secs_f64() * 1e9;
            if round > 0 {
                times.push(elapsed);
            }
        }
    }
    times.map(|times| summary(times)[1])
}
