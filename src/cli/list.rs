//! `rasterscope list`: labs, algorithms and presets, a sentence each.

use rasterscope_core::{labs, scene::PRESETS};
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
    section(output, "cli-presets", presets)
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
