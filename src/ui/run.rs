//! The run on screen: a playback, or two side by side, and what it shows at its cursor.

use crate::overview::Hover;
use rasterscope_core::{
    compare::{Pair, Side},
    explain::{Formula, Level, Mark, Marker, Operations, PixelReport, Table, Vantage, View},
    message::Message,
    replay::Playback,
};
use rasterscope_figure::words::Words;

/// What a playback shows at its cursor; made anew only when the cursor or the run changes.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    /// The step; the common one of two sides.
    pub(crate) cursor: usize,
    /// How many steps there are; of two sides the common ones.
    pub(crate) len: usize,
    /// The step of the side's own run.
    own: usize,
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
    /// What the side costs up to the cursor, and as a whole; counted only where two are compared.
    pub(crate) operations: Option<[Operations; 2]>,
    /// Moves whenever anything above may have changed; differs between the sides.
    pub(crate) rev: u64,
}

/// What runs.
enum Playing {
    One(Box<dyn Playback>),
    Two(Box<Pair>),
}

impl Playing {
    fn cursor(&self) -> usize {
        match self {
            Self::One(run) => run.cursor(),
            Self::Two(pair) => pair.cursor(),
        }
    }

    fn len(&self) -> usize {
        match self {
            Self::One(run) => run.len(),
            Self::Two(pair) => pair.len(),
        }
    }

    fn seek(&mut self, step: usize) {
        match self {
            Self::One(run) => run.seek(step),
            Self::Two(pair) => pair.seek(step),
        }
    }
}

/// A playback whose cursor survives that its input changes.
#[derive(Default)]
pub(crate) struct Run {
    playing: Option<Playing>,
    /// The algorithm of side A.
    name: &'static str,
    shown: [Option<Shown>; 2],
    /// The side that the inspector explains.
    side: Side,
    rev: u64,
    runs: usize,
}

impl std::fmt::Debug for Run {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Run").field("shown", &self.shown).finish_non_exhaustive()
    }
}

impl Run {
    /// Takes a new run, or two to be stepped as one; `fresh` of them were started for this. The
    /// cursor stays at its step number, clamped; at the end it stays at the end.
    pub(crate) fn set(&mut self, a: Box<dyn Playback>, b: Option<Box<dyn Playback>>, fresh: usize) {
        self.runs += fresh;
        let was_two = self.shown[1].is_some();
        let old = self.shown[0].take().filter(|_| self.name == a.name());
        self.name = a.name();
        let mut playing = match b {
            Some(b) => Playing::Two(Box::new(Pair::new([a, b]))),
            None => Playing::One(a),
        };
        let step = match (old, &playing) {
            (None, _) => usize::MAX,
            (Some(old), _) if old.cursor == old.len => usize::MAX,
            (Some(old), Playing::Two(pair)) if !was_two => pair.step_of(Side::A, old.own),
            (Some(old), Playing::One(_)) if was_two => old.own,
            (Some(old), _) => old.cursor,
        };
        playing.seek(step);
        self.playing = Some(playing);
        self.refresh(true);
    }

    /// Forgets the run, as there is none for the document.
    pub(crate) fn clear(&mut self) {
        *self = Self { rev: self.rev + 1, runs: self.runs, ..Self::default() };
    }

    /// Takes the run of side A out, to go on with it beside another side or alone.
    pub(crate) fn take_a(&mut self) -> Option<Box<dyn Playback>> {
        Some(match self.playing.take()? {
            Playing::One(run) => run,
            Playing::Two(pair) => {
                let [a, _] = pair.into_runs();
                a
            }
        })
    }

    /// What there is to see of the side that is explained, if anything runs.
    pub(crate) fn shown(&self) -> Option<&Shown> {
        self.shown_of(self.side).or_else(|| self.shown_of(Side::A))
    }

    /// What there is to see of a side.
    pub(crate) fn shown_of(&self, side: Side) -> Option<&Shown> {
        self.shown[side as usize].as_ref()
    }

    /// What a side costs as a whole; nothing where only one side is shown.
    pub(crate) fn cost(&self, side: Side) -> Operations {
        let counted = self.shown_of(side).and_then(|shown| shown.operations);
        counted.map_or(Operations::NONE, |[_, whole]| whole)
    }

    /// Two runs side by side, if there are two.
    pub(crate) fn pair(&self) -> Option<&Pair> {
        match &self.playing {
            Some(Playing::Two(pair)) => Some(pair),
            _ => None,
        }
    }

    /// The side that the inspector explains.
    pub(crate) fn side(&self) -> Side {
        self.side
    }

    /// Lets the inspector explain a side.
    pub(crate) fn explain(&mut self, side: Side) {
        self.side = side;
    }

