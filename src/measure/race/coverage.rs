//! Scan conversion: every algorithm in every arithmetic.

use rasterscope_core::{
    math::{Arithmetic, Tally},
    raster::{Algorithm, Settings, Span, rows},
    stress::{
        Family,
        triangles::{Triangle, size, triangles},
    },
};

use super::{
    Row,
    heat::{Answer, Contender, Errors, Heat},
};
use crate::Stopwatch;

pub(super) const STAGE: &str = "coverage";
pub(super) use rasterscope_core::stress::triangles::FAMILIES;

const COUNT: usize = 64;

/// The covered pixels, sorted by row.
pub(super) struct Pixels(Vec<Span>);

impl Answer for Pixels {
    /// Each pixel that either covers is a decision.
    fn judge(&self, exact: &Self, errors: &mut Errors) {
        let pixels = |spans: &[Span]| spans.iter().map(|span| u64::from(span.len())).sum::<u64>();
        let (found, right) = (pixels(&self.0), pixels(&exact.0));
        let mut common = 0;
        let mut others = exact.0.iter().peekable();
        for span in &self.0 {
            while others.next_if(|other| other.y < span.y).is_some() {}
            if let Some(other) = others.peek().filter(|other| other.y == span.y) {
                common += u64::from(span.end.min(other.end).saturating_sub(span.begin.max(other.begin)));
            }
        }
        errors.decisions(found + right - common, found + right - 2 * common);
    }
}

pub(super) fn run(family: Family, stopwatch: &Stopwatch<'_>) -> Vec<Row> {
    let triangles = &triangles(family, COUNT);
    let settings = |arithmetic| Settings { arithmetic, ..Settings::new(size(family)) };
    let mut contenders = Vec::new();
    for algorithm in Algorithm::ALL {
        for arithmetic in Arithmetic::ALL {
            let settings = settings(arithmetic);
            contenders.push(Contender::text(
                algorithm.name(),
                arithmetic,
                triangles,
                move |vertices, tally| Pixels(rows(algorithm, *vertices, &settings, tally)),
            ));
        }
    }
    // Turned round: an exact answer does not depend on the winding.
    let exact = |[a, b, c]: &Triangle| {
        Pixels(rows(Algorithm::Scanline, [*c, *b, *a], &settings(Arithmetic::Exact), &mut Tally::default()))
    };
    let exact = triangles.iter().map(exact).collect();
    Heat { stage: STAGE, family, items: COUNT, item: "triangle", contenders, exact }.run(stopwatch)
}
