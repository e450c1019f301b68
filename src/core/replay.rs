//! From events to something a user can scrub: random access in bounded memory.
//!
//! A [`Player`] holds an initial [`State`] and a way to run the algorithm again. It keeps
//! checkpoints (a bounded number of states, evenly spread) and a window of events. Seeking to
//! step `i` clones the checkpoint before `i` and applies the events from there. If those events
//! are not in the window, the algorithm runs once more and the window is filled there: runs are
//! deterministic, so this gives the same events, and memory does not grow with the trace.

mod playback;

pub use playback::Playback;

use crate::trace::Tracer;
use serde::Serialize;
use std::{fmt, ops::Range};

/// The visible state of an algorithm: the fold of its events.
pub trait State: Clone + Send {
    /// What the algorithm reports: facts with values in its own coordinates, at most 16 bytes
    /// unless a derivation says why not.
    type Event: Copy + fmt::Debug + Serialize + Send;

    /// Advances by one event. Law: after all events the state holds the algorithm's result.
    fn apply(&mut self, event: &Self::Event);

    /// Bytes that a clone takes, roughly; decides how many checkpoints are kept.
    fn size_hint(&self) -> usize {
        size_of::<Self>()
    }
}

/// Memory limits of one player.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Most events kept at a time; at least one is.
    pub events: usize,
    /// Most bytes of checkpoints; at least two checkpoints are kept.
    pub checkpoint_bytes: usize,
}

impl Default for Budget {
    fn default() -> Self {
        Self { events: 1 << 20, checkpoint_bytes: 16 << 20 }
    }
}

/// The tracer of steppable runs. Made by [`Player`] only.
pub struct Recorder<'v, S: State> {
    seen: usize,
    /// Steps whose event is kept.
    window: Range<usize>,
    events: Vec<S::Event>,
    /// Steps whose event is applied to `state`.
    fold: Range<usize>,
    state: S,
    checkpoints: Option<Checkpoints<S>>,
    /// Sees every event with its index.
    visit: Option<Visitor<'v, S>>,
}

type Visitor<'v, S> = &'v mut dyn FnMut(usize, &<S as State>::Event);

impl<S: State> Tracer<S::Event> for Recorder<'_, S> {
    #[inline]
    fn emit(&mut self, make: impl FnOnce() -> S::Event) {
        let event = make();
        if self.window.contains(&self.seen) {
            self.events.push(event);
        }
        if self.fold.contains(&self.seen) {
            self.state.apply(&event);
            if let Some(checkpoints) = &mut self.checkpoints {
                checkpoints.after(&self.state);
            }
        }
        if let Some(visit) = &mut self.visit {
            visit(self.seen, &event);
        }
        self.seen += 1;
    }
}

/// States after steps `0, every, 2 * every, ...`; `every` doubles when they get too many.
struct Checkpoints<S> {
    states: Vec<S>,
    every: usize,
    until_next: usize,
    most: usize,
}

impl<S: State> Checkpoints<S> {
    fn new(initial: S, bytes: usize) -> Self {
        // Even, so that the step at which every other one is dropped stays on the coarser grid.
        let most = (bytes / initial.size_hint().max(1)).max(2) & !1;
        // No more bytes of checkpoints than of events.
        let every = (initial.size_hint() / size_of::<S::Event>().max(1)).max(64);
        Self { states: vec![initial], every, until_next: every, most }
    }

    #[inline]
    fn after(&mut self, state: &S) {
        self.until_next -= 1;
        if self.until_next == 0 {
            self.push(state);
        }
    }

    #[cold]
    fn push(&mut self, state: &S) {
        if self.states.len() == self.most {
            let mut index = 0;
            self.states.retain(|_| (index % 2 == 0, index += 1).0);
            self.every *= 2;
        }
        self.states.push(state.clone());
        self.until_next = self.every;
    }
}

type Run<S> = Box<dyn Fn(&mut Recorder<'_, S>) + Send>;

/// A run that can be scrubbed. Step `i` is the state after the first `i` events.
pub struct Player<S: State> {
    run: Run<S>,
    budget: Budget,
    checkpoints: Checkpoints<S>,
    /// The steps whose events are in memory.
    window: Range<usize>,
    events: Vec<S::Event>,
    len: usize,
    cursor: usize,
    state: S,
}

impl<S: State> fmt::Debug for Player<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Player").field("cursor", &self.cursor).field("len", &self.len).finish_non_exhaustive()
    }
}

