//! Run time against error: every algorithm in every arithmetic, side by side.
//!
//! An operation is measured family by family. All contenders of a family take turns, round by round, so that
//! a busy moment of the machine hits them all; only times of one family are to be compared. Inputs are the
//! same on every run and machine. Each answer is held against the exact one, which is found in another way
//! than the row's own: with the vertices in another order, or by another algorithm.

mod attributes;
mod coverage;
mod depth;
mod heat;
mod homogeneous;
mod lines;
mod polygons;

use rasterscope_core::{math::Arithmetic, stress::Family};
use serde::Serialize;

use crate::Stopwatch;

/// An operation, and how it is measured.
#[derive(Clone, Copy, Debug)]
pub struct Stage {
    /// `bench-stage-NAME` is what people call it.
    pub name: &'static str,
    /// The families of inputs that it has.
    pub families: &'static [Family],
    run: fn(Family, &Stopwatch<'_>) -> Vec<Row>,
}

/// Every operation, in the order of the pipeline.
pub static STAGES: [Stage; 6] = [
    Stage { name: lines::STAGE, families: lines::FAMILIES, run: lines::run },
    Stage { name: polygons::STAGE, families: polygons::FAMILIES, run: polygons::run },
    Stage { name: homogeneous::STAGE, families: homogeneous::FAMILIES, run: homogeneous::run },
    Stage { name: coverage::STAGE, families: coverage::FAMILIES, run: coverage::run },
    Stage { name: depth::STAGE, families: depth::FAMILIES, run: depth::run },
    Stage { name: attributes::STAGE, families: attributes::FAMILIES, run: attributes::run },
];

impl Stage {
    /// Measures one family; `None` if it was stopped.
    pub fn measure(&self, family: Family, stopwatch: &Stopwatch<'_>) -> Option<Vec<Row>> {
        let rows = (self.run)(family, stopwatch);
        (stopwatch.wanted)().then_some(rows)
    }

    /// The operation called `name`.
    pub fn from_name(name: &str) -> Option<&'static Self> {
        STAGES.iter().find(|stage| stage.name == name)
    }
}

/// One algorithm in one arithmetic on one family: how long it takes, and how wrong it is.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The operation.
    pub stage: &'static str,
    /// The inputs.
    pub family: Family,
    /// The algorithm.
    pub algorithm: &'static str,
    /// `text`: what can be stepped; `fast`: what the pipeline calls.
    pub call: &'static str,
    /// In which it runs.
    pub arithmetic: Arithmetic,
    /// What a time was divided by.
    pub items: usize,
    /// What these are: `bench-item-NAME`.
    pub item: &'static str,
    /// The median time of an item, in ns.
    pub ns: f64,
    /// The lower and the upper quartile.
    pub quartiles: [f64; 2],
    /// How many answers are so or not so.
    pub decisions: u64,
    /// How many of a million of them are wrong.
    pub wrong_per_million: f64,
    /// How many answers are numbers.
    pub values: u64,
    /// How far they are off, in units of the last place of binary32.
    pub mean_ulps: f64,
    /// How far the worst one is off.
    pub max_ulps: u64,
    /// How many are infinite or no number.
    pub not_finite: u64,
    /// How many exact decisions no filter could make; `None`: nothing was decided exactly.
    pub exact_share: Option<f64>,
}
