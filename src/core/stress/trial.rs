//! Cases under stress: each in every arithmetic against the exact answer, and the first that breaks made small.
//!
//! An answer is what the lab of the operation answers, as facts, so that nothing is computed here in another way
//! than where it is taught. *Source:* of the cases, Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast
//! Robust Geometric Predicates, 1997, section 4.4; of the judgement, [`judge`](super::judge); of making small,
//! [`shrink`](super::shrink).

mod explain;
mod picture;

pub use explain::Snapshot;

use super::{
    Family,
    dial::{self, Operation},
    judge::{Deviation, Verdict, deviations},
    shrink::shrink,
};
use crate::{
    compare::{Fact, Setting, sorted},
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

/// What all cases say about one arithmetic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Total {
    /// Which.
    pub arithmetic: Arithmetic,
    /// Cases that it breaks in.
    pub broken: usize,
    /// Parts that are decided otherwise, in all cases.
    pub wrong: u32,
    /// How far the worst number is off, in units of the last place, at most 2^24.
    pub worst: u32,
}

impl Total {
    fn new(arithmetic: Arithmetic) -> Self {
        Self { arithmetic, broken: 0, wrong: 0, worst: 0 }
    }

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
    /// What came of an arithmetic.
    Judged {
        /// Which.
        arithmetic: Arithmetic,
        /// How its answer differs.
        verdict: Verdict,
    },
    /// All arithmetics are judged.
    Done {
        /// The case, from 0.
        index: u32,
        /// Whether the arithmetic that is drawn breaks.
        broken: bool,
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

    /// Every part in which an arithmetic differs from the exact answer, the worst first.
    pub fn deviations(&self, case: &LabInput, arithmetic: Arithmetic) -> Vec<Deviation> {
        deviations(&self.answer(case, arithmetic), &self.answer(case, Arithmetic::Exact))
    }

    /// How an arithmetic differs from the exact answer, in two numbers.
    pub fn verdict(&self, case: &LabInput, arithmetic: Arithmetic) -> Verdict {
        Verdict::of(&self.deviations(case, arithmetic))
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
    let mut totals: Vec<Total> = subject.rounded().map(Total::new).collect();
    let mut failing = None;
    for index in 0..CASES {
        let case = subject.case(index);
        t.emit(|| Event::Case { index: index as u32 });
        let exact = subject.answer(&case, Arithmetic::Exact);
        t.emit(|| Event::Exact { parts: exact.len() as u32 });
        let mut broken = false;
        for total in &mut totals {
            let arithmetic = total.arithmetic;
            let verdict = Verdict::of(&deviations(&subject.answer(&case, arithmetic), &exact));
            total.add(verdict);
            t.emit(|| Event::Judged { arithmetic, verdict });
            broken |= arithmetic == subject.arithmetic && verdict.breaks();
        }
        t.emit(|| Event::Done { index: index as u32, broken });
        if broken && failing.is_none() {
            failing = Some((index, case));
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
