//! Names and values beside what is drawn.

use crate::message::Value;

/// A name with values, shown in one plate: `P1′ (2.375, 2)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// A name of the listing or of the document; empty for a bare value.
    pub name: String,
    /// Shown behind the name; a vector in parentheses.
    pub value: Value,
    /// Index of the object that it names: the plate wears its fill.
    pub object: Option<usize>,
}

impl Label {
    /// A name without a value.
    pub fn name(name: impl Into<String>) -> Self {
        Self::new(name, Value::None)
    }

    /// A name and its value.
    pub fn new(name: impl Into<String>, value: impl Into<Value>) -> Self {
        Self { name: name.into(), value: value.into(), object: None }
    }

    /// Says that it names an object, whose fill the plate wears.
    #[must_use]
    pub fn of(mut self, object: usize) -> Self {
        self.object = Some(object);
        self
    }
}
