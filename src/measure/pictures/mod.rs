//! Results as diagrams, the same in the window and in files.

mod claims;
mod errors;
mod growth;

pub use claims::claim;
pub use errors::{ErrorKind, Filter, errors};
pub use growth::growth;

use rasterscope_core::{
    explain::Role,
    math::Arithmetic,
    message::{Message, Value},
};
use rasterscope_figure::{plot::Plot, words::Words};

use crate::Machine;

/// A diagram, and where its points came from.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// The diagram.
    pub plot: Plot,
    /// For each point of each series, the index of its result.
    pub results: Vec<Vec<usize>>,
}

/// What an arithmetic looks like: the exact ones are those of the reference, the taught ones of the taught.
pub fn role(arithmetic: Arithmetic) -> Role {
    match arithmetic {
        Arithmetic::Exact => Role::Exact,
        Arithmetic::F32 => Role::Taught,
        Arithmetic::F64 => Role::Accepted,
        Arithmetic::Fixed8 => Role::Tie,
        Arithmetic::Fixed4 => Role::Changed,
        Arithmetic::Fixed0 => Role::Rejected,
    }
}

/// What people call an algorithm: as its lab does, if it has one.
pub fn algorithm(name: &str, words: &Words) -> String {
    let own = format!("bench-algorithm-{name}");
    words.word(if words.has(&own) { &own } else { name })
}

/// Curves of one diagram, in this order.
const CURVES: [Role; 4] = [Role::Accepted, Role::Taught, Role::Tie, Role::Rejected];

/// Where it was measured, and how often.
fn foot(machine: &Machine, rounds: u32, words: &Words) -> String {
    let rounds = Message::new("bench-rounds").with("rounds", Value::Int(rounds.into()));
    format!("{} {}", words.message(&machine.message()), words.message(&rounds))
}
