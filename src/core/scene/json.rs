//! What is wrong with a text that is not JSON, and where.

use crate::message::{Message, Value};
use serde_json::error::Category;

/// Why a text is not JSON.
#[derive(Clone, Debug, PartialEq)]
pub enum JsonFault {
    /// More lists and objects in each other than are read.
    TooDeep,
    /// A number beyond binary64.
    TooLarge,
    /// `NaN` or `Infinity`, which JSON has no numbers for.
    NotANumber,
    /// A number that begins with its point: `.5`.
    BareFraction,
    /// It stops in the middle.
    Ends,
    /// Anything else, in the parser's words.
    Syntax(String),
}

/// A text that is not JSON.
#[derive(Clone, Debug, PartialEq)]
pub struct JsonError {
    /// Why.
    pub fault: JsonFault,
    /// Counted from 1.
    pub line: usize,
    /// Counted from 1.
    pub column: usize,
}

impl JsonError {
    /// Reads the parser's error about `text`.
    pub fn new(text: &str, error: &serde_json::Error) -> Self {
        let (line, column) = (error.line(), error.column());
        let rest = text.lines().nth(line.saturating_sub(1)).unwrap_or_default();
        let rest = rest.get(column.saturating_sub(1)..).unwrap_or_default();
        let said = error.to_string();
        let fault = if said.starts_with("recursion limit") {
            JsonFault::TooDeep
        } else if said.starts_with("number out of range") {
            JsonFault::TooLarge
        } else if ["NaN", "nan", "Inf", "inf"].iter().any(|name| rest.starts_with(name)) {
            JsonFault::NotANumber
        } else if error.classify() == Category::Eof {
            JsonFault::Ends
        } else if rest.starts_with('.') {
            JsonFault::BareFraction
        } else {
            // The parser appends the place, which is told separately.
            let end = said.rfind(" at line ").unwrap_or(said.len());
            JsonFault::Syntax(said[..end].to_owned())
        };
        Self { fault, line, column }
    }

    /// What, where and what to do, about a scene.
    pub fn message(&self) -> Message {
        match &self.fault {
            JsonFault::TooDeep => self.at("error-json-too-deep"),
            JsonFault::TooLarge => self.at("error-json-number"),
            JsonFault::NotANumber => self.at("error-json-nan"),
            JsonFault::BareFraction => self.at("error-json-fraction"),
            JsonFault::Ends => self.at("error-scene-json-ends"),
            JsonFault::Syntax(what) => self.at("error-scene-json").with("what", Value::text(what)),
        }
    }

    /// A message about this place.
    pub fn at(&self, id: &'static str) -> Message {
        Message::new(id).with("line", self.line).with("column", self.column)
    }
}
