//! A player without its types: what the window, the tour and the trace hold.

use super::Player;
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, PixelReport, Table, Vantage, View},
    message::Message,
};

/// A player of any algorithm, as the transport bar, the inspector, the tour and the trace see it.
pub trait Playback: Send {
    /// The algorithm's name.
    fn name(&self) -> &'static str;
    /// Number of events in the run; steps are `0..=len()`.
    fn len(&self) -> usize;
    /// Whether the run reported nothing.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// The current step.
    fn cursor(&self) -> usize;
    /// Goes to a step, clamped to the run.
    fn seek(&mut self, step: usize);
    /// Goes to the end of the next event of `level` or coarser; at most to the end.
    fn next(&mut self, level: Level);
    /// Goes back to the end of the previous event of `level` or coarser; at least to the start.
    fn back(&mut self, level: Level);
    /// Goes to the next execution of a listing line, from the start again behind the last one;
    /// `false` if the run never executes it.
    fn next_at_line(&mut self, line: usize) -> bool;
    /// Pseudocode.
    fn listing(&self) -> &'static [&'static str];
    /// The listing line just executed.
    fn line(&self) -> Option<usize>;
    /// The level of the step just taken.
    fn level(&self) -> Option<Level>;
    /// What just happened.
    fn sentence(&self) -> Message;
    /// The formulas of what just happened.
    fn formulas(&self) -> Vec<Formula>;
    /// Values at the cursor.
    fn tables(&self) -> Vec<Table>;
    /// Values one step before the cursor (at step 0 those at the cursor), to mark what changed.
    fn tables_before(&mut self) -> Vec<Table>;
    /// The drawing at the cursor.
    fn marks(&self) -> Vec<Mark>;
    /// What part of the plane the drawing shows.
    fn view(&self) -> View;
    /// From where a drawing in space is seen first.
    fn vantage(&self) -> Option<Vantage>;
    /// Marks of the timeline with their steps, in order.
    fn markers(&self) -> Vec<(usize, Marker)>;
    /// The names below the marks of the timeline with their steps, in order.
    fn captions(&self) -> Vec<(usize, Message)>;
    /// The steps that end an event of `level` or coarser, in order.
    fn ends(&self, level: Level) -> Vec<usize>;
    /// The result at the cursor as facts.
    fn facts(&self) -> Vec<Fact>;
    /// Why a pixel, as column and row, is drawn in the end or not; `None` if the lab decides about none.
    fn pixel(&self, at: [u32; 2]) -> Option<PixelReport>;
    /// The steps of the verdicts on all fragments that come to a pixel, in order; none in a run that has
    /// no fragments. Cost: linear in the run.
    fn fragments_at(&self, pixel: [u32; 2]) -> Vec<usize>;
    /// What the run costs up to the cursor, and as a whole. Cost: linear in the run.
    fn operations(&self) -> [Operations; 2];
    /// The event that led to the cursor, for logs.
    fn event_text(&self) -> Option<String>;
    /// The event that led to the cursor, as data.
    fn event_json(&self) -> Option<serde_json::Value>;
}

impl<S: Explain> Playback for Player<S> {
    fn name(&self) -> &'static str {
        S::NAME
    }

    fn len(&self) -> usize {
        self.len
    }

    fn cursor(&self) -> usize {
        self.cursor
    }

    fn seek(&mut self, step: usize) {
        self.seek_to(step);
    }

    fn next(&mut self, level: Level) {
        let step = self.find_next(|event| S::level(event) <= level);
        self.seek_to(step.unwrap_or(self.len));
    }

    fn back(&mut self, level: Level) {
        let step = self.find_back(|event| S::level(event) <= level);
        self.seek_to(step.unwrap_or(0));
    }

    fn next_at_line(&mut self, line: usize) -> bool {
        let wanted = |event: &S::Event| S::line(event) == line;
        let mut step = self.find_next(wanted);
        if step.is_none() {
            let mut first = None;
            self.for_each(|at, event| {
                if first.is_none() && wanted(event) {
                    first = Some(at);
                }
            });
            step = first;
        }
        step.map(|step| self.seek_to(step)).is_some()
    }

    fn listing(&self) -> &'static [&'static str] {
        S::LISTING
    }

    fn line(&self) -> Option<usize> {
        self.event().map(S::line)
    }

    fn level(&self) -> Option<Level> {
        self.event().map(S::level)
    }

    fn sentence(&self) -> Message {
        match self.event() {
            Some(event) => self.state.sentence(event),
            None => self.state.opening(),
        }
    }

    fn formulas(&self) -> Vec<Formula> {
        let mut out = Vec::new();
        if let Some(event) = self.event() {
            self.state.formulas(event, &mut out);
        }
        out
    }

    fn tables(&self) -> Vec<Table> {
        let mut out = Vec::new();
        self.state.tables(&mut out);
        out
    }

    fn tables_before(&mut self) -> Vec<Table> {
        let step = self.cursor;
        self.seek_to(step.saturating_sub(1));
        let tables = self.tables();
        self.seek_to(step);
        tables
    }

    fn marks(&self) -> Vec<Mark> {
        let mut out = Vec::new();
        self.state.marks(self.event(), &mut out);
        out
    }

    fn view(&self) -> View {
        self.state.view()
    }

    fn vantage(&self) -> Option<Vantage> {
        self.state.vantage()
    }

    fn markers(&self) -> Vec<(usize, Marker)> {
        let mut out = Vec::new();
        self.for_each(|step, event| out.extend(S::marker(event).map(|marker| (step, marker))));
        out
    }

    fn captions(&self) -> Vec<(usize, Message)> {
        let mut out = Vec::new();
        self.for_each(|step, event| out.extend(self.state.caption(event).map(|caption| (step, caption))));
        out
    }

    fn ends(&self, level: Level) -> Vec<usize> {
        let mut out = Vec::new();
        self.for_each(|step, event| out.extend((S::level(event) <= level).then_some(step)));
        out
    }

    fn facts(&self) -> Vec<Fact> {
        let mut out = Vec::new();
        self.state.facts(&mut out);
        out
    }

    fn pixel(&self, at: [u32; 2]) -> Option<PixelReport> {
        self.state.pixel(at)
    }

    fn fragments_at(&self, pixel: [u32; 2]) -> Vec<usize> {
        let (mut row, mut steps) = (0, Vec::new());
        self.for_each(|step, event| {
            if S::fragment(event, &mut row) == Some(pixel) {
                steps.push(step + 1);
            }
        });
        steps
    }

    fn operations(&self) -> [Operations; 2] {
        let [mut so_far, mut whole] = [Operations::NONE; 2];
        self.for_each(|step, event| {
            whole += S::operations(event);
            if step <= self.cursor {
                so_far = whole;
            }
        });
        [so_far, whole]
    }

    fn event_text(&self) -> Option<String> {
        self.event().map(|event| format!("{event:?}"))
    }

    fn event_json(&self) -> Option<serde_json::Value> {
        self.event().and_then(|event| serde_json::to_value(event).ok())
    }
}
