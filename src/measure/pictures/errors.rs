//! Run time against error, a point for each algorithm in each arithmetic.

use rasterscope_core::{
    math::Arithmetic,
    message::{Message, Value},
    stress::Family,
};
use rasterscope_figure::{
    plot::{Axis, Plot, Point, Scale, Series},
    words::Words,
};

use super::{Chart, algorithm, foot, role};
use crate::{
    Machine,
    race::{Row, Stage},
};

/// Which error.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ErrorKind {
    /// How far the worst number is off.
    #[default]
    Worst,
    /// How far numbers are off on the mean.
    Mean,
    /// How many decisions are wrong.
    Wrong,
}

impl ErrorKind {
    /// Every kind.
    pub const ALL: [Self; 3] = [Self::Worst, Self::Mean, Self::Wrong];

    /// `bench-error-NAME` is what people call it, with its unit.
    pub fn name(self) -> &'static str {
        match self {
            Self::Worst => "worst",
            Self::Mean => "mean",
            Self::Wrong => "wrong",
        }
    }

    /// The kind called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// The error of a row; infinite if a number is; `None` if nothing of the kind was looked at.
    pub fn of(self, row: &Row) -> Option<f64> {
        if self == Self::Wrong {
            return (row.decisions > 0).then_some(row.wrong_per_million);
        }
        match (row.values, row.not_finite, self) {
            (0, ..) => None,
            (_, 0, Self::Worst) => Some(row.max_ulps as f64),
            (_, 0, _) => Some(row.mean_ulps),
            _ => Some(f64::INFINITY),
        }
    }

    /// This kind if some row has it, else another.
    #[must_use]
    pub fn or_other(self, rows: &[Row]) -> Self {
        let has = |kind: Self| rows.iter().any(|row| kind.of(row).is_some());
        [self, Self::Worst, Self::Wrong].into_iter().find(|kind| has(*kind)).unwrap_or(self)
    }
}

/// What is shown of all rows.
#[derive(Clone, Copy, Debug)]
pub struct Filter {
    /// One operation: times of two are no more alike than their inputs.
    pub stage: &'static Stage,
    /// One family, or all of them.
    pub family: Option<Family>,
    /// Which error.
    pub error: ErrorKind,
}

impl Filter {
    /// Whether a row is shown.
    pub fn has(&self, row: &Row) -> bool {
        row.stage == self.stage.name && self.family.is_none_or(|family| family == row.family)
    }
}

/// The diagram of the rows that a filter has.
pub fn errors(rows: &[Row], filter: &Filter, machine: &Machine, rounds: u32, words: &Words) -> Chart {
    let shown: Vec<usize> = (0..rows.len()).filter(|i| filter.has(&rows[*i])).collect();
    let picked: Vec<Row> = shown.iter().map(|i| rows[*i].clone()).collect();
    let error = filter.error.or_other(&picked);
    let word = |kind: &str, name: &str| words.word(&format!("bench-{kind}-{name}"));
    let (mut series, mut results) = (Vec::new(), Vec::new());
    for arithmetic in Arithmetic::ALL {
        let (mut points, mut own) = (Vec::new(), Vec::new());
        for &index in shown.iter().filter(|i| rows[**i].arithmetic == arithmetic) {
            let row = &rows[index];
            let Some(x) = error.of(row) else { continue };
            // Where all families are shown, one name would stand there again and again.
            let label = if filter.family.is_some() { name(row, words) } else { String::new() };
            points.push(Point { at: [x, row.ns], spread: Some(row.quartiles), label });
            own.push(index);
        }
        if !points.is_empty() {
            series.push(Series {
                name: words.word(arithmetic.word()),
                role: role(arithmetic),
                joined: false,
                points,
            });
            results.push(own);
        }
    }
    let stage = word("stage", filter.stage.name);
    let family = filter.family.map_or(words.word("bench-family-all"), |family| word("family", family.name()));
    let subtitle = Message::new("bench-errors-subtitle").with("family", Value::text(family));
    let item = picked.first().map_or(String::new(), |row| word("item", row.item));
    let time = Message::new("bench-axis-time").with("item", Value::text(item));
    let mut across = Axis::new(word("error", error.name()), Scale::Log);
    across.zero = words.word("bench-lane-exact");
    across.infinite = words.word("bench-lane-infinite");
    let plot = Plot {
        title: words.message(&Message::new("bench-errors-title").with("stage", Value::text(stage))),
        subtitle: words.message(&subtitle),
        axes: [across, Axis::new(words.message(&time), Scale::Log)],
        series,
        guides: Vec::new(),
        frontier: Some(words.word("bench-frontier")),
        foot: foot(machine, rounds, words),
    };
    Chart { plot, results }
}

/// What a row is called beside its arithmetic.
fn name(row: &Row, words: &Words) -> String {
    let name = algorithm(row.algorithm, words);
    if row.call == "fast" { format!("{name}, {}", words.word("bench-call-fast")) } else { name }
}
