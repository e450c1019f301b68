//! How far long work has come, as a line of a terminal that is written over and over.

use rasterscope_core::message::Message;
use std::io::Write;

use crate::words::say;

/// A terminal that is told how work goes on, if somebody looks. If it cannot be told, the work is
/// done all the same.
pub(crate) struct Progress<'a>(pub(crate) Option<&'a mut dyn Write>);

impl Progress<'_> {
    /// Writes over what was said before.
    pub(crate) fn say(&mut self, message: &Message) {
        if let Some(terminal) = &mut self.0 {
            let _ = write!(terminal, "\r\x1b[K{}", say(message)).and_then(|()| terminal.flush());
        }
    }

    /// Leaves the line empty.
    pub(crate) fn clear(&mut self) {
        if let Some(terminal) = &mut self.0 {
            let _ = write!(terminal, "\r\x1b[K").and_then(|()| terminal.flush());
        }
    }
}
