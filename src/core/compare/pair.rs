//! Two runs with one cursor.

use super::{
    alignment::Alignment,
    difference::{Difference, Part, difference, sorted},
    fact::{Fact, Subject},
    setting::side_b,
};
use crate::{
    explain::{Level, Marker},
    labs,
    message::Message,
    replay::{Budget, Playback},
    scene::Scene,
};
use std::fmt;

/// Which of the two runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Side {
    /// As the scene says.
    #[default]
    A,
    /// The same with one setting changed.
    B,
}

impl Side {
    /// Both sides.
    pub const ALL: [Self; 2] = [Self::A, Self::B];

    /// `A` or `B`.
    pub fn name(self) -> &'static str {
        ["A", "B"][self as usize]
    }
}

/// Two runs with one cursor, and what their results come to.
pub struct Pair {
    runs: [Box<dyn Playback>; 2],
    alignment: Alignment,
    /// Both results, in the order of their subjects.
    facts: [Vec<Fact>; 2],
    difference: Difference,
    cursor: usize,
}

impl fmt::Debug for Pair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Pair").field("cursor", &self.cursor).field("len", &self.len()).finish_non_exhaustive()
    }
}

impl Pair {
    /// Starts both runs of a scene that compares, at step 0; `None` if it does not.
    ///
    /// # Errors
    /// What about the input of either side cannot be run.
    pub fn play(scene: &Scene, budget: Budget) -> Option<Result<Self, Message>> {
        let other = side_b(scene)?;
        let both = labs::play(scene, budget).and_then(|a| Ok(Self::new([a, labs::play(&other, budget)?])));
        Some(both)
    }

    /// Lays two runs side by side, at step 0.
    pub fn new(mut runs: [Box<dyn Playback>; 2]) -> Self {
        let [a, b] = &runs;
        let alignment = Alignment::new(a.as_ref(), b.as_ref());
        let facts = runs.each_mut().map(|run| {
            run.seek(run.len());
            sorted(run.facts())
        });
        let difference = difference(&facts[0], &facts[1]);
        let mut pair = Self { runs, alignment, facts, difference, cursor: 0 };
        pair.seek(0);
        pair
    }

    /// The run of a side, at the common cursor.
    pub fn run(&self, side: Side) -> &dyn Playback {
        self.runs[side as usize].as_ref()
    }

    /// The run of a side, for what needs to go back a step and forth again.
    pub fn run_mut(&mut self, side: Side) -> &mut dyn Playback {
        self.runs[side as usize].as_mut()
    }

    /// What the two results have in common and what not, at the end of both runs.
    pub fn difference(&self) -> &Difference {
        &self.difference
    }

    /// The result of a side, in the order of its subjects.
    pub fn facts(&self, side: Side) -> &[Fact] {
        &self.facts[side as usize]
    }

    /// What both sides say of what `of` is about; corners have no name, so theirs is their place.
    pub fn part(&self, of: &Fact) -> Part<'_> {
        let is =
            |fact: &Fact| fact.subject == of.subject && (of.subject != Subject::Corner || fact.at == of.at);
        let about = |part: &Part<'_>| [part.a, part.b].into_iter().flatten().any(is);
        self.difference.parts().find(about).unwrap_or_else(|| {
            let [a, b] = self.facts.each_ref().map(|facts| {
                let first = facts.partition_point(|fact| fact.subject < of.subject);
                facts[first..].iter().take_while(|fact| fact.subject == of.subject).find(|fact| is(fact))
            });
            Part { a, b }
        })
    }

    /// Gives the runs back.
    pub fn into_runs(self) -> [Box<dyn Playback>; 2] {
        self.runs
    }

    /// The first common step at which a side is at `step` of its own.
    pub fn step_of(&self, side: Side, step: usize) -> usize {
        self.alignment.step_of(side as usize, step)
    }

    /// Number of common steps; steps are `0..=len()`.
    pub fn len(&self) -> usize {
        self.alignment.len()
    }

    /// Whether neither run reported anything.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The common step.
    pub fn cursor(&self) -> usize {
        self.cursor
    }

    /// Goes to a common step, clamped to the end.
    pub fn seek(&mut self, step: usize) {
        self.cursor = step.min(self.len());
        for (run, step) in self.runs.iter_mut().zip(self.alignment.sides(self.cursor)) {
            run.seek(step);
        }
    }

    /// Goes on by one common step of a size.
    pub fn next(&mut self, level: Level) {
        self.seek(self.alignment.next(self.cursor, level));
    }

    /// Goes back by one common step of a size.
    pub fn back(&mut self, level: Level) {
        self.seek(self.alignment.back(self.cursor, level));
    }

    /// Goes to the next execution of a listing line of one side, from the start again behind the
    /// last one; `false` if that run never executes it.
    pub fn next_at_line(&mut self, side: Side, line: usize) -> bool {
        let found = self.run_mut(side).next_at_line(line);
        let step = self.run(side).cursor();
        self.seek(if found { self.alignment.step_of(side as usize, step) } else { self.cursor });
        found
    }

    /// Marks of the timeline of a side, at common steps, in order.
    pub fn markers(&self, side: Side) -> Vec<(usize, Marker)> {
        self.placed(side, self.run(side).markers())
    }

    /// The names below the marks of a side, at common steps, in order.
    pub fn captions(&self, side: Side) -> Vec<(usize, Message)> {
        self.placed(side, self.run(side).captions())
    }

    fn placed<T>(&self, side: Side, own: Vec<(usize, T)>) -> Vec<(usize, T)> {
        own.into_iter().map(|(step, what)| (self.step_of(side, step), what)).collect()
    }
}
