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

/// The word or sentence whose id is made of a name; empty if there is none.
pub(crate) fn of(id: &str) -> String {
    let known = WORDS.ids().into_iter().find(|(_, known)| *known == id);
    known.map_or_else(String::new, |(_, id)| WORDS.word(id))
}
