//! `rasterscope bench skips`: what each skip leaves out of a frame, how long the frame takes without it, and the
//! proof that its bytes stay.

use rasterscope_core::{
    message::{Message, Value},
    pipeline::Pipeline,
};
use rasterscope_measure::{
    Stopwatch,
    skips::{Saving, Savings, Setting},
};
use std::{
    cell::Cell,
    io::{self, Write},
    path::PathBuf,
    time::Instant,
};

use super::{json, machine};
use crate::{
    Failure,
    failure::written,
    files,
    progress::Progress,
    words::{self, WORDS},
};

/// What to measure, and how it is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SkipsOptions {
    /// A scene, a model or a preset; the default preset if there is none.
    pub file: Option<PathBuf>,
    /// One JSON object a line: the machine, a skip each, a setting each, a stage each, the proof.
    pub json: bool,
    /// How often each setting draws the frame, at least once.
    pub rounds: u32,
}

/// Cells of a bar.
const BAR: usize = 24;

/// Measures a scene, and writes the table. It fails if a skip changes a byte.
pub fn skips(
    options: &SkipsOptions,
    output: &mut dyn Write,
    progress: Option<&mut dyn Write>,
) -> Result<(), Failure> {
    let scene = files::open_scene(options.file.as_deref())?;
    let rounds = options.rounds.max(1);
    let (start, done) = (Instant::now(), Cell::new(0));
    let progress = std::cell::RefCell::new(Progress(progress));
    let now = || start.elapsed().as_secs_f64();
    let wanted = || {
        super::tell(
            &mut progress.borrow_mut(),
            done.get(),
            Savings::runs(rounds),
            &words::of("bench-skips-frames"),
        );
        done.set(done.get() + 1);
        true
    };
    let stopwatch = Stopwatch { rounds, now: &now, wanted: &wanted };
    let savings = Savings::measure(&scene, &Pipeline::default, &stopwatch);
    progress.borrow_mut().clear();
    // Nothing stops the work here.
    let Some(savings) = savings else { return Ok(()) };
    written(if options.json { lines(&savings, rounds, output) } else { table(&savings, output) })?;
    if savings.is_proved() { Ok(()) } else { Err(Failure::work(&Message::new("error-skips-changed"))) }
}

fn lines(savings: &Savings, rounds: u32, output: &mut dyn Write) -> io::Result<()> {
    json(&serde_json::json!({ "machine": machine(), "rounds": rounds }), output)?;
    for Saving { skip, work, ratio, same } in savings.savings() {
        let line = serde_json::json!({
            "skip": skip, "done": work.done, "left_out": work.left_out, "unit": words::of(work.unit),
            "ratio": ratio, "same": same,
        });
        json(&line, output)?;
    }
    for cost in &savings.costs {
        let line = serde_json::json!({
            "setting": cost.setting, "ns": cost.total(), "before_the_screen": cost.ns[0], "on_the_screen": cost.ns[1],
            "quartiles": cost.quartiles, "same": cost.same,
        });
        json(&line, output)?;
    }
    savings.loads().iter().try_for_each(|load| json(load, output))?;
    json(&serde_json::json!({ "proof": savings.is_proved() }), output)
}

fn table(savings: &Savings, output: &mut dyn Write) -> io::Result<()> {
    writeln!(output, "{}\n", words::say(&machine().message()))?;
    let [skip, left, done, without, same] = [
        "bench-skips-skip",
        "bench-skips-left-out",
        "bench-skips-done",
        "bench-skips-without",
        "bench-skips-same",
    ]
    .map(words::of);
    writeln!(output, "{skip:<16} {left:>12} {done:>12}  {:<16} {:<BAR$}  {without:>12}  {same}", "", "")?;
    for Saving { skip, work, ratio, same } in savings.savings() {
        let done = work.done.map_or(String::new(), |done| done.to_string());
        let bar = work.done.map_or(String::new(), |done| bar(done, work.left_out));
        let same = words::of(if same { "bench-skips-yes" } else { "bench-skips-no" });
        writeln!(
            output,
            "{:<16} {:>12} {done:>12}  {:<16} {bar:<BAR$}  {:>12}  {same}",
            skip.name(),
            work.left_out,
            words::of(work.unit),
            format!("× {ratio:.2}"),
        )?;
    }
    let [stage, with, none] = ["bench-skips-stage", "bench-skips-with", "bench-skips-none"].map(words::of);
    writeln!(output, "\n{stage:<16} {with:>12} {none:>12}")?;
    for load in savings.loads() {
        let bar = bar(load.with, load.without.saturating_sub(load.with));
        writeln!(
            output,
            "{:<16} {:>12} {:>12}  {bar}",
            WORDS.word(load.stage.word()),
            load.with,
            load.without
        )?;
    }
    writeln!(output)?;
    let ms = |ns: f64| Value::text(format!("{:.3}", ns / 1e6));
    for cost in savings.costs.iter().filter(|cost| !matches!(cost.setting, Setting::Without(_))) {
        let name = if cost.setting == Setting::All { "bench-skips-all" } else { "bench-skips-nothing" };
        let message = Message::new(name)
            .with("ms", ms(cost.total()))
            .with("before", ms(cost.ns[0]))
            .with("on", ms(cost.ns[1]))
            .with("times", Value::text(format!("{:.2}", savings.ratio())));
        writeln!(output, "{}", words::say(&message))?;
    }
    let proof = if savings.is_proved() { "bench-skips-proof" } else { "error-skips-changed" };
    writeln!(output, "{}", words::of(proof))
}

/// What is done, then what is left out.
fn bar(done: u64, left_out: u64) -> String {
    let all = done + left_out;
    if all == 0 {
        return String::new();
    }
    let full = (done as f64 / all as f64 * BAR as f64).round() as usize;
    format!("{}{}", "█".repeat(full), "░".repeat(BAR - full))
}
