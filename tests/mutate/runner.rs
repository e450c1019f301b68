//! Draws cases, keeps those that took a new path, mutates them, shrinks a failure.

use crate::{
    case::{Case, mutate},
    operations::Operation,
    random::Random,
};
use std::{collections::HashSet, time::Instant};

/// Cases are kept to be mutated up to this many.
const MOST_KEPT: usize = 4096;

/// When to stop: at whichever comes first.
pub(crate) struct Limit {
    pub(crate) cases: u64,
    pub(crate) until: Option<Instant>,
}

impl Limit {
    fn reached(&self, cases: u64) -> bool {
        cases >= self.cases
            || cases.is_multiple_of(1024) && self.until.is_some_and(|until| Instant::now() >= until)
    }
}

/// A case that failed.
pub(crate) struct Failure {
    /// How many cases were tried.
    pub(crate) after: u64,
    /// As it was found.
    pub(crate) case: Case,
}

/// Whether no case failed; tells what was done.
#[expect(clippy::print_stdout, reason = "the runner is a test: this is its report")]
pub(crate) fn run(operation: &Operation, seed: u64, limit: Limit) -> bool {
    let name = operation.name;
    match search(operation, seed, limit) {
        Ok((cases, paths)) => println!("{name}: {cases} cases, {paths} paths, no failure (seed {seed})"),
        Err(Failure { after, case }) => {
            let small = shrink(operation, case);
            let what = (operation.check)(&small).err().unwrap_or_default();
            println!("{name}: case {after} of seed {seed} fails. Shrunk:\n");
            println!("{}\n// {what}\n", (operation.code)(&small));
            return false;
        }
    }
    true
}

/// Tries cases until one fails; else says how many there were and how many paths they took.
pub(crate) fn search(operation: &Operation, seed: u64, limit: Limit) -> Result<(u64, usize), Failure> {
    let mut random = Random::new(seed);
    let (mut paths, mut kept) = (HashSet::new(), Vec::<Case>::new());
    let mut cases = 0;
    while !limit.reached(cases) {
        cases += 1;
        let case = if kept.is_empty() || random.below(3) == 0 {
            (operation.fresh)(&mut random)
        } else {
            let mut case = kept[random.below(kept.len() as u32) as usize].clone();
            for _ in 0..=random.below(4) {
                mutate(&mut random, &mut case);
            }
            case
        };
        match (operation.check)(&case) {
            Ok(path) if paths.insert(path) => {
                if kept.len() < MOST_KEPT {
                    kept.push(case);
                } else {
                    let place = random.below(MOST_KEPT as u32) as usize;
                    kept[place] = case;
                }
            }
            Ok(_) => {}
            Err(_) => return Err(Failure { after: cases, case }),
        }
    }
    Ok((cases, paths.len()))
}

/// The simplest case that still fails and that single changes lead to.
pub(crate) fn shrink(operation: &Operation, mut case: Case) -> Case {
    let fails = |case: &Case| (operation.check)(case).is_err();
    loop {
        let before = case.clone();
        for place in 0..case.len() {
            for simpler in simpler(case[place]) {
                let mut changed = case.clone();
                changed[place] = simpler;
                if weight(simpler) < weight(case[place]) && fails(&changed) {
                    case = changed;
                }
            }
        }
        if case == before {
            return case;
        }
    }
}

/// Simpler words than this one, the simplest first.
fn simpler(word: u32) -> impl Iterator<Item = u32> {
    let value = f32::from_bits(word);
    let round = [0.0, 1.0, 2.0, 3.0, 0.5, -1.0, value.round(), (value * 8.0).round() / 8.0, value.abs()];
    let shorter = [12, 18, 21, 22].map(|bits| word & !0 << bits);
    round.into_iter().map(f32::to_bits).chain(shorter).chain([word & !(1 << 31), word.wrapping_sub(1)])
}

/// How far from simple a word is: long fractions, then far exponents, then a sign.
fn weight(word: u32) -> u32 {
    let fraction = 23 - (word << 9).trailing_zeros().min(23);
    let exponent = (word >> 23 & 0xFF).abs_diff(127);
    let small = if word == 0 { 0 } else { exponent + 1 };
    fraction * 1024 + small * 2 + (word >> 31)
}
