//! What the core says to people: message ids with arguments, never sentences.
//!
//! The words stand in the language files under `assets/i18n`; the figure crate joins the two.

use std::fmt::Display;

/// A sentence to be: the id of a message in the language files, and its arguments by name.
#[derive(Clone, Debug, PartialEq)]
pub struct Message {
    /// The message's id, such as `cohen-sutherland-cut`.
    pub id: &'static str,
    /// Arguments by the names that the message uses.
    pub args: Vec<(&'static str, Value)>,
}

impl Message {
    /// A message without arguments.
    pub fn new(id: &'static str) -> Self {
        Self { id, args: Vec::new() }
    }

    /// Adds one argument.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: impl Into<Value>) -> Self {
        self.args.push((name, value.into()));
        self
    }
}

/// One value to be shown, with its kind; how it is written is the figure crate's business.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Not defined (yet).
    None,
    /// A count or an index.
    Int(i64),
    /// A binary32 value: a coordinate, a depth, an attribute.
    F32(f32),
    /// A binary64 value: an intermediate result.
    F64(f64),
    /// A point or vector of binary32 values.
    Vector(Vec<f32>),
    /// Single bits, most significant first, `width` of them: an outcode, a mask.
    Bits {
        /// The bits, right-aligned.
        bits: u32,
        /// How many are shown.
        width: u8,
    },
    /// A stored code of `width` bits, shown in hexadecimal: a depth code.
    Code {
        /// The code.
        code: u32,
        /// Its width in bits.
        width: u8,
    },
    /// The id of a word or phrase in the language files.
    Word(&'static str),
    /// Text that is the same in every language: a name of the listing, or the user's own.
    Text(String),
}

impl Value {
    /// Nothing to say here: a cell that stays empty, unlike the undefined [`Value::None`].
    pub const BLANK: Self = Self::Text(String::new());

    /// [`Value::Text`] of anything that prints.
    pub fn text(text: impl Display) -> Self {
        Self::Text(text.to_string())
    }

    /// A count or an index.
    pub fn count(n: usize) -> Self {
        Self::Int(i64::try_from(n).unwrap_or(i64::MAX))
    }
}

impl From<f32> for Value {
    fn from(value: f32) -> Self {
        Self::F32(value)
    }
}

impl From<f64> for Value {
    fn from(value: f64) -> Self {
        Self::F64(value)
    }
}

impl From<i64> for Value {
    fn from(value: i64) -> Self {
        Self::Int(value)
    }
}

impl From<i32> for Value {
    fn from(value: i32) -> Self {
        Self::Int(value.into())
    }
}

impl From<u32> for Value {
    fn from(value: u32) -> Self {
        Self::Int(value.into())
    }
}

impl From<usize> for Value {
    fn from(value: usize) -> Self {
        Self::count(value)
    }
}

impl<const N: usize> From<[f32; N]> for Value {
    fn from(value: [f32; N]) -> Self {
        Self::Vector(value.to_vec())
    }
}

impl<T: Into<Self>> From<Option<T>> for Value {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::None, Into::into)
    }
}
