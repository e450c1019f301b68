//! The run on screen: a playback, and what it shows at its cursor.

use rasterscope_core::{
    explain::{Formula, Level, Mark, Marker, Table, Vantage, View},
    message::Message,
    replay::Playback,
};

/// What a playback shows at its cursor; made anew only when the cursor or the run changes.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    pub(crate) cursor: usize,
    pub(crate) len: usize,
    pub(crate) listing: &'static [&'static str],
    pub(crate) line: Option<usize>,
    pub(crate) sentence: Message,
    pub(crate) formulas: Vec<Formula>,
    pub(crate) tables: Vec<Table>,
    pub(crate) before: Vec<Table>,
    pub(crate) marks: Vec<Mark>,
    pub(crate) view: View,
    pub(crate) vantage: Option<Vantage>,
    pub(crate) markers: Vec<(usize, Marker)>,
    /// The names below the markers.
    pub(crate) captions: Vec<(usize, Message)>,
    /// Moves whenever anything above may have changed.
    pub(crate) rev: u64,
}

/// A playback whose cursor survives that its input changes.
#[derive(Default)]
pub(crate) struct Run {
    playback: Option<Box<dyn Playback>>,
    shown: Option<Shown>,
    rev: u64,
    runs: usize,
}

impl std::fmt::Debug for Run {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Run").field("shown", &self.shown).finish_non_exhaustive()
    }
}

impl Run {
    /// Takes a new run. The cursor stays at its step number, clamped; at the end it stays at the
    /// end.
    pub(crate) fn set(&mut self, mut playback: Box<dyn Playback>) {
        self.runs += 1;
        let same = self
            .shown
            .as_ref()
            .filter(|_| self.playback.as_ref().is_some_and(|p| p.name() == playback.name()));
        let step = match same {
            Some(old) if old.cursor == old.len => playback.len(),
            Some(old) => old.cursor,
            None => playback.len(),
        };
        playback.seek(step);
        self.playback = Some(playback);
        self.refresh(true);
    }

    /// Forgets the run, as there is none for the document.
    pub(crate) fn clear(&mut self) {
        *self = Self { rev: self.rev + 1, runs: self.runs, ..Self::default() };
    }

    /// What there is to see, if anything runs.
    pub(crate) fn shown(&self) -> Option<&Shown> {
        self.shown.as_ref()
    }

    /// How often an algorithm ran: tests assert on it.
    #[cfg(test)]
    pub(crate) fn runs(&self) -> usize {
        self.runs
    }

    /// Goes to a step.
    pub(crate) fn seek(&mut self, step: usize) {
        self.moved(|playback| playback.seek(step));
    }

    /// Goes on by one step of a size.
    pub(crate) fn next(&mut self, level: Level) {
        self.moved(|playback| playback.next(level));
    }

    /// Goes back by one step of a size.
    pub(crate) fn back(&mut self, level: Level) {
        self.moved(|playback| playback.back(level));
    }

    /// Goes to the next execution of a listing line.
    pub(crate) fn seek_line(&mut self, line: usize) {
        self.moved(|playback| {
            playback.next_at_line(line);
        });
    }

    fn moved(&mut self, go: impl FnOnce(&mut dyn Playback)) {
        let Some(playback) = &mut self.playback else { return };
        let before = playback.cursor();
        go(playback.as_mut());
        if playback.cursor() != before {
            self.refresh(false);
        }
    }

    fn refresh(&mut self, new: bool) {
        let Some(playback) = &mut self.playback else { return };
        self.rev += 1;
        let (markers, captions) = match self.shown.take() {
            Some(shown) if !new => (shown.markers, shown.captions),
            _ => (playback.markers(), playback.captions()),
        };
        self.shown = Some(Shown {
            cursor: playback.cursor(),
            len: playback.len(),
            listing: playback.listing(),
            line: playback.line(),
            sentence: playback.sentence(),
            formulas: playback.formulas(),
            before: playback.tables_before(),
            tables: playback.tables(),
            marks: playback.marks(),
            view: playback.view(),
            vantage: playback.vantage(),
            markers,
            captions,
            rev: self.rev,
        });
    }
}
