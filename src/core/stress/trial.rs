//! Cases under stress: each in every arithmetic against the exact answer, and the first that breaks made small.
//!
//! An answer is what the lab of the operation answers, as facts, so that nothing is computed here in another way
//! than where it is taught. *Source:* of the judgement, Direct3D 11.3 functional specification, section 3.1, on what
//! an implementation may differ in; of making small, [`shrink`](super::shrink).

mod explain;

pub use explain::Snapshot;

use super::{
    Family,
    dial::{self, Operation},
    shrink::shrink,
};
use crate::{
    compare::{Difference, Fact, Setting, difference, sorted},
    labs::{self, LabInput},
    math::Arithmetic,
    replay::{Budget, Playback, Player},
    scene::{Lab, Scene},
    trace::{NoTrace, Tracer},
};
use serde::Serialize;
use std::sync::Arc;

/// Cases of a run.
pub const CASES: usize = 24;

/// A number that is farther from the exact one than this has lost ten of its 24 bits: it breaks the case, as a
/// wrong decision does.
pub const TOLERATED: u64 = 1 << 10;

/// The arithmetics that round, as far as an operation has them.
pub const ROUNDED: [Arithmetic; 3] = [Arithmetic::F32, Arithmetic::F64, Arithmetic::Fixed8];

/// What is driven how far.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// What is put under stress.
    pub operation: Operation,
    /// What its cases are driven to; one of [`Operation::families`].
    pub family: Family,
    /// How far, 0 to [`dial::MOST`].
    pub dial: u8,
    /// The arithmetic that is drawn, and whose first broken case is made small.
    pub arithmetic: Arithmetic,
    /// Whether that is done.
    pub shrink: bool,
    /// Whose image and camera the cases use.
    pub scene: Scene,
}

/// How an answer differs from the exact one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Verdict {
    /// Parts that are decided otherwise: a pixel, a corner, the answer as a whole.
    pub wrong: u64,
    /// How far the worst number is off, in units of the last place of binary32.
    pub ulps: u64,
}

impl Verdict {
    /// Whether the arithmetic breaks there.
    pub fn breaks(self) -> bool {
        self.wrong > 0 || self.ulps > TOLERATED
    }
}

/// What all cases say about one arithmetic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Total {
    /// Which.
    pub arithmetic: Arithmetic,
    /// Cases that it breaks in.
    pub broken: usize,
    /// Parts that are decided otherwise, in all cases.
    pub wrong: u64,
    /// How far the worst number is off.
    pub worst: u64,
}

impl Total {
    fn add(&mut self, verdict: Verdict) {
        self.broken += usize::from(verdict.breaks());
        self.wrong += verdict.wrong;
        self.worst = self.worst.max(verdict.ulps);
    }
}

/// What came of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// One for each arithmetic that the operation has.
    pub totals: Vec<Total>,
    /// The first case that breaks, made as small as can be; `None` if none breaks, or none was asked for.
    pub shrunk: Option<LabInput>,
}

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The next case.
    Case {
        /// Which, from 0.
        index: u32,
    },
    /// Its exact answer.
    Exact {
        /// How many parts it has.
        parts: u32,
    },
    /// An arithmetic decides everything as the exact one does.
    Agrees {
        /// Which.
        arithmetic: Arithmetic,
        /// How far its worst number is off; at most 2^32 - 1.
        ulps: u32,
    },
    /// An arithmetic breaks.
    Breaks {
        /// Which.
        arithmetic: Arithmetic,
        /// Parts decided otherwise.
        wrong: u32,
        /// How far its worst number is off; at most 2^32 - 1.
        ulps: u32,
    },
    /// The first case that breaks the arithmetic that is drawn.
    Failing {
        /// Which, from 0.
        index: u32,
    },
    /// No case does.
    Sound,
    /// A simpler number does as well.
    Simpler {
        /// Which of the case's numbers.
        number: u16,
        /// What it is now.
        to: f32,
    },
    /// No number can be simpler.
    Simplest,
}
const _: () = assert!(size_of::<Event>() <= 16);

impl Subject {
    /// A case, from 0.
    pub fn case(&self, index: usize) -> LabInput {
        dial::case(self.operation, self.family, self.dial, index, &self.scene)
    }

    /// The arithmetics that round and that the operation has.
    pub fn rounded(&self) -> impl Iterator<Item = Arithmetic> {
        let known = self.case(0).settings(&self.scene);
        ROUNDED.into_iter().filter(move |each| known.contains(&Setting::Arithmetic(*each)))
    }

