//! Line clipping: five algorithms, three arithmetics.

use rasterscope_core::{
    clip::line::{
        self, ConvexWindow, Segment, Window, cohen_sutherland, cyrus_beck, liang_barsky, midpoint,
        nicholl_lee_nicholl,
    },
    math::{Arithmetic, Tally},
    stress::{Family, segments},
    trace::NoTrace,
};

use super::{
    Row,
    heat::{Answer, Contender, Errors, Heat},
};
use crate::Stopwatch;

pub(super) const STAGE: &str = "line-clipping";
pub(super) use rasterscope_core::stress::segments::FAMILIES;

const COUNT: usize = 2_048;

impl Answer for Option<Segment> {
    fn judge(&self, exact: &Self, errors: &mut Errors) {
        errors.decision(self.is_some() == exact.is_some());
        if let (Some(found), Some(exact)) = (self, exact) {
            errors.values(found.as_flattened().iter().zip(exact.as_flattened()));
        }
    }
}

pub(super) fn run(family: Family, stopwatch: &Stopwatch<'_>) -> Vec<Row> {
    let Some(window) = Window::new(segments::sides(family)) else { return Vec::new() };
    let (segments, convex) = (&segments::segments(family, COUNT), ConvexWindow::from(window));
    let (window, convex) = (&window, &convex);
    let mut contenders = vec![Contender::fast("at-once", segments, move |s| line::clip(*s, window))];
    for arithmetic in [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64] {
        let text = |name, clip: fn(Segment, &Window, Arithmetic, &mut Tally) -> Option<Segment>| {
            Contender::text(name, arithmetic, segments, move |s, tally| clip(*s, window, arithmetic, tally))
        };
        contenders.extend([
            text("cohen-sutherland", |s, w, a, tally| {
                cohen_sutherland::clip_traced(s, w, a, tally, &mut NoTrace)
            }),
            text("liang-barsky", with_parameters),
            text("midpoint", |s, w, a, tally| midpoint::clip_traced(s, w, a, tally, &mut NoTrace)),
            text("nicholl-lee-nicholl", |s, w, a, tally| {
                nicholl_lee_nicholl::clip_traced(s, w, a, tally, &mut NoTrace)
            }),
            Contender::text("cyrus-beck", arithmetic, segments, move |s, tally| {
                cyrus_beck::clip_traced(*s, convex, arithmetic, tally, &mut NoTrace).map(|part| part.segment)
            }),
        ]);
    }
    // From the other end, on which an exact answer does not depend.
    let exact = |&[a, b]: &Segment| {
        let part = cohen_sutherland::clip_traced(
            [b, a],
            window,
            Arithmetic::Exact,
            &mut Tally::default(),
            &mut NoTrace,
        );
        part.map(|[b, a]| [a, b])
    };
    let exact = segments.iter().map(exact).collect();
    Heat { stage: STAGE, family, items: COUNT, item: "segment", contenders, exact }.run(stopwatch)
}

fn with_parameters(
    s: Segment,
    window: &Window,
    arithmetic: Arithmetic,
    tally: &mut Tally,
) -> Option<Segment> {
    liang_barsky::clip_traced(s, window, arithmetic, tally, &mut NoTrace).map(|part| part.segment)
}
