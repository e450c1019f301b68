//! The laws of a traced algorithm, the same few lines for all of them.

use rasterscope_core::{
    explain::{Explain, Level},
    message::Message,
    replay::{Budget, Playback, Player},
};
use rasterscope_figure::words::Words;
use std::{fmt::Debug, sync::LazyLock};

static WORDS: LazyLock<Words> = LazyLock::new(Words::default);

/// Which listing lines a corpus has reached.
#[derive(Default)]
pub(crate) struct Coverage(Vec<bool>);

impl Coverage {
    /// Law 4: the corpus reaches every line of the listing.
    #[track_caller]
    pub(crate) fn check_every_line<S: Explain>(&self) {
        let missing: Vec<_> =
            S::LISTING.iter().zip(&self.0).filter(|(_, reached)| !**reached).map(|(line, _)| line).collect();
        assert!(missing.is_empty(), "listing lines that no input reaches: {missing:?}");
    }
}

/// Laws 1 to 4 for one input: `fast` is the result without a tracer, `traced` that of the run
/// that wrote `events`, `result` reads the result out of a folded state.
#[track_caller]
pub(crate) fn check_laws<S, R>(
    (fast, traced): (&R, &R),
    events: &[S::Event],
    play: impl Fn(Budget) -> Player<S>,
    result: impl Fn(&S) -> R,
    coverage: &mut Coverage,
) where
    S: Explain + PartialEq + Debug + 'static,
    S::Event: PartialEq,
    R: PartialEq + Debug,
{
    assert_eq!(fast, traced, "1: the tracer changed the result");

    let mut states = vec![play(Budget::default()).state().clone()];
    for event in events {
        let mut next = states[states.len() - 1].clone();
        next.apply(event);
        states.push(next);
    }
    assert_eq!(&result(&states[events.len()]), fast, "2: the folded log is not the result");

    for budget in [Budget::default(), Budget { events: 3, checkpoint_bytes: 0 }] {
        check_seeks(play(budget), budget, events, &states);
    }

    coverage.0.resize(S::LISTING.len(), false);
    for (event, state) in events.iter().zip(&states[1..]) {
        let line = S::line(event);
        assert!(line < S::LISTING.len(), "4: {event:?} points past the listing");
        coverage.0[line] = true;
        explains(state, event);
    }
    says(&states[0].opening());
}

/// Law 3: any seek in any order, also under a tight budget, equals the plain fold.
#[track_caller]
fn check_seeks<S>(mut player: Player<S>, budget: Budget, events: &[S::Event], states: &[S])
where
    S: Explain + PartialEq + Debug + 'static,
    S::Event: PartialEq,
{
    let len = events.len();
    assert_eq!(player.len(), len, "3: length of the replayed run");
    let stride = len / 16 + 1;
    let order =
        (0..=len).step_by(stride).chain((0..=len).rev().step_by(stride)).chain([len, 1.min(len), len]);
    for step in order {
        player.seek(step);
        assert!(player.state() == &states[step], "3: state at step {step}");
        let event = step.checked_sub(1).map(|i| events[i]);
        assert!(player.event().copied() == event, "3: event at step {step}");
        assert!(player.events_in_memory() <= budget.events.max(1), "3: over budget");
    }
    for level in Level::ALL {
        let ends: Vec<usize> = (1..=len).filter(|&step| S::level(&events[step - 1]) <= level).collect();
        let start = len / 2;
        player.seek(start);
        player.next(level);
        let next = ends.iter().copied().find(|&step| step > start).unwrap_or(len);
        assert_eq!(player.cursor(), next, "3: next {level:?} from {start}");
        player.seek(start);
        player.back(level);
        let back = ends.iter().copied().rfind(|&step| step < start).unwrap_or(0);
        assert_eq!(player.cursor(), back, "3: back {level:?} from {start}");
    }
}

/// Every step says something, and the same parts of it have the same shape.
#[track_caller]
fn explains<S: Explain>(state: &S, event: &S::Event) {
    let sentence = state.sentence(event);
    assert!(sentence.id.starts_with(S::PREFIX), "4: {event:?} has no sentence of its own");
    says(&sentence);
    if let Some(label) = S::marker(event).and_then(|marker| marker.label) {
        assert!(WORDS.has(label), "4: no words for the marker {label}");
    }
    let (mut tables, mut marks, mut formulas) = (Vec::new(), Vec::new(), Vec::new());
    state.tables(&mut tables);
    state.marks(Some(event), &mut marks);
    state.formulas(event, &mut formulas);
    assert!(!marks.is_empty(), "4: nothing is drawn after {event:?}");
    for table in &tables {
        says(&Message::new(table.title));
        for column in table.columns.iter().filter(|column| column.starts_with("column-")) {
            says(&Message::new(column));
        }
        for row in &table.rows {
            assert_eq!(row.cells.len(), table.columns.len(), "4: row {} of {}", row.name, table.title);
        }
    }
}

/// The language files have the message, and it gets every value that it uses.
#[track_caller]
fn says(message: &Message) {
    if let Err(what) = WORDS.try_message(message) {
        panic!("4: {what}");
    }
}
