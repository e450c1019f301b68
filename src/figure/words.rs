//! Every sentence in one place: the Fluent files of `assets/i18n`, embedded and joined with values.
//!
//! A file is named after the algorithm or part that it speaks for, and its ids start with that
//! name; `words` holds what several share (`column-...`, `error-...`, `preset-...` and single
//! words). Adding a file is adding its name to [`LANGUAGES`].

use std::{fmt::Write, io};

use fluent_bundle::{FluentArgs, FluentResource, FluentValue, concurrent::FluentBundle};
use fluent_syntax::ast::Entry;
use rasterscope_core::message::{Message, Value};
use unic_langid::LanguageIdentifier;

use crate::numbers;

/// Stands before and after what is bold in a sentence of the language files: `**bottom**`.
const STRONG: &str = "**";

/// A piece of a line of text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// What is written.
    pub text: String,
    /// Whether it is bold.
    pub strong: bool,
    /// Whether it is the result of a formula: wears the highlighter.
    pub highlighted: bool,
}

/// A text of the language files in pieces: what stands between two `**` is bold.
pub fn runs(marked: &str) -> Vec<Run> {
    let pieces = marked.split(STRONG).enumerate().filter(|(_, text)| !text.is_empty());
    let run = |(i, text): (usize, &str)| Run { text: text.into(), strong: i % 2 == 1, highlighted: false };
    pieces.map(run).collect()
}

/// A text of the language files as plain text.
pub fn plain(marked: &str) -> String {
    marked.replace(STRONG, "")
}

/// The operating system's reason, as an argument of a sentence.
pub fn reason(error: &io::Error) -> Value {
    use io::ErrorKind as Kind;
    match error.kind() {
        Kind::NotFound => Value::Word("word-does-not-exist"),
        Kind::AlreadyExists => Value::Word("word-is-in-the-way"),
        Kind::PermissionDenied => Value::Word("word-no-permission"),
        Kind::IsADirectory => Value::Word("word-is-a-folder"),
        Kind::NotADirectory => Value::Word("word-is-no-folder"),
        Kind::ReadOnlyFilesystem => Value::Word("word-read-only"),
        Kind::StorageFull | Kind::QuotaExceeded => Value::Word("word-disk-full"),
        Kind::FileTooLarge => Value::Word("word-too-large"),
        _ => Value::text(error),
    }
}

/// One language: its tag and its files by name.
#[derive(Clone, Copy, Debug)]
pub struct Language {
    /// Such as `en`; the folder's name.
    pub tag: &'static str,
    /// Name without `.ftl`, and contents.
    pub files: &'static [(&'static str, &'static str)],
}

macro_rules! language {
    ($tag:literal: $($file:literal)*) => {
        Language {
            tag: $tag,
            files: &[$((
                $file,
                include_str!(concat!("../../assets/i18n/", $tag, "/", $file, ".ftl")),
            )),*],
        }
    };
}

/// All languages, the source language first.
pub const LANGUAGES: &[Language] = &[language!("en":
    "words"
    "labs"
    "scene"
    "ui"
    "glossary"
    "compare"
    "pipeline"
    "transform"
    "back-face"
    "frustum-culling"
    "bvh"
    "clip-line"
    "point-clipping"
    "cohen-sutherland"
    "liang-barsky"
    "clip-plane"
    "cyrus-beck"
    "midpoint"
    "nicholl-lee-nicholl"
    "sutherland-hodgman"
    "weiler-atherton"
    "clip-triangle"
    "aabb"
    "traversal"
    "backtracking"
    "zigzag"
    "tiled"
    "homogeneous"
    "scanline"
    "edge-table"
    "dda"
    "bresenham"
    "diamond-exit"
    "points"
    "msaa"
    "area-ratios"
    "plane-equation"
    "perspective-correction"
    "shade"
    "lighting"
    "shading"
    "stencil"
    "z-buffer"
    "depth-precision"
    "blend"
    "stress"
    "bench"
    "measure"
    "figure"
    "cli"
    "tour"
    "app"
)];

/// The words of one language.
pub struct Words {
    language: Language,
    bundle: FluentBundle<FluentResource>,
}

impl std::fmt::Debug for Words {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Words({})", self.language.tag)
    }
}

impl Default for Words {
    fn default() -> Self {
        Self::new(LANGUAGES[0].tag)
    }
}

