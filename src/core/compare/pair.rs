//! Two runs with one cursor.

use super::{
    alignment::Alignment,
    difference::{Difference, difference},
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
        let [a, b] = runs.each_mut().map(|run| {
            run.seek(run.len());
            run.facts()
        });
        let mut pair = Self { runs, alignment, difference: difference(a, b), cursor: 0 };
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
        let own = self.run(side).markers().into_iter();
        own.map(|(step, marker)| (self.alignment.step_of(side as usize, step), marker)).collect()
    }
}
