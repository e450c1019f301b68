//! Results as text for other programs: comma-separated values, and JSON.

use serde::Serialize;
use serde_json::{Value, json};

use crate::{
    Machine,
    claims::{Claim, Finding},
    skips::picture::Bar,
};
use rasterscope_core::pipeline::Skip;
use rasterscope_figure::words::Words;

/// One object: the machine, the rounds, and the results.
pub fn to_json(machine: &Machine, rounds: u32, results: &impl Serialize) -> String {
    // Structs of numbers and names have no way to fail.
    let text =
        serde_json::to_string_pretty(&json!({ "machine": machine, "rounds": rounds, "results": results }));
    text.unwrap_or_default() + "\n"
}

/// A line for each result, below the names of its fields; the machine is in the first line, behind a `#`.
pub fn to_csv(machine: &Machine, rounds: u32, results: &impl Serialize) -> String {
    let mut out = format!("# {}; {rounds} rounds\n", serde_json::to_string(machine).unwrap_or_default());
    let results = serde_json::to_value(results).unwrap_or_default();
    let rows: Vec<_> = results.as_array().into_iter().flatten().filter_map(Value::as_object).collect();
    if let Some(first) = rows.first() {
        out.push_str(&(first.keys().map(String::as_str).collect::<Vec<_>>().join(",") + "\n"));
    }
    for row in rows {
        out.push_str(&(row.values().map(field).collect::<Vec<_>>().join(",") + "\n"));
    }
    out
}

/// A field: what has commas is quoted.
fn field(value: &Value) -> String {
    let text = match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        Value::Array(all) => all.iter().map(field).collect::<Vec<_>>().join(" "),
        other => other.to_string(),
    };
    if text.contains([',', '"', '\n']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

/// One number of a claim.
#[derive(Clone, Debug, Serialize)]
pub struct ClaimRow {
    claim: &'static str,
    verdict: &'static str,
    series: &'static str,
    counted: bool,
    at: String,
    value: f64,
}

/// The numbers of a claim, one by one.
pub fn claim_rows(claim: &Claim, finding: &Finding) -> Vec<ClaimRow> {
    let verdict = finding.verdict.name();
    let rows = finding.series.iter().flat_map(|series| {
        series.numbers.iter().map(move |number| ClaimRow {
            claim: claim.name,
            verdict,
            series: series.name,
            counted: series.counted,
            at: number.at.to_string(),
            value: number.value,
        })
    });
    rows.collect()
}

/// What one skip leaves out of an image; the last two if it was measured.
#[derive(Clone, Debug, Serialize)]
pub struct SkipRow {
    skip: Skip,
    left_out: u64,
    done: Option<u64>,
    unit: String,
    ratio: Option<f64>,
    same: Option<bool>,
}

/// The skips one by one.
pub fn skip_rows(bars: &[Bar], words: &Words) -> Vec<SkipRow> {
    let row = |Bar { skip, work, measured }: &Bar| SkipRow {
        skip: *skip,
        left_out: work.left_out,
        done: work.done,
        unit: words.word(work.unit),
        ratio: measured.map(|(ratio, _)| ratio),
        same: measured.map(|(_, same)| same),
    };
    bars.iter().map(row).collect()
}