impl Words {
    /// The words of `language`; of the source language if there is no such language.
    pub fn new(language: &str) -> Self {
        let language = LANGUAGES.iter().find(|each| each.tag == language).copied().unwrap_or(LANGUAGES[0]);
        let tag: LanguageIdentifier = language.tag.parse().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![tag]);
        bundle.set_use_isolating(false);
        bundle.set_formatter(Some(|value, _| match value {
            FluentValue::Number(number) => Some(numbers::integer(number.value as i64)),
            _ => None,
        }));
        for (_, source) in language.files {
            // What parses of a file with an error stays; a test demands that nothing is lost.
            let resource = match FluentResource::try_new((*source).to_owned()) {
                Ok(resource) | Err((resource, _)) => resource,
            };
            bundle.add_resource_overriding(resource);
        }
        Self { language, bundle }
    }

    /// The language's tag.
    pub fn language(&self) -> &'static str {
        self.language.tag
    }

    /// The sentence of `message` with its values, as plain text; `⟨id⟩` if there is none.
    pub fn message(&self, message: &Message) -> String {
        self.try_message(message).unwrap_or_else(|_| format!("⟨{}⟩", message.id))
    }

    /// The sentence of `message` with what is bold in it; `⟨id⟩` if there is none.
    pub fn runs(&self, message: &Message) -> Vec<Run> {
        runs(&self.format(message.id, &message.args).unwrap_or_else(|_| format!("⟨{}⟩", message.id)))
    }

    /// The word or phrase `id`, as plain text; `⟨id⟩` if there is none.
    pub fn word(&self, id: &str) -> String {
        self.format(id, &[]).map_or_else(|_| format!("⟨{id}⟩"), |marked| plain(&marked))
    }

    /// Whether there is a message `id`.
    pub fn has(&self, id: &str) -> bool {
        self.bundle.has_message(id)
    }

    /// `value` in its shortest form; a [`Value::Word`] in words.
    pub fn value(&self, value: &Value) -> String {
        self.fine(value, numbers::DECIMALS)
    }

    /// Like [`Words::value`], with at most `decimals` decimals.
    pub(crate) fn fine(&self, value: &Value, decimals: usize) -> String {
        match value {
            Value::Word(id) => self.word(id),
            other => numbers::fine(other, decimals),
        }
    }

    /// The sentence of `message` as plain text, or what is wrong with it: unknown, or a value missing.
    pub fn try_message(&self, message: &Message) -> Result<String, String> {
        self.format(message.id, &message.args).map(|marked| plain(&marked))
    }

    fn format(&self, id: &str, args: &[(&'static str, Value)]) -> Result<String, String> {
        let pattern = self
            .bundle
            .get_message(id)
            .and_then(|found| found.value())
            .ok_or_else(|| format!("{id}: no such message in {}", self.language.tag))?;
        let mut values = FluentArgs::with_capacity(args.len());
        for (name, value) in args {
            values.set(
                *name,
                match value {
                    // A number stays one, so that a message can choose its plural form.
                    Value::Int(n) if n.unsigned_abs() < 1 << 53 => FluentValue::from(*n),
                    other => FluentValue::from(self.value(other)),
                },
            );
        }
        let mut errors = Vec::new();
        let text = self.bundle.format_pattern(pattern, Some(&values), &mut errors).into_owned();
        if errors.is_empty() {
            return Ok(text);
        }
        let mut report = format!("{id}:");
        for error in errors {
            // Writing to a String cannot fail.
            let _ = write!(report, " {error}");
        }
        Err(report)
    }

    /// All ids, each with the name of its file, in the order of the files.
    pub fn ids(&self) -> Vec<(&'static str, &'static str)> {
        let mut ids = Vec::new();
        for &(file, source) in self.language.files {
            // A borrowed parse, so that the ids live as long as the program.
            let resource = match fluent_syntax::parser::parse(source) {
                Ok(resource) | Err((resource, _)) => resource,
            };
            ids.extend(resource.body.iter().filter_map(|entry| match entry {
                Entry::Message(message) => Some((file, message.id.name)),
                _ => None,
            }));
        }
        ids
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_put_in_and_written_as_numbers() {
        let words = Words::default();
        let message =
            Message::new("figure-values-hidden").with("cells", 1204).with("size", 18_i32).with("zoom", 3.0);
        let text = words.message(&message);
        assert!(text.contains("1\u{2009}204"), "{text}");
        assert!(!text.contains('\u{2068}'), "isolation marks: {text}");
    }

    #[test]
    fn bold_words_are_runs_of_their_own_and_plain_text_has_no_signs() {
        let pieces = |marked| runs(marked).into_iter().map(|run| (run.text, run.strong)).collect::<Vec<_>>();
        let piece = |text: &str, strong| (text.to_owned(), strong);
        assert_eq!(
            pieces("the **bottom** bit"),
            [piece("the ", false), piece("bottom", true), piece(" bit", false)]
        );
        assert_eq!(pieces("**P1** moves"), [piece("P1", true), piece(" moves", false)]);
        assert_eq!(pieces(""), []);
        assert_eq!(plain("the **bottom** bit"), "the bottom bit");
    }

    #[test]
    fn words_inside_values_are_resolved() {
        let words = Words::default();
        assert_eq!(words.value(&Value::Word("figure-dark")), "Dark");
        assert_eq!(words.value(&Value::F32(0.25)), "0.25");
    }

    #[test]
    fn an_unknown_message_shows_its_id_and_a_missing_value_is_an_error() {
        let words = Words::new("tlh");
        assert_eq!(words.language(), "en");
        assert_eq!(words.word("no-such-message"), "⟨no-such-message⟩");
        assert!(words.try_message(&Message::new("no-such-message")).is_err());
        assert!(words.try_message(&Message::new("figure-values-hidden")).is_err());
    }
}
