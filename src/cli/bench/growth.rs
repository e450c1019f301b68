//! How cost grows, as a table: a row for each frame, a column for each method.

use rasterscope_figure::plot;
use rasterscope_measure::{
    growth::{self, Frame, Growing, METHODS},
    pictures,
};
use std::io::{self, Write};

use super::{
    Bench, json,
    output::{File, file},
};
use crate::words::{self, WORDS};

/// Width and height of both diagrams, in points.
const SIZE: [f32; 2] = [1_600.0, 640.0];

pub(super) fn write(bench: &mut Bench<'_, '_>) -> io::Result<Vec<File>> {
    let options = bench.options;
    let frames: Vec<_> = growth::frames().collect();
    let mut all: Vec<Frame> = Vec::new();
    for (done, (growing, factor)) in frames.iter().enumerate() {
        bench.tell(done, frames.len(), &words::of(&format!("bench-growing-{}", growing.name())));
        let measured = growth::measure(*growing, *factor, &bench.stopwatch).unwrap_or_default();
        bench.progress.clear();
        if options.json {
            measured.iter().try_for_each(|frame| json(frame, bench.output))?;
        } else {
            if *factor == 1 {
                write_head(*growing, bench.output)?;
            }
            let first = |method| all.iter().find(|frame| frame.growing == *growing && frame.method == method);
            write_row(&measured, first, bench.output)?;
        }
        bench.output.flush()?;
        all.extend(measured);
    }
    let Some(path) = &options.output else { return Ok(Vec::new()) };
    let picture = || {
        let plots = Growing::ALL
            .map(|growing| pictures::growth(&all, growing, &bench.machine, options.rounds, &WORDS).plot);
        plot::panels(&plots, 2, SIZE, options.theme.theme()).figure
    };
    Ok(vec![file(path, bench, picture, &all)])
}

fn write_head(growing: Growing, output: &mut dyn Write) -> io::Result<()> {
    writeln!(output, "\n{}", words::of(&format!("bench-growing-{}", growing.name())))?;
    let [triangles, pixels, frame] =
        ["triangles", "pixels", "frame"].map(|name| words::of(&format!("bench-column-{name}")));
    write!(output, "{triangles:>10} {pixels:>10}")?;
    for method in METHODS {
        write!(output, "  {:>28}", words::of(&format!("bench-method-{method}")))?;
    }
    writeln!(output, "   {frame}")
}

/// The time by each method, and how many times that of the first frame it is.
fn write_row<'f>(
    frames: &[Frame],
    first: impl Fn(&'static str) -> Option<&'f Frame>,
    output: &mut dyn Write,
) -> io::Result<()> {
    let Some(Frame { triangles, pixels, .. }) = frames.first() else { return Ok(()) };
    write!(output, "{triangles:>10} {pixels:>10}")?;
    for frame in frames {
        let times = frame.ms / first(frame.method).unwrap_or(frame).ms;
        write!(output, "  {:>16.3} {:>11}", frame.ms, format!("× {times:.1}"))?;
    }
    writeln!(output)
}
