//! Run time against error, the lectures' claims about cost, and how cost grows.
//!
//! The command line and the window measure by these same lines. There is no clock here, no file and no
//! thread: a [`Stopwatch`] brings the time, and whoever calls says on which [`Machine`] it ran.
#![forbid(unsafe_code)]

pub mod claims;
pub mod growth;
pub mod pictures;
pub mod race;
pub mod skips;
pub mod tables;

mod machine;
mod stopwatch;

pub use machine::Machine;
pub use stopwatch::{ROUNDS, Stopwatch};
