//! What the ribbon says of each stage.

use super::thumbnails;
use crate::shell::ribbon::Chip;
use rasterscope_core::{
    labs::Stage,
    pipeline::{Outputs, Unit},
};
use rasterscope_figure::{numbers, theme::ThemeName, words::Words};

/// The chips of all stages.
pub(super) fn chips(outputs: &Outputs, theme: ThemeName, words: &Words) -> Vec<Chip> {
    let stats = &outputs.frame.stats;
    let chip = |stage: Stage| {
        let count = stats.stage(stage);
        let most = count.reasons().max_by_key(|(_, n)| *n);
        let number = |n: u64| numbers::integer(i64::try_from(n).unwrap_or(i64::MAX));
        Chip {
            stage,
            count: count.on.then(|| number(count.went)),
            unit: words.word(Unit::of(stage).word()),
            skipped: most.map(|(reason, n)| format!("{} {}", number(n), words.word(reason.word()))),
            thumbnail: if count.on { thumbnails::of(stage, outputs, theme) } else { None },
        }
    };
    Stage::ALL.into_iter().map(chip).collect()
}
