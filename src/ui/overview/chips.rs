//! What the ribbon says of each stage.

use super::thumbnails;
use crate::shell::ribbon::Chip;
use rasterscope_core::{
    explain::{Row, Table},
    labs::Stage,
    message::{Message, Value},
    pipeline::{Outputs, Stats, Unit},
};
use rasterscope_figure::{
    numbers,
    tables::{self, TextTable},
    theme::ThemeName,
    words::Words,
};

/// The chips of all stages.
pub(super) fn chips(outputs: &Outputs, theme: ThemeName, words: &Words) -> Vec<Chip> {
    let stats = &outputs.frame.stats;
    let chip = |stage: Stage| {
        let count = stats.stage(stage);
        // The most frequent reason first: where there is no room, it stands alone.
        let mut reasons: Vec<_> = count.reasons().collect();
        reasons.sort_by_key(|(_, n)| std::cmp::Reverse(*n));
        let number = |n: u64| numbers::integer(i64::try_from(n).unwrap_or(i64::MAX));
        Chip {
            stage,
            count: count.on.then(|| number(count.went)),
            unit: unit(Unit::of(stage), count.went, words),
            skipped: reasons
                .into_iter()
                .map(|(reason, n)| format!("{} {}", number(n), words.word(reason.word())))
                .collect(),
            thumbnail: if count.on { thumbnails::of(stage, outputs, theme) } else { None },
        }
    };
    Stage::ALL.into_iter().map(chip).collect()
}

/// The name of what is counted, after that count.
fn unit(unit: Unit, count: u64, words: &Words) -> String {
    let count = i64::try_from(count).unwrap_or(i64::MAX);
    words.message(&Message::new(unit.word()).with("count", count))
}

/// The counts of all stages that are on, as a table.
pub(super) fn table(stats: &Stats, words: &Words) -> TextTable {
    let value = |n: u64| Value::Int(i64::try_from(n).unwrap_or(i64::MAX));
    let row = |stage: Stage| {
        let count = stats.stage(stage);
        let dropped: u64 = count.reasons().map(|(_, n)| n).sum();
        let cells = vec![
            value(count.came),
            Value::Text(unit(Unit::into(stage), count.came, words)),
            value(count.went),
            Value::Text(unit(Unit::of(stage), count.went, words)),
            value(dropped),
        ];
        Row::new(words.word(stage.word()), cells)
    };
    let rows = Stage::ALL.into_iter().filter(|stage| stats.stage(*stage).on).map(row).collect();
    let columns = vec!["column-came", "", "column-went", "", "column-dropped"];
    let table = Table { title: "ui-stages", columns, rows };
    tables::format(std::slice::from_ref(&table), &[], words).swap_remove(0)
}
