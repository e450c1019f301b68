//! What can be wrong with a scene file, and where.

use super::{json::JsonError, obj::ObjError};
use crate::{
    clip::line::Flaw,
    message::{Message, Value},
};
use std::fmt;

/// Why a scene was refused. Nothing of it was taken.
#[derive(Clone, Debug, PartialEq)]
pub enum SceneError {
    /// There are no bytes, or only white space.
    Empty,
    /// Not UTF-8, or with a zero byte: not a text file.
    NotText {
        /// Counted from 1.
        line: usize,
    },
    /// Larger than any scene file needs to be: big meshes belong into an OBJ file.
    TooLarge {
        /// How large.
        bytes: usize,
        /// How large it may be.
        limit: usize,
    },
    /// Not JSON.
    Json(JsonError),
    /// JSON, but not a scene that makes sense.
    Field {
        /// Such as `draws[2].vertices[0][1]`; empty for the whole document.
        path: String,
        /// What is wrong there.
        problem: Problem,
    },
    /// A model could not be read.
    Unreadable {
        /// The field that names it.
        path: String,
        /// As the scene names it.
        file: String,
        /// In the words of whoever tried to read it.
        reason: String,
    },
    /// A model was read and refused.
    Model {
        /// The field that names it.
        path: String,
        /// What is wrong with it; knows its file.
        error: ObjError,
    },
}

