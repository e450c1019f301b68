//! The line clipping algorithms behind one interface, and the tests that all of them pass.

use super::{Coverage, LINE_WINDOW, Random, any_line, check_golden, check_laws, counted, log_text, window};
use rasterscope_core::{
    clip::line::{
        ConvexWindow, Mistakes, Segment, Window, cohen_sutherland, cyrus_beck, liang_barsky, midpoint,
        nicholl_lee_nicholl,
    },
    explain::{Explain, Operations},
    math::{Arithmetic, Real, Tally},
    replay::{Budget, Player, State},
    trace::{NoTrace, Tracer},
};
use std::fmt::Debug;

/// The arithmetics that clipping a line has.
pub(crate) const ARITHMETICS: [Arithmetic; 3] = [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64];

type EventOf<C> = <<C as Clipper>::Snapshot as State>::Event;

/// A line clipping algorithm.
pub(crate) trait Clipper {
    type Snapshot: Explain<Event: PartialEq> + PartialEq + Debug + 'static;

    fn traced<T: Tracer<EventOf<Self>>>(
        segment: Segment,
        window: &Window,
        arithmetic: Arithmetic,
        t: &mut T,
    ) -> Option<Segment>;

    fn taught<R: Real, T: Tracer<EventOf<Self>>>(
        segment: Segment,
        window: &Window,
        t: &mut T,
    ) -> Option<Segment>;

    fn play(
        segment: Segment,
        window: Window,
        arithmetic: Arithmetic,
        budget: Budget,
    ) -> Player<Self::Snapshot>;

    fn result(state: &Self::Snapshot) -> Option<Segment>;

    /// The fast call in exact arithmetic.
    fn clip(segment: Segment, window: &Window) -> Option<Segment> {
        Self::traced(segment, window, Arithmetic::Exact, &mut NoTrace)
    }
}

macro_rules! clipper {
    ($name:ident: $module:ident in $window:expr $(, $mistakes:expr)?) => {
        pub(crate) struct $name;

        impl Clipper for $name {
            type Snapshot = $module::Snapshot;

            fn traced<T: Tracer<EventOf<Self>>>(
                segment: Segment,
                window: &Window,
                arithmetic: Arithmetic,
                t: &mut T,
            ) -> Option<Segment> {
                ends($module::clip_traced(segment, &$window(*window), arithmetic, &mut Tally::default(), t))
            }

            fn taught<R: Real, T: Tracer<EventOf<Self>>>(
                segment: Segment,
                window: &Window,
                t: &mut T,
            ) -> Option<Segment> {
                ends($module::clip_taught::<R, T>(segment, &$window(*window), $($mistakes,)? t))
            }

            fn play(
                segment: Segment,
                window: Window,
                arithmetic: Arithmetic,
                budget: Budget,
            ) -> Player<Self::Snapshot> {
                $module::play(segment, $window(window), arithmetic, budget)
            }

            fn result(state: &Self::Snapshot) -> Option<Segment> {
                ends(state.result())
            }
        }
    };
}

clipper!(CohenSutherland: cohen_sutherland in Window::from, Mistakes::NONE);
clipper!(LiangBarsky: liang_barsky in Window::from);
clipper!(CyrusBeck: cyrus_beck in ConvexWindow::from);
clipper!(Midpoint: midpoint in Window::from);
clipper!(NichollLeeNicholl: nicholl_lee_nicholl in Window::from);

/// The visible segment of what an algorithm answers.
fn ends(answer: Option<impl Into<Ends>>) -> Option<Segment> {
    answer.map(|answer| answer.into().0)
}

struct Ends(Segment);

impl From<Segment> for Ends {
    fn from(segment: Segment) -> Self {
        Self(segment)
    }
}

impl From<liang_barsky::Visible> for Ends {
    fn from(visible: liang_barsky::Visible) -> Self {
        Self(visible.segment)
    }
}

/// What must be equal bit for bit.
pub(crate) fn bits(segment: Option<Segment>) -> Option<[[u32; 2]; 2]> {
    segment.map(|ends| ends.map(|p| p.map(f32::to_bits)))
}

/// Compares the log of a segment in the usual window, in exact arithmetic, with the golden one.
#[track_caller]
pub(crate) fn check_log<C: Clipper>(name: &str, segment: Segment) {
    let mut events: Vec<EventOf<C>> = Vec::new();
    C::traced(segment, &window(LINE_WINDOW), Arithmetic::Exact, &mut events);
    let folder = C::Snapshot::NAME.replace('-', "_");
    check_golden(&format!("{folder}/{name}"), &log_text(&events));
}

/// Laws 1 to 4 in every arithmetic, on lines of every family.
pub(crate) fn keeps_the_laws<C: Clipper>(seed: u64, rounds: u32) {
    let mut random = Random::new(seed);
    let mut coverage = Coverage::default();
    for _ in 0..rounds {
        let (segment, window) = any_line(&mut random);
        for arithmetic in ARITHMETICS {
            let fast = C::traced(segment, &window, arithmetic, &mut NoTrace);
            let mut events: Vec<EventOf<C>> = Vec::new();
            let traced = C::traced(segment, &window, arithmetic, &mut events);
            check_laws(
                (&bits(fast), &bits(traced)),
                &events,
                |budget| C::play(segment, window, arithmetic, budget),
                |state: &C::Snapshot| bits(C::result(state)),
                &mut coverage,
            );
        }
    }
    coverage.check_every_line::<C::Snapshot>();
}

/// What the events are said to cost is what the taught form costs.
pub(crate) fn costs_what_it_says<C: Clipper>(seed: u64) {
    let mut random = Random::new(seed);
    for _ in 0..5_000 {
        let (segment, window) = any_line(&mut random);
        let mut events: Vec<EventOf<C>> = Vec::new();
        let (_, counted) = counted(|| C::taught::<super::Counted, _>(segment, &window, &mut events));
        let mut said = Operations::NONE;
        for event in &events {
            said += C::Snapshot::operations(event);
        }
        assert_eq!(counted, said, "{segment:?} in {window:?}: {events:?}");
    }
}

/// Rounded arithmetic answers wrongly where exact arithmetic does not: in f32 more often.
pub(crate) fn rounding_fails<C: Clipper>(seed: u64) {
    let mut random = Random::new(seed);
    let mut wrong = [0, 0];
    for _ in 0..20_000 {
        let (segment, window) = any_line(&mut random);
        let exact = CohenSutherland::clip(segment, &window);
        for (count, arithmetic) in wrong.iter_mut().zip([Arithmetic::F32, Arithmetic::F64]) {
            *count += u32::from(C::traced(segment, &window, arithmetic, &mut NoTrace) != exact);
        }
    }
    assert!(wrong[0] > wrong[1] && wrong[1] > 0, "f32 {} wrong, f64 {} wrong", wrong[0], wrong[1]);
}
