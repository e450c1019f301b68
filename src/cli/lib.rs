//! All of Rasterscope that works without a window: `compute`, `trace`, `figure`, `tour`, `bench`,
//! `list`.
//!
//! Each command is a function that takes its options and the streams it writes to, and returns a
//! [`Failure`] that holds one sentence and the exit code. Files are read and written only in
//! `files`. Nothing here opens a window or uses the network, and only `bench` reads a clock.
#![forbid(unsafe_code)]

pub mod bench;
pub mod compute;
mod failure;
pub mod figure;
pub mod files;
pub mod list;
mod progress;
pub mod tour;
pub mod trace;
mod words;

pub use failure::Failure;
