//! What the search has found so far.

use super::{Event, Line};
use crate::replay::State;

/// A code that was looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Look {
    pub(super) place: u32,
    pub(super) merges: bool,
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) line: Line,
    pub(super) gap: f32,
    /// Which range is searched.
    pub(super) range: usize,
    /// The places that are left in it, if its last step is long enough.
    pub(super) left: Option<[u32; 2]>,
    /// The code looked at last.
    pub(super) look: Option<Look>,
    pub(super) found: Option<u32>,
    pub(super) done: bool,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(line: Line, gap: f32) -> Self {
        Self { line, gap, range: 0, left: None, look: None, found: None, done: false }
    }

    /// The place of the code that was found.
    pub fn result(&self) -> Option<u32> {
        self.found
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Range { place, merges } => {
                self.look = Some(Look { place, merges });
                if merges {
                    self.left = self.line.ranges().get(self.range).copied();
                } else {
                    self.range += 1;
                }
            }
            Event::Halve { place, merges } => {
                self.look = Some(Look { place, merges });
                if let Some([first, last]) = &mut self.left {
                    if merges { *last = place } else { *first = place + 1 }
                }
            }
            Event::Found { place } => (self.found, self.done) = (Some(place), true),
            Event::Never => self.done = true,
        }
    }
}