impl<S: State> Player<S> {
    /// Runs once. `run` must do the same at every call, starting from `initial`.
    pub fn new(initial: S, budget: Budget, run: impl Fn(&mut Recorder<'_, S>) + Send + 'static) -> Self {
        let mut recorder = Recorder {
            seen: 0,
            window: 0..budget.events.max(1),
            events: Vec::new(),
            fold: 0..usize::MAX,
            state: initial.clone(),
            checkpoints: Some(Checkpoints::new(initial.clone(), budget.checkpoint_bytes)),
            visit: None,
        };
        run(&mut recorder);
        let Recorder { seen: len, events, checkpoints, .. } = recorder;
        let checkpoints =
            checkpoints.unwrap_or_else(|| Checkpoints::new(initial.clone(), budget.checkpoint_bytes));
        let window = 0..events.len();
        Self { run: Box::new(run), budget, checkpoints, window, events, len, cursor: 0, state: initial }
    }

    /// The state at the cursor.
    pub fn state(&self) -> &S {
        &self.state
    }

    /// Number of events in memory, which the budget bounds.
    pub fn events_in_memory(&self) -> usize {
        self.events.len()
    }

    /// Bytes of the events and checkpoints in memory, which the budget bounds.
    pub fn memory(&self) -> usize {
        self.events.capacity() * size_of::<S::Event>()
            + self.checkpoints.states.iter().map(State::size_hint).sum::<usize>()
    }

    /// The event that led to the state at the cursor.
    pub fn event(&self) -> Option<&S::Event> {
        self.events.get(self.cursor.checked_sub(1)?.checked_sub(self.window.start)?)
    }

    /// Goes to a step, clamped to the run. Inside the event window this folds at most the events
    /// between two checkpoints; outside it runs the algorithm once more.
    pub fn seek_to(&mut self, step: usize) {
        let step = step.min(self.len);
        let nearest = (step / self.checkpoints.every).min(self.checkpoints.states.len() - 1);
        let mut from = nearest * self.checkpoints.every;
        if self.cursor <= step && self.cursor >= from {
            from = self.cursor;
        } else {
            self.state.clone_from(&self.checkpoints.states[nearest]);
        }
        self.cursor = step;
        // The event just before the cursor must be in memory too: the inspector shows it.
        let needed = from.min(step.saturating_sub(1))..step;
        if self.window.start <= needed.start && needed.end <= self.window.end {
            for event in &self.events[from - self.window.start..step - self.window.start] {
                self.state.apply(event);
            }
        } else {
            self.rerun(from..step);
        }
    }

    /// Runs again: applies the events of `fold` to the state, and keeps those around its end.
    fn rerun(&mut self, fold: Range<usize>) {
        let most = self.budget.events.max(1);
        let start = fold.end.saturating_sub(most.div_ceil(2));
        let mut events = std::mem::take(&mut self.events);
        events.clear();
        let mut recorder = Recorder {
            seen: 0,
            window: start..start + most,
            events,
            fold,
            state: self.state.clone(),
            checkpoints: None,
            visit: None,
        };
        (self.run)(&mut recorder);
        debug_assert_eq!(recorder.seen, self.len, "a run must be deterministic");
        self.state = recorder.state;
        self.events = recorder.events;
        self.window = start..start + self.events.len();
    }

    /// Shows every event of the run, with the step it leads to, to `visit`; runs the algorithm
    /// again if not all events are in memory.
    fn for_each(&self, mut visit: impl FnMut(usize, &S::Event)) {
        if self.window == (0..self.len) {
            self.events.iter().enumerate().for_each(|(i, event)| visit(i + 1, event));
            return;
        }
        let mut visit = |i: usize, event: &S::Event| visit(i + 1, event);
        (self.run)(&mut Recorder {
            seen: 0,
            window: 0..0,
            events: Vec::new(),
            fold: 0..0,
            state: self.state.clone(),
            checkpoints: None,
            visit: Some(&mut visit),
        });
    }

    /// The first step after the cursor whose event `wanted` accepts.
    fn find_next(&self, wanted: impl Fn(&S::Event) -> bool) -> Option<usize> {
        if self.window.contains(&self.cursor) {
            let rest = &self.events[self.cursor - self.window.start..];
            if let Some(ahead) = rest.iter().position(&wanted) {
                return Some(self.cursor + ahead + 1);
            }
            if self.window.end == self.len {
                return None;
            }
        }
        let mut found = None;
        self.for_each(|step, event| {
            if found.is_none() && step > self.cursor && wanted(event) {
                found = Some(step);
            }
        });
        found
    }

    /// The last step before the cursor whose event `wanted` accepts.
    fn find_back(&self, wanted: impl Fn(&S::Event) -> bool) -> Option<usize> {
        let last = self.cursor.checked_sub(1)?; // events 0..last lead to steps before the cursor
        if self.window.start <= last && last <= self.window.end {
            let before = &self.events[..last - self.window.start];
            if let Some(at) = before.iter().rposition(&wanted) {
                return Some(self.window.start + at + 1);
            }
            if self.window.start == 0 {
                return None;
            }
        }
        let mut found = None;
        self.for_each(|step, event| {
            if step <= last && wanted(event) {
                found = Some(step);
            }
        });
        found
    }
}
