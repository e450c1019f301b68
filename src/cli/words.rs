//! The words of messages, in the source language.

use rasterscope_core::message::Message;
use rasterscope_figure::words::Words;
use std::{collections::HashSet, sync::LazyLock};

/// What the command line says. Read-only, made when the first sentence is asked for.
pub(crate) static WORDS: LazyLock<Words> = LazyLock::new(Words::default);

/// All ids. The language files are parsed to find them, so once is enough.
static IDS: LazyLock<HashSet<&'static str>> =
    LazyLock::new(|| WORDS.ids().into_iter().map(|(_, id)| id).collect());

/// The sentence that a message stands for. What it quotes of a user's text may hold anything, so
/// control characters are written as escapes: none reaches a terminal.
pub(crate) fn say(message: &Message) -> String {
    visible(&WORDS.message(message))
}

/// The word or sentence whose id is made of a name; empty if there is none.
pub(crate) fn of(id: &str) -> String {
    IDS.get(id).map_or_else(String::new, |id| WORDS.word(id))
}

/// Text whose control characters are escapes, such as `\u{1b}`.
pub(crate) fn visible(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if c.is_control() {
            out.extend(c.escape_default());
        } else {
            out.push(c);
        }
    }
    out
}