    /// Why a side draws a pixel in the end or not; `None` if its lab decides about none.
    pub(crate) fn pixel(&self, side: Side, at: [u32; 2]) -> Option<PixelReport> {
        match self.playing.as_ref()? {
            Playing::One(run) => run.pixel(at),
            Playing::Two(pair) => pair.run(side).pixel(at),
        }
    }

    /// The same of the pixel under the pointer, in one line.
    pub(crate) fn hover(&self, side: Side, pixel: Option<[u32; 2]>, words: &Words) -> Option<Hover> {
        let pixel = pixel?;
        let PixelReport { sentence, warning, .. } = self.pixel(side, pixel)?;
        let lines = [Some(sentence), warning].into_iter().flatten().map(|line| words.message(&line));
        Some(Hover { pixel, text: lines.collect::<Vec<_>>().join(" "), triangle: None })
    }

    /// How often an algorithm ran: tests assert on it.
    #[cfg(test)]
    pub(crate) fn runs(&self) -> usize {
        self.runs
    }

    /// The steps of the verdicts on the fragments of a pixel, of the side that is explained.
    pub(crate) fn fragments_at(&self, pixel: [u32; 2]) -> Vec<usize> {
        match &self.playing {
            None => Vec::new(),
            Some(Playing::One(run)) => run.fragments_at(pixel),
            Some(Playing::Two(pair)) => {
                let steps = pair.run(self.side).fragments_at(pixel);
                steps.into_iter().map(|own| pair.step_of(self.side, own)).collect()
            }
        }
    }

    /// Goes to a step.
    pub(crate) fn seek(&mut self, step: usize) {
        self.moved(|playing, _| playing.seek(step));
    }

    /// Goes on by one step of a size.
    pub(crate) fn next(&mut self, level: Level) {
        self.moved(|playing, _| match playing {
            Playing::One(run) => run.next(level),
            Playing::Two(pair) => pair.next(level),
        });
    }

    /// Goes back by one step of a size.
    pub(crate) fn back(&mut self, level: Level) {
        self.moved(|playing, _| match playing {
            Playing::One(run) => run.back(level),
            Playing::Two(pair) => pair.back(level),
        });
    }

    /// Goes to the next execution of a listing line of the side that is explained.
    pub(crate) fn seek_line(&mut self, line: usize) {
        self.moved(|playing, side| match playing {
            Playing::One(run) => drop(run.next_at_line(line)),
            Playing::Two(pair) => drop(pair.next_at_line(side, line)),
        });
    }

    fn moved(&mut self, go: impl FnOnce(&mut Playing, Side)) {
        let Some(playing) = &mut self.playing else { return };
        let before = playing.cursor();
        go(playing, self.side);
        if playing.cursor() != before {
            self.refresh(false);
        }
    }

    fn refresh(&mut self, new: bool) {
        let Some(playing) = &mut self.playing else { return };
        let [old_a, old_b] = std::mem::take(&mut self.shown).map(|shown| shown.filter(|_| !new));
        let (cursor, len) = (playing.cursor(), playing.len());
        let rev = self.rev + 1;
        self.rev += 2;
        match playing {
            Playing::One(run) => {
                let marks =
                    old_a.map_or_else(|| (run.markers(), run.captions()), |old| (old.markers, old.captions));
                self.shown[0] = Some(shown(run.as_mut(), [cursor, len], marks, None, rev));
            }
            Playing::Two(pair) => {
                for (side, old) in Side::ALL.into_iter().zip([old_a, old_b]) {
                    let marks = old.map_or_else(
                        || (pair.markers(side), pair.captions(side)),
                        |old| (old.markers, old.captions),
                    );
                    let operations = Some(pair.run(side).operations());
                    let rev = rev + side as u64;
                    let shown = shown(pair.run_mut(side), [cursor, len], marks, operations, rev);
                    self.shown[side as usize] = Some(shown);
                }
            }
        }
    }
}

/// What stands on the timeline: marks and words, with their steps.
type Timeline = (Vec<(usize, Marker)>, Vec<(usize, Message)>);

fn shown(
    run: &mut dyn Playback,
    [cursor, len]: [usize; 2],
    (markers, captions): Timeline,
    operations: Option<[Operations; 2]>,
    rev: u64,
) -> Shown {
    Shown {
        cursor,
        len,
        own: run.cursor(),
        listing: run.listing(),
        line: run.line(),
        sentence: run.sentence(),
        formulas: run.formulas(),
        before: run.tables_before(),
        tables: run.tables(),
        marks: run.marks(),
        view: run.view(),
        vantage: run.vantage(),
        markers,
        captions,
        operations,
        rev,
    }
}
