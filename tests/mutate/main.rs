//! The mutating runner: every operation whose answer is a matter of fact, against an oracle in
//! integers, over nasty families and over mutations of whatever took a new path.
//!
//! ```sh
//! cargo test -p rasterscope-tests --test mutate                               # as CI runs it
//! cargo test --release -p rasterscope-tests --test mutate -- clip-line --seconds 600 --seed 7
//! ```
//!
//! A failing case is shrunk and printed as code to paste into a test. The same seed gives the same
//! cases.

mod case;
mod integers;
mod operations;
#[path = "../support/random.rs"]
mod random;
mod runner;

use runner::{Failure, Limit};
use std::{
    env,
    process::ExitCode,
    time::{Duration, Instant},
};

fn main() -> ExitCode {
    let mut names = Vec::new();
    let (mut cases, mut time, mut seed) = (None, None, 1);
    let mut arguments = env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut number = || arguments.next().and_then(|n| n.parse().ok());
        match argument.as_str() {
            "--cases" => cases = number(),
            "--seconds" => time = number().map(Duration::from_secs),
            "--seed" => seed = number().unwrap_or(seed),
            option if option.starts_with('-') => {} // what a test runner is told is not for us
            name => names.push(name.replace('_', "-")),
        }
    }
    let mut failed = !finds_a_fault();
    for operation in operations::ALL {
        if !names.is_empty() && !names.iter().any(|name| name == operation.name) {
            continue;
        }
        let limit = Limit {
            cases: cases.unwrap_or(if time.is_some() { u64::MAX } else { operation.cases }),
            until: time.map(|time| Instant::now() + time),
        };
        failed |= !runner::run(operation, seed, limit);
    }
    if failed { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

/// Whether the runner finds and shrinks what is known to be wrong: the textbook in binary32.
#[expect(clippy::print_stdout, reason = "the runner is a test: this is its report")]
fn finds_a_fault() -> bool {
    let limit = Limit { cases: 20_000, until: None };
    let Err(Failure { after, case }) = runner::search(&operations::FAULTY, 1, limit) else {
        println!("{}: no case failed, but some must", operations::FAULTY.name);
        return false;
    };
    let small = runner::shrink(&operations::FAULTY, case.clone());
    let set = |case: &[u32]| case.iter().map(|word| word.count_ones()).sum::<u32>();
    let found = set(&small) < set(&case);
    println!("{}: found after {after} cases: {}", operations::FAULTY.name, (operations::FAULTY.code)(&small));
    found
}
