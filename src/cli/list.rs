//! `rasterscope list`: labs, algorithms and presets, a sentence each.

use rasterscope_core::{clip, labs, message::Message, raster, scene::assets};
use std::io::{self, Write};

use crate::{Failure, failure::written, words::{WORDS, say}};

/// Writes what there is, in aligned columns.
pub fn list(output: &mut dyn Write) -> Result<(), Failure> {
    written(write(output))
}

fn write(output: &mut dyn Write) -> io::Result<()> {
    section(output, "list-labs", labs::ALL.map(|lab| (lab.name, lab.name, "-about")))?;
    let lines = clip::line::Algorithm::ALL.map(|algorithm| (algorithm.name(), algorithm.name(), "-about"));
    let rasters = raster::Algorithm::ALL.map(|algorithm| (algorithm.name(), algorithm.name(), "-about"));
    section(output, "list-algorithms", lines.into_iter().chain(rasters))?;
    let presets = assets::PRESETS.iter().map(|preset| (preset.name, preset.name, ""));
    section(output, "list-presets", presets)
}
