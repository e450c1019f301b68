//! Why a command did not do its work, in one sentence, and the exit code that says so.

use rasterscope_core::message::Message;
use std::{fmt, io};

use crate::words::say;
pub(crate) use rasterscope_figure::words::reason;

/// A command that did not do its work: what, where and what to do, in one sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The work failed: exit code 1.
    Work(String),
    /// The command was used wrongly: exit code 2.
    Usage(String),
}

impl Failure {
    /// The work failed for the reason that `message` names.
    pub(crate) fn work(message: &Message) -> Self {
        Self::Work(say(message))
    }

    /// The command was used wrongly in the way that `message` names.
    pub fn usage(message: &Message) -> Self {
        Self::Usage(say(message))
    }

    /// Standard input or a file could not be read to its end.
    pub(crate) fn input(error: &io::Error) -> Self {
        Self::work(&Message::new("error-input").with("why", reason(error)))
    }

    /// What the process ends with.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Work(_) => 1,
            Self::Usage(_) => 2,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Work(sentence) | Self::Usage(sentence) => f.write_str(sentence),
        }
    }
}

impl std::error::Error for Failure {}

/// What became of writing to standard output. A reader that has seen enough and left (`| head`)
/// is no failure.
pub(crate) fn written(result: io::Result<()>) -> Result<(), Failure> {
    match result {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::work(&Message::new("error-output").with("why", reason(&error))))
        }
        _ => Ok(()),
    }
}
