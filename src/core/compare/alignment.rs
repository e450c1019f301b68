//! One cursor for two runs.

use crate::{explain::Level, replay::Playback};

/// Which step of A stands beside which step of B.
///
/// Two runs that do the same in a different number of steps would drift apart if both stood at the
/// same step number: after a row with one pixel more, every later row would stand beside its
/// neighbour. So the n-th primitive of A is laid beside the n-th of B, in it the n-th row beside the
/// n-th row, and in a row step by step; whoever has done with a row or a primitive waits for the
/// other. No step of either run is left out, and both end together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Alignment {
    /// Ends of rows and primitives in order, the start first.
    joints: Vec<Joint>,
}

/// A step at which both runs have done with a row or a primitive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Joint {
    /// The common cursor.
    step: usize,
    /// The steps of A and of B.
    sides: [usize; 2],
    /// Whether a primitive ends here.
    primitive: bool,
}

impl Alignment {
    /// Lays two runs side by side. Costs one walk through each run for each of two levels.
    pub fn new(a: &dyn Playback, b: &dyn Playback) -> Self {
        let runs = [a, b].map(|run| {
            let until_end = |level| {
                let mut ends = run.ends(level);
                if ends.last() != Some(&run.len()) {
                    ends.push(run.len());
                }
                ends
            };
            [until_end(Level::Primitive), until_end(Level::Row)]
        });
        let [[primitives_a, rows_a], [primitives_b, rows_b]] = &runs;
        let mut joints = vec![Joint::default()];
        let mut rows = [&rows_a[..], &rows_b[..]];
        for n in 0..primitives_a.len().max(primitives_b.len()) {
            let ends = [primitives_a, primitives_b].map(|ends| ends.get(n).copied());
            let inside = [0, 1].map(|side| {
                let count = ends[side].map_or(0, |end| rows[side].partition_point(|&row| row <= end));
                let (inside, rest) = rows[side].split_at(count);
                rows[side] = rest;
                inside
            });
            for row in 0..inside[0].len().max(inside[1].len()) {
                let last = joints[joints.len() - 1];
                let sides = [0, 1].map(|side| inside[side].get(row).copied().unwrap_or(last.sides[side]));
                let steps = [0, 1].map(|side| sides[side] - last.sides[side]);
                let step = last.step + steps[0].max(steps[1]);
                joints.push(Joint { step, sides, primitive: false });
            }
            if let Some(last) = joints.last_mut() {
                last.primitive = true;
            }
        }
        Self { joints }
    }

    /// Number of common steps; steps are `0..=len()`.
    pub fn len(&self) -> usize {
        self.joints.last().map_or(0, |joint| joint.step)
    }

    /// Whether neither run reported anything.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The steps of A and B at a common step, clamped to the end.
    pub fn sides(&self, step: usize) -> [usize; 2] {
        let next = self.joints.partition_point(|joint| joint.step < step);
        let Some(end) = self.joints.get(next) else {
            return self.joints.last().map_or([0; 2], |joint| joint.sides);
        };
        let start = self.joints[next.saturating_sub(1)];
        [0, 1].map(|side| (start.sides[side] + (step - start.step)).min(end.sides[side]))
    }

    /// The first common step at which a side (0: A, 1: B) is at `step` of its own.
    pub fn step_of(&self, side: usize, step: usize) -> usize {
        let next = self.joints.partition_point(|joint| joint.sides[side] < step);
        if next == 0 || next >= self.joints.len() {
            return if next == 0 { 0 } else { self.len() };
        }
        let start = self.joints[next - 1];
        start.step + (step - start.sides[side])
    }

    /// The end of the next common step of a size; at most the end.
    pub fn next(&self, step: usize, level: Level) -> usize {
        let ends = |joint: &&Joint| joint.step > step && (joint.primitive || level == Level::Row);
        match level {
            Level::Detail => (step + 1).min(self.len()),
            _ => self.joints.iter().find(ends).map_or(self.len(), |joint| joint.step),
        }
    }

    /// The end of the previous common step of a size; at least the start.
    pub fn back(&self, step: usize, level: Level) -> usize {
        let ends = |joint: &&Joint| joint.step < step && (joint.primitive || level == Level::Row);
        match level {
            Level::Detail => step.saturating_sub(1),
            _ => self.joints.iter().rev().find(ends).map_or(0, |joint| joint.step),
        }
    }
}
