//! The words of messages, in the source language.

use rasterscope_core::message::Message;
use rasterscope_figure::words::Words;
use std::sync::LazyLock;

/// What the command line says. Read-only, made when the first sentence is asked for.
pub(crate) static WORDS: LazyLock<Words> = LazyLock::new(Words::default);

/// The sentence that a message stands for.
pub(crate) fn say(message: &Message) -> String {
    WORDS.message(message)
}
