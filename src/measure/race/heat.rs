//! Contenders take turns, then each answer is held against the exact one.

use rasterscope_core::{
    math::{Arithmetic, Tally, ulps_between},
    stress::Family,
};
use std::hint::black_box;

use super::Row;
use crate::stopwatch::{Stopwatch, quartiles};

/// What one contender answers to one input.
pub(super) trait Answer {
    /// Counts what is wrong with it, `exact` being right.
    fn judge(&self, exact: &Self, errors: &mut Errors);
}

/// The whole workload, once.
type Run<'a, A> = Box<dyn Fn(&mut Vec<A>, &mut Tally) + 'a>;

/// One algorithm in one arithmetic.
pub(super) struct Contender<'a, A> {
    algorithm: &'static str,
    arithmetic: Arithmetic,
    call: &'static str,
    run: Run<'a, A>,
}

impl<'a, A> Contender<'a, A> {
    /// The text of an algorithm, asked for each input.
    pub(super) fn text<I>(
        algorithm: &'static str,
        arithmetic: Arithmetic,
        inputs: &'a [I],
        answer: impl Fn(&I, &mut Tally) -> A + 'a,
    ) -> Self {
        let run = move |answers: &mut Vec<A>, tally: &mut Tally| {
            answers.extend(inputs.iter().map(|input| answer(input, tally)));
        };
        Self { algorithm, arithmetic, call: "text", run: Box::new(run) }
    }

    /// Its fast call, which is exact.
    pub(super) fn fast<I>(algorithm: &'static str, inputs: &'a [I], answer: impl Fn(&I) -> A + 'a) -> Self {
        let text = Self::text(algorithm, Arithmetic::Exact, inputs, move |input, _| answer(input));
        Self { call: "fast", ..text }
    }
}

/// What is raced.
pub(super) struct Heat<'a, A> {
    pub(super) stage: &'static str,
    pub(super) family: Family,
    /// What a time is divided by, and its name.
    pub(super) items: usize,
    pub(super) item: &'static str,
    pub(super) contenders: Vec<Contender<'a, A>>,
    /// The right answers, in order.
    pub(super) exact: Vec<A>,
}

impl<A: Answer> Heat<'_, A> {
    /// Runs all contenders round by round. The round that warms up counts the exact tails.
    pub(super) fn run(self, stopwatch: &Stopwatch<'_>) -> Vec<Row> {
        let mut times = vec![Vec::new(); self.contenders.len()];
        let mut tallies = vec![Tally::default(); self.contenders.len()];
        let mut answers: Vec<Vec<A>> = self.contenders.iter().map(|_| Vec::new()).collect();
        stopwatch.take_turns(self.contenders.len(), |round, i| {
            let mut tally = Tally::default();
            answers[i].clear();
            let elapsed = stopwatch.time(|| (self.contenders[i].run)(black_box(&mut answers[i]), &mut tally));
            if round == 0 {
                tallies[i] = tally;
            } else {
                times[i].push(elapsed / self.items.max(1) as f64);
            }
        });
        let rows = self.contenders.iter().zip(answers).zip(times.into_iter().zip(tallies));
        rows.map(|((contender, answers), (times, tally))| {
            let mut errors = Errors::default();
            answers.iter().zip(&self.exact).for_each(|(answer, exact)| answer.judge(exact, &mut errors));
            let time = quartiles(times);
            Row {
                stage: self.stage,
                family: self.family,
                algorithm: contender.algorithm,
                call: contender.call,
                arithmetic: contender.arithmetic,
                items: self.items,
                item: self.item,
                ns: time[1],
                quartiles: [time[0], time[2]],
                decisions: errors.decisions,
                wrong_per_million: part(errors.wrong as f64 * 1e6, errors.decisions),
                values: errors.values,
                mean_ulps: part(errors.ulps, errors.values),
                max_ulps: errors.max_ulps,
                not_finite: errors.not_finite,
                exact_share: (tally.calls > 0).then(|| tally.share()),
            }
        })
        .collect()
    }
}

fn part(sum: f64, count: u64) -> f64 {
    if count == 0 { 0.0 } else { sum / count as f64 }
}

/// How wrong answers are.
#[derive(Default)]
pub(super) struct Errors {
    decisions: u64,
    wrong: u64,
    values: u64,
    not_finite: u64,
    ulps: f64,
    max_ulps: u64,
}

impl Errors {
    /// Something that is so or not.
    pub(super) fn decision(&mut self, is_right: bool) {
        self.decisions(1, u64::from(!is_right));
    }

    /// Many of them.
    pub(super) fn decisions(&mut self, all: u64, wrong: u64) {
        self.decisions += all;
        self.wrong += wrong;
    }

    /// A number.
    pub(super) fn value(&mut self, found: f32, exact: f32) {
        self.values += 1;
        if found.is_finite() {
            let ulps = ulps_between(found, exact);
            self.ulps += ulps as f64;
            self.max_ulps = self.max_ulps.max(ulps);
        } else {
            self.not_finite += 1;
        }
    }

    /// Numbers in pairs.
    pub(super) fn values<'v>(&mut self, pairs: impl IntoIterator<Item = (&'v f32, &'v f32)>) {
        pairs.into_iter().for_each(|(found, exact)| self.value(*found, *exact));
    }
}
