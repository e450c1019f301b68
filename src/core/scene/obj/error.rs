//! What can be wrong with an OBJ file, and in which line.

use crate::message::{Message, Value};
use std::fmt;

/// Why an OBJ file was refused. Nothing of it was taken.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjError {
    /// What the file is called; `OBJ` until [`named`](Self::named).
    pub file: String,
    /// Counted from 1; `None` for the file as a whole.
    pub line: Option<usize>,
    /// What is wrong.
    pub problem: ObjProblem,
}

/// What is wrong with one line, or with the whole file.
#[derive(Clone, Debug, PartialEq)]
pub enum ObjProblem {
    /// There are no bytes, or only white space.
    Empty,
    /// A zero byte: not a text file.
    Binary,
    /// A statement longer than any face or vertex needs to be.
    LineTooLong {
        /// How long, in bytes.
        bytes: usize,
        /// How long it may be.
        limit: usize,
    },
    /// Not a number.
    Number {
        /// As written, shortened.
        word: String,
    },
    /// NaN, or infinite as a binary32 number.
    NotFinite {
        /// As written, shortened.
        word: String,
    },
    /// Too few or too many numbers.
    Count {
        /// `v`, `vt` or `vn`.
        keyword: &'static str,
        /// How many there are.
        found: usize,
    },
    /// A position whose fourth number, which divides the others, is zero.
    ZeroWeight,
    /// A colour outside 0..=1.
    Color {
        /// As written, shortened.
        word: String,
    },
    /// Some vertices have a colour and some have none.
    SomeColors,
    /// A face with fewer than three corners.
    Corners {
        /// How many it has.
        found: usize,
    },
    /// A corner that is not `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    Corner {
        /// As written, shortened.
        word: String,
    },
    /// The first vertex is 1; or -1 for the last.
    IndexZero,
    /// A face refers to what is not there.
    NoSuchIndex {
        /// As written.
        index: i64,
        /// `v`, `vt` or `vn`.
        keyword: &'static str,
        /// How many there are.
        count: usize,
    },
    /// Nothing to draw.
    NoFaces,
    /// Nothing to draw, and this line is no statement of the format.
    NotObj {
        /// Its first word, shortened.
        word: String,
    },
    /// The parser refuses what the check let pass, in the parser's words.
    Refused {
        /// The parser's words.
        what: String,
    },
}

impl ObjError {
    pub(super) fn whole(problem: ObjProblem) -> Self {
        Self { file: "OBJ".into(), line: None, problem }
    }

    pub(super) fn line(line: usize, problem: ObjProblem) -> Self {
        Self { line: Some(line), ..Self::whole(problem) }
    }

    /// The same error, of the file called `file`.
    #[must_use]
    pub fn named(self, file: &str) -> Self {
        Self { file: file.into(), ..self }
    }

    /// What, where and what to do, as a message.
    pub fn message(&self) -> Message {
        let message = match &self.problem {
            ObjProblem::Empty => Message::new("error-obj-empty"),
            ObjProblem::Binary => Message::new("error-obj-binary"),
            ObjProblem::LineTooLong { bytes, limit } => {
                Message::new("error-obj-line-too-long").with("bytes", *bytes).with("limit", *limit)
            }
            ObjProblem::Number { word } => Message::new("error-obj-number").with("word", Value::text(word)),
            ObjProblem::NotFinite { word } => {
                Message::new("error-obj-not-finite").with("word", Value::text(word))
            }
            ObjProblem::Count { keyword, found } => {
                Message::new("error-obj-count").with("keyword", Value::text(keyword)).with("found", *found)
            }
            ObjProblem::ZeroWeight => Message::new("error-obj-zero-weight"),
            ObjProblem::Color { word } => Message::new("error-obj-color").with("word", Value::text(word)),
            ObjProblem::SomeColors => Message::new("error-obj-some-colors"),
            ObjProblem::Corners { found } => Message::new("error-obj-corners").with("found", *found),
            ObjProblem::Corner { word } => Message::new("error-obj-corner").with("word", Value::text(word)),
            ObjProblem::IndexZero => Message::new("error-obj-index-zero"),
            ObjProblem::NoSuchIndex { index, keyword, count } => Message::new("error-obj-no-such-index")
                .with("index", *index)
                .with("keyword", Value::text(keyword))
                .with("count", *count),
            ObjProblem::NoFaces => Message::new("error-obj-no-faces"),
            ObjProblem::NotObj { word } => Message::new("error-obj-not-obj").with("word", Value::text(word)),
            ObjProblem::Refused { what } => Message::new("error-obj-refused").with("what", Value::text(what)),
        };
        let message = message.with("file", Value::text(&self.file));
        match self.line {
            Some(line) => message.with("line", line),
            None => message,
        }
    }
}

/// For logs and assertions; people read [`ObjError::message`] in their language.
impl fmt::Display for ObjError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for ObjError {}
