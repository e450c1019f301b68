//! `bench`: the shape of what it writes, and that inputs and errors are the same on every run. Times are
//! not tested: they are the machine's.

use rasterscope_cli::bench::{BenchOptions, bench};
use serde_json::Value;
use std::{
    collections::BTreeSet,
    io::{self, Write},
    sync::LazyLock,
};

fn json(claims: bool) -> Vec<Value> {
    let mut out = Vec::new();
    bench(&BenchOptions { claims, json: true, rounds: 1 }, &mut out, None).expect("it runs");
    let text = String::from_utf8(out).expect("text");
    text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
}

static TABLE: LazyLock<Vec<Value>> = LazyLock::new(|| json(false));

fn names(rows: &[Value], field: &str) -> BTreeSet<String> {
    rows.iter().filter_map(|row| row[field].as_str()).map(String::from).collect()
}

#[test]
fn each_line_is_a_row_with_time_and_error() {
    let (machine, rows) = TABLE.split_first().expect("lines");
    assert!(machine["machine"]["processors"].as_u64().is_some_and(|count| count > 0));
    assert!(machine["machine"]["build"].is_string() && machine["rounds"] == 1);
    let stages =
        ["attributes", "coverage", "depth", "homogeneous-clipping", "line-clipping", "polygon-clipping"];
    assert_eq!(names(rows, "stage"), stages.map(String::from).into());
    for row in rows {
        assert!(row["ns"].as_f64().is_some_and(|ns| ns > 0.0), "{row}");
        assert!(row["quartiles"].as_array().is_some_and(|quartiles| quartiles.len() == 2), "{row}");
        assert!(row["items"].as_u64().is_some_and(|items| items > 0), "{row}");
        let judged = row["decisions"].as_u64().unwrap_or(0) + row["values"].as_u64().unwrap_or(0);
        assert!(judged > 0, "nothing was held against the exact answer: {row}");
        for field in ["wrong_per_million", "mean_ulps", "max_ulps", "not_finite"] {
            assert!(row[field].is_number(), "{row}");
        }
    }
    let coverage: Vec<Value> = rows.iter().filter(|row| row["stage"] == "coverage").cloned().collect();
    assert_eq!((names(&coverage, "algorithm").len(), names(&coverage, "arithmetic").len()), (6, 6));
}

#[test]
fn exact_rows_are_right_and_each_stage_shows_rounding_fail() {
    let rows = &TABLE[1..];
    for row in rows.iter().filter(|row| row["arithmetic"] == "exact") {
        // Midpoint subdivision halves until two numbers are left: the next one may be nearer.
        let most = if row["algorithm"] == "midpoint" { 1 } else { 0 };
        assert_eq!(row["wrong_per_million"], 0.0, "{row}");
        assert!(row["max_ulps"].as_u64().is_some_and(|ulps| ulps <= most), "{row}");
        assert_eq!(row["not_finite"], 0, "{row}");
    }
    for stage in names(rows, "stage") {
        let fails = |row: &&Value| row["wrong_per_million"] != 0.0 || row["max_ulps"] != 0;
        let f32_rows = rows.iter().filter(|row| row["stage"] == stage.as_str() && row["arithmetic"] == "f32");
        assert!(f32_rows.filter(fails).count() > 0, "{stage}");
    }
}

#[test]
fn inputs_and_errors_are_the_same_on_every_run() {
    let untimed = |rows: &[Value]| {
        let mut rows = rows.to_vec();
        for row in rows.iter_mut().filter_map(Value::as_object_mut) {
            row.retain(|field, _| field != "ns" && field != "quartiles");
        }
        rows
    };
    for (first, second) in untimed(&TABLE).iter().zip(&untimed(&json(false))) {
        assert_eq!(first, second);
    }
}

#[test]
fn every_claim_has_numbers_and_a_verdict() {
    let [first, second] = [json(true), json(true)].map(|lines| lines[1..].to_vec());
    assert_eq!(first.len(), 9);
    for (claim, again) in first.iter().zip(&second) {
        let verdict = claim["verdict"].as_str().expect("a verdict");
        assert!(["holds", "under-a-condition", "does-not-hold"].contains(&verdict));
        let [series, others] = [claim, again].map(|claim| claim["series"].as_array().expect("series"));
        assert!(!series.is_empty());
        for (series, other) in series.iter().zip(others) {
            let numbers = series["numbers"].as_array().expect("numbers");
            assert!(numbers.iter().all(|number| number["value"].is_number()), "{series}");
            assert!(series["counted"] == false || series == other, "{series} {other}");
        }
    }
}

/// Takes some lines, then its reader has gone.
struct Reader {
    read: Vec<u8>,
    lines: usize,
}

impl Write for Reader {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.read.iter().filter(|byte| **byte == b'\n').count() >= self.lines {
            return Err(io::ErrorKind::BrokenPipe.into());
        }
        self.read.extend(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_reader_that_leaves_ends_the_work_early_and_sees_whole_tables() {
    let mut reader = Reader { read: Vec::new(), lines: 12 };
    let mut terminal = Vec::new();
    let options = BenchOptions { claims: false, json: false, rounds: 1 };
    bench(&options, &mut reader, Some(&mut terminal)).expect("no failure");
    let text = String::from_utf8(reader.read).expect("text");
    assert_eq!(text.lines().count(), 12);
    for part in ["\nLine clipping, ordinary\n", "ns a segment", "at-once, exact, fast call"] {
        assert!(text.contains(part), "{part:?} in\n{text}");
    }
    let terminal = String::from_utf8(terminal).expect("text");
    assert!(terminal.contains("0 of 41") && !terminal.contains("2 of 41"), "{terminal}");
    assert!(terminal.ends_with("\x1b[K"), "the bar is gone at the end");
}

#[test]
fn claims_read_as_sentences() {
    let mut out = Vec::new();
    let options = BenchOptions { claims: true, json: false, rounds: 1 };
    bench(&options, &mut out, None).expect("it runs");
    let text = String::from_utf8(out).expect("text");
    assert!(!text.contains('⟨'), "{text}");
    assert_eq!(text.matches("  It ").count(), 9, "{text}");
    for part in text.split("\n\n").skip(1) {
        let lines: Vec<_> = part.lines().collect();
        assert!(lines[0].ends_with('.') && lines.len() > 2, "{part}");
        assert!(lines[1..].iter().all(|line| !line.starts_with("     ")), "a series has no name: {part}");
    }
}
