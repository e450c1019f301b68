//! Where and how numbers were made: with them always, for they mean nothing elsewhere.

use rasterscope_core::message::{Message, Value};
use serde::Serialize;

/// The machine and the build.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Machine {
    /// The processor's name; empty if the system does not tell it.
    pub processor: String,
    /// How many threads can run at once.
    pub processors: usize,
    /// The operating system.
    pub system: &'static str,
    /// The instruction set.
    pub architecture: &'static str,
    /// The program's version.
    pub version: &'static str,
    /// `release` or `debug`.
    pub build: &'static str,
    /// The widest vectors that the build may use.
    pub vectors: &'static str,
}

impl Machine {
    /// It in one sentence.
    pub fn message(&self) -> Message {
        let Self { processor, processors, system, architecture, version, build, vectors } = self;
        let name = if processor.is_empty() { architecture } else { processor.as_str() };
        Message::new("bench-machine")
            .with("processor", Value::text(name))
            .with("count", Value::Int(*processors as i64))
            .with("system", Value::text(format!("{system} {architecture}")))
            .with("version", Value::text(version))
            .with("build", Value::text(build))
            .with("vectors", Value::text(vectors))
    }
}
