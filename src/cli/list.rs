//! `rasterscope list`: labs, algorithms and presets, a sentence each.

use rasterscope_core::{clip, labs, raster, scene::PRESETS};
use std::io::{self, Write};

use crate::{Failure, failure::written, words};

/// Writes what there is, in aligned columns.
pub fn list(output: &mut dyn Write) -> Result<(), Failure> {
    written(write(output))
}

fn write(output: &mut dyn Write) -> io::Result<()> {
    let about = |name: &'static str| (name, words::of(&format!("{name}-about")));
    let presets = PRESETS.iter().map(|preset| (preset.name, words::of(&format!("preset-{}", preset.name))));
    section(output, "cli-labs", labs::ALL.iter().map(|lab| about(lab.name)))?;
    section(output, "cli-algorithms", without_steps().map(about))?;
    section(output, "cli-presets", presets)
}

/// The algorithms that can be computed with, but not stepped.
pub(crate) fn without_steps() -> impl Iterator<Item = &'static str> {
    let lines = clip::line::Algorithm::ALL.map(clip::line::Algorithm::name);
    let rasters = raster::Algorithm::ALL.map(raster::Algorithm::name);
    lines.into_iter().chain(rasters).filter(|name| labs::find(name).is_none())
}

/// A heading, and below it names with their sentences in two columns.
fn section(
    output: &mut dyn Write,
    heading: &str,
    entries: impl IntoIterator<Item = (&'static str, String)>,
) -> io::Result<()> {
    let entries: Vec<_> = entries.into_iter().collect();
    let width = entries.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    writeln!(output, "{}", words::of(heading))?;
    for (name, sentence) in entries {
        writeln!(output, "  {name:<width$}  {sentence}")?;
    }
    writeln!(output)
}