    /// The scene with a case open in an arithmetic.
    pub fn opened(&self, case: &LabInput, arithmetic: Arithmetic) -> Scene {
        let mut input = case.clone();
        input.set(Setting::Arithmetic(arithmetic));
        Scene { lab: Some(Lab::new(input)), ..self.scene.clone() }
    }

    /// The run of a case, at its end; `None` if it is none that can be run.
    fn played(&self, case: &LabInput, arithmetic: Arithmetic) -> Option<Box<dyn Playback>> {
        let scene = self.opened(case, arithmetic);
        scene.lab.as_ref()?.input.check(&scene).ok()?;
        let mut run = labs::play(&scene, Budget { events: 1 << 12, ..Budget::default() }).ok()?;
        run.seek(usize::MAX);
        Some(run)
    }

    /// What an arithmetic answers to a case: nothing to a case that cannot be run.
    pub fn answer(&self, case: &LabInput, arithmetic: Arithmetic) -> Vec<Fact> {
        sorted(self.played(case, arithmetic).map(|run| run.facts()).unwrap_or_default())
    }

    /// How an arithmetic differs from the exact answer.
    pub fn verdict(&self, case: &LabInput, arithmetic: Arithmetic) -> Verdict {
        verdict(&difference(&self.answer(case, arithmetic), &self.answer(case, Arithmetic::Exact)))
    }

    /// Whether a case can be run at all and breaks the arithmetic that is drawn.
    pub fn fails(&self, case: &LabInput) -> bool {
        self.verdict(case, self.arithmetic).breaks()
    }

    /// The first case that breaks the arithmetic that is drawn, made as small as can be.
    pub fn shrunk(&self) -> Option<LabInput> {
        let first = (0..CASES).map(|index| self.case(index)).find(|case| self.fails(case))?;
        Some(shrink(&first, &mut |case| self.fails(case), &mut |_| {}))
    }
}

fn verdict(difference: &Difference) -> Verdict {
    let wrong = difference.count() - difference.in_numbers_only();
    Verdict { wrong: wrong as u64, ulps: difference.ulps().unwrap_or(0) }
}

/// Judges all cases, and makes one small if that is asked for.
pub fn run(subject: &Subject) -> Outcome {
    run_traced(subject, &mut NoTrace)
}

/// [`run`] as a run that can be scrubbed.
pub fn play(subject: Subject, budget: Budget) -> Player<Snapshot> {
    let subject = Arc::new(subject);
    Player::new(Snapshot::new(Arc::clone(&subject)), budget, move |t| {
        run_traced(&subject, t);
    })
}

/// The algorithm: [`run`] and [`play`] are this with two tracers.
pub fn run_traced<T: Tracer<Event>>(subject: &Subject, t: &mut T) -> Outcome {
    let total = |arithmetic| Total { arithmetic, broken: 0, wrong: 0, worst: 0 };
    let mut totals: Vec<Total> = subject.rounded().map(total).collect();
    let mut failing = None;
    for index in 0..CASES {
        let case = subject.case(index);
        t.emit(|| Event::Case { index: index as u32 });
        let exact = subject.answer(&case, Arithmetic::Exact);
        t.emit(|| Event::Exact { parts: exact.len() as u32 });
        for total in &mut totals {
            let arithmetic = total.arithmetic;
            let verdict = verdict(&difference(&subject.answer(&case, arithmetic), &exact));
            total.add(verdict);
            let [wrong, ulps] = [verdict.wrong, verdict.ulps].map(|n| u32::try_from(n).unwrap_or(u32::MAX));
            t.emit(|| match verdict.breaks() {
                true => Event::Breaks { arithmetic, wrong, ulps },
                false => Event::Agrees { arithmetic, ulps },
            });
            if verdict.breaks() && arithmetic == subject.arithmetic && failing.is_none() {
                failing = Some((index, case.clone()));
            }
        }
    }
    let Some((index, case)) = failing else {
        t.emit(|| Event::Sound);
        return Outcome { totals, shrunk: None };
    };
    t.emit(|| Event::Failing { index: index as u32 });
    let shrunk = subject.shrink.then(|| {
        let shrunk = shrink(&case, &mut |case| subject.fails(case), &mut |reduction| {
            t.emit(|| Event::Simpler { number: reduction.number as u16, to: reduction.to });
        });
        t.emit(|| Event::Simplest);
        shrunk
    });
    Outcome { totals, shrunk }
}
