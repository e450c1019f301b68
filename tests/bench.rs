//! `bench`: the shape of what it writes, and that inputs and errors are the same on every run. Times are
//! not tested: they are the machine's.

use crate::cli::folder;
use rasterscope_cli::bench::{BenchOptions, Subject, bench};
use rasterscope_core::stress::Family;
use rasterscope_measure::{claims::CLAIMS, race::Stage};
use serde_json::Value;
use std::{
    collections::BTreeSet,
    fs,
    io::{self, Write},
    sync::LazyLock,
};

fn json(subject: Subject) -> Vec<Value> {
    let mut out = Vec::new();
    bench(&BenchOptions { json: true, ..BenchOptions::new(subject, 1) }, &mut out, None).expect("it runs");
    let text = String::from_utf8(out).expect("text");
    text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
}

static TABLE: LazyLock<Vec<Value>> = LazyLock::new(|| json(Subject::Table));

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
    for (first, second) in untimed(&TABLE).iter().zip(&untimed(&json(Subject::Table))) {
        assert_eq!(first, second);
    }
}

#[test]
fn every_claim_has_numbers_and_a_verdict() {
    let [first, second] = [json(Subject::Claims), json(Subject::Claims)].map(|lines| lines[1..].to_vec());
    assert_eq!(first.len(), 11);
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
    let options = BenchOptions::new(Subject::Table, 1);
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
    let options = BenchOptions::new(Subject::Claims, 1);
    bench(&options, &mut out, None).expect("it runs");
    let text = String::from_utf8(out).expect("text");
    assert!(!text.contains('⟨'), "{text}");
    assert_eq!(text.matches("  It ").count(), 11, "{text}");
    for part in text.split("\n\n").skip(1) {
        let lines: Vec<_> = part.lines().collect();
        assert!(lines[0].ends_with('.') && lines.len() > 2, "{part}");
        assert!(lines[1..].iter().all(|line| !line.starts_with("     ")), "a series has no name: {part}");
    }
}

#[test]
fn cost_by_triangles_and_by_pixels_is_a_table_of_three_methods() {
    let lines = json(Subject::Growth);
    let frames = &lines[1..];
    assert_eq!((frames.len(), names(frames, "method").len()), (24, 3));
    for (growing, factors) in [("triangles", [1, 10, 100, 1_000]), ("pixels", [1, 4, 16, 64])] {
        for factor in factors {
            let same = |frame: &&Value| frame["growing"] == growing && frame["factor"] == factor;
            let all: Vec<&Value> = frames.iter().filter(same).collect();
            assert_eq!(all.len(), 3, "{growing} x{factor}");
            assert!(all.iter().all(|frame| frame["ms"].as_f64().is_some_and(|ms| ms > 0.0)), "{all:?}");
        }
    }
}

#[test]
fn a_picture_shows_every_row_and_a_table_holds_it() {
    let folder = folder("bench");
    let options = |name: &str| BenchOptions {
        operation: Stage::from_name("line-clipping"),
        family: Family::from_name("beside"),
        output: Some(folder.join(name)),
        ..BenchOptions::new(Subject::Table, 1)
    };
    let read = |name: &str| {
        bench(&options(name), &mut Vec::new(), None).expect("it runs");
        fs::read(folder.join(name)).expect("it was written")
    };
    let svg = String::from_utf8(read("plot.svg")).expect("text");
    for part in ["Line clipping: run time against error", "Cohen–Sutherland", "exact", "f32, as taught"] {
        assert!(svg.contains(part), "{part}");
    }
    let csv = String::from_utf8(read("table.csv")).expect("text");
    // The machine, the names of fields, the fast call, and five algorithms in three arithmetics.
    assert_eq!(csv.lines().count(), 2 + 1 + 15, "{csv}");
    let json: Value = serde_json::from_slice(&read("table.json")).expect("JSON");
    assert_eq!(json["results"].as_array().map(Vec::len), Some(16));
    assert!(read("plot.png").starts_with(b"\x89PNG"));
    let refused = bench(&options("plot.gif"), &mut Vec::new(), None);
    assert_eq!(refused.map_err(|failure| failure.exit_code()), Err(2));
}

#[test]
fn every_claim_has_a_picture() {
    let folder = folder("claims");
    let output = Some(folder.join("plots"));
    bench(&BenchOptions { output, ..BenchOptions::new(Subject::Claims, 1) }, &mut Vec::new(), None)
        .expect("it runs");
    let pictures = fs::read_dir(folder.join("plots")).expect("a folder");
    let mut names: Vec<_> = pictures.map(|file| file.expect("a file").file_name()).collect();
    names.sort();
    assert_eq!(names.len(), CLAIMS.len() + 1, "{names:?}");
    for claim in &CLAIMS {
        let svg = fs::read_to_string(folder.join("plots").join(format!("{}.svg", claim.name)));
        let svg = svg.expect("it was written");
        assert!(!svg.contains('⟨') && svg.contains("It "), "{}", claim.name);
    }
}
