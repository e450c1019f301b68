//! The words of messages.

use rasterscope_core::message::Message;

/// The sentence that a message stands for.
pub(crate) fn say(message: &Message) -> String {
    format!("{message:?}")
}