/// What is wrong with one field.
#[derive(Clone, Debug, PartialEq)]
pub enum Problem {
    /// Another kind of value was expected.
    Kind {
        /// Expected.
        wanted: Kind,
        /// There.
        found: Kind,
    },
    /// A list of another length was expected.
    Length {
        /// Expected.
        wanted: usize,
        /// There.
        found: usize,
    },
    /// A longer list was expected.
    TooShort {
        /// Least.
        least: usize,
        /// There.
        found: usize,
    },
    /// A field that must be there is not.
    Missing,
    /// No such field, or not together with the others.
    UnknownField {
        /// The fields that there are.
        known: Vec<&'static str>,
    },
    /// No such name.
    UnknownName {
        /// As written.
        name: String,
        /// The names that there are.
        known: Vec<&'static str>,
    },
    /// Two fields of which only one may be there.
    Both {
        /// The other one.
        other: &'static str,
    },
    /// Not marked as a scene of this program.
    NotAScene,
    /// Written by a newer program.
    Newer {
        /// Its version.
        version: u32,
        /// The newest version that can be read.
        known: u32,
    },
    /// NaN, or infinite as a binary32 number.
    NotFinite,
    /// Less than zero, where things are counted.
    Negative,
    /// Outside its range, both ends of which are allowed.
    Range {
        /// Least.
        min: f64,
        /// Greatest.
        max: f64,
    },
    /// Must be more than zero.
    NotPositive,
    /// Must be a power of two.
    NoPowerOfTwo,
    /// The field of view must be between 0 and 180 degrees, exclusively.
    FieldOfView,
    /// The far plane must lie beyond the near plane.
    FarBeforeNear,
    /// The camera looks at itself.
    EyeIsTarget,
    /// The camera's up is parallel to the line of sight, or zero.
    UpParallel,
    /// Width times height is too much.
    TooManyPixels {
        /// Greatest product.
        limit: u32,
    },
    /// More than one sample in each pixel.
    Samples,
    /// Without indices, the number of vertices must be a multiple of three.
    NotTriples {
        /// How many there are.
        found: usize,
    },
    /// No vertex has this index.
    NoSuchVertex {
        /// The index.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// There must be one for each vertex.
    NotOneEach {
        /// How many there are.
        found: usize,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A texture needs texture coordinates.
    NoTextureCoordinates,
    /// A choice among none.
    NoneThere,
    /// A model's name that can be no file: empty, or with a zero character.
    NoFileName,
    /// The window's minimum exceeds its maximum.
    WindowReversed,
    /// The polygon is no convex window.
    Polygon(Flaw),
    /// A comparison without a setting in which the sides differ.
    NoSetting,
    /// Anything else, in the words of a library.
    Other(String),
}

/// The kinds of JSON values, as a person names them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names are the meaning")]
pub enum Kind {
    Null,
    Bool,
    Number,
    WholeNumber,
    Fraction,
    Text,
    List,
    Object,
}

impl Kind {
    /// The id of its name in the language files.
    fn word(self) -> Value {
        Value::Word(match self {
            Self::Null => "error-scene-kind-null",
            Self::Bool => "error-scene-kind-bool",
            Self::Number => "error-scene-kind-number",
            Self::WholeNumber => "error-scene-kind-whole-number",
            Self::Fraction => "error-scene-kind-fraction",
            Self::Text => "error-scene-kind-text",
            Self::List => "error-scene-kind-list",
            Self::Object => "error-scene-kind-object",
        })
    }
}

impl SceneError {
    /// What, where and what to do, as a message.
    pub fn message(&self) -> Message {
        match self {
            Self::Empty => Message::new("error-scene-empty"),
            Self::NotText { line } => Message::new("error-scene-not-text").with("line", *line),
            Self::TooLarge { bytes, limit } => {
                Message::new("error-scene-too-large").with("bytes", *bytes).with("limit", *limit)
            }
            Self::Json(error) => error.message(),
            Self::Field { path, problem } => problem.message().with("path", Value::text(path)),
            Self::Unreadable { path, file, reason } => Message::new("error-scene-unreadable")
                .with("path", Value::text(path))
                .with("file", Value::text(file))
                .with("reason", Value::text(reason)),
            Self::Model { path, error } => error.clone().named(&format!("{path}: {}", error.file)).message(),
        }
    }
}

impl Problem {
    fn message(&self) -> Message {
        match self {
            Self::Kind { wanted, found } => {
                Message::new("error-scene-kind").with("wanted", wanted.word()).with("found", found.word())
            }
            Self::Length { wanted, found } => {
                Message::new("error-scene-length").with("wanted", *wanted).with("found", *found)
            }
            Self::Missing => Message::new("error-scene-missing"),
            Self::UnknownField { known } => {
                Message::new("error-scene-unknown-field").with("known", Value::text(known.join(", ")))
            }
            Self::TooShort { least, found } => {
                Message::new("error-scene-too-short").with("least", *least).with("found", *found)
            }
            Self::UnknownName { name, known } => Message::new("error-scene-unknown-name")
                .with("name", Value::text(name))
                .with("known", Value::text(known.join(", "))),
            Self::Both { other } => Message::new("error-scene-both").with("other", Value::text(other)),
            Self::NotAScene => Message::new("error-scene-not-a-scene"),
            Self::Newer { version, known } => {
                Message::new("error-scene-newer").with("version", Value::text(version)).with("known", *known)
            }
            Self::NotFinite => Message::new("error-scene-not-finite"),
            Self::Negative => Message::new("error-scene-negative"),
            Self::Range { min, max } if min == max => {
                Message::new("error-scene-must-be").with("value", limit(*min))
            }
            Self::Range { min, max } => {
                Message::new("error-scene-range").with("min", limit(*min)).with("max", limit(*max))
            }
            Self::NotPositive => Message::new("error-scene-not-positive"),
            Self::NoPowerOfTwo => Message::new("error-scene-no-power-of-two"),
            Self::FieldOfView => Message::new("error-scene-field-of-view"),
            Self::FarBeforeNear => Message::new("error-scene-far-before-near"),
            Self::EyeIsTarget => Message::new("error-scene-eye-is-target"),
            Self::UpParallel => Message::new("error-scene-up-parallel"),
            Self::TooManyPixels { limit } => {
                Message::new("error-scene-too-many-pixels").with("limit", *limit)
            }
            Self::Samples => Message::new("error-scene-samples"),
            Self::NotTriples { found } => Message::new("error-scene-not-triples").with("found", *found),
            Self::NoSuchVertex { index, vertices } => {
                Message::new("error-scene-no-such-vertex").with("index", *index).with("vertices", *vertices)
            }
            Self::NotOneEach { found, vertices } => {
                Message::new("error-scene-not-one-each").with("found", *found).with("vertices", *vertices)
            }
            Self::NoTextureCoordinates => Message::new("error-scene-no-texture-coordinates"),
            Self::NoneThere => Message::new("error-scene-none-there"),
            Self::NoFileName => Message::new("error-scene-no-file-name"),
            Self::WindowReversed => Message::new("error-scene-window-reversed"),
            Self::Polygon(flaw) => Message::new(flaw.problem()),
            Self::NoSetting => Message::new("error-scene-no-setting"),
            Self::Other(what) => Message::new("error-scene-other").with("what", Value::text(what)),
        }
    }
}

/// An end of a range; a whole one with all its digits.
fn limit(value: f64) -> Value {
    const EXACT: f64 = 9_007_199_254_740_992.0; // 2^53
    if value.fract() == 0.0 && value.abs() < EXACT { Value::Int(value as i64) } else { Value::F64(value) }
}

/// The beginning of a name of a scene file, for a message: a hostile one may be megabytes long.
pub(super) fn shortened(text: &str) -> String {
    beginning(text, 40)
}

/// The first characters of a text, `most` at most.
pub(super) fn beginning(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.into(),
    }
}

/// For logs and assertions; people read [`SceneError::message`] in their language.
impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for SceneError {}
