//! The operations, one file each: how a case is read, what the oracle says of it.

mod clip_line;
mod clip_polygon;
mod clip_triangle;
mod coverage;
mod depth;

use crate::{case::Case, random::Random};
use std::{
    fmt::Debug,
    hash::{DefaultHasher, Hash, Hasher},
};

/// Something to test. Every list of words is a case of it.
pub(crate) struct Operation {
    pub(crate) name: &'static str,
    /// How many cases CI runs.
    pub(crate) cases: u64,
    /// A new case.
    pub(crate) fresh: fn(&mut Random) -> Case,
    /// Which path the case took, or what is wrong with the answer.
    pub(crate) check: fn(&[u32]) -> Result<u64, String>,
    /// The case as code.
    pub(crate) code: fn(&[u32]) -> String,
}

pub(crate) const ALL: &[Operation] = &[
    clip_line::OPERATION,
    clip_polygon::OPERATION,
    clip_triangle::OPERATION,
    coverage::OPERATION,
    depth::OPERATION,
];

/// What must be found wanting: the runner is tested with it.
pub(crate) const FAULTY: Operation = clip_line::FAULTY;

/// A path by what was seen on it.
fn path(seen: impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    seen.hash(&mut hasher);
    hasher.finish()
}

/// The answer must be the oracle's.
fn same<T: PartialEq + Debug>(what: &str, found: &T, expected: &T) -> Result<(), String> {
    if found == expected { Ok(()) } else { Err(format!("{what}: {found:?}, but exactly {expected:?}")) }
}
