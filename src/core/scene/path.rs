//! A problem with the path to it, which grows from the inside out as the error travels up.

use super::error::{Problem, SceneError, shortened};
use std::fmt::Write;

/// One step down into a document.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Step {
    Field(String),
    Item(usize),
}

impl From<&str> for Step {
    fn from(field: &str) -> Self {
        Self::Field(shortened(field))
    }
}

impl From<usize> for Step {
    fn from(item: usize) -> Self {
        Self::Item(item)
    }
}

/// A problem and the steps to it, innermost first.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FieldError {
    problem: Problem,
    steps: Vec<Step>,
}

impl FieldError {
    /// A problem with the value at hand.
    pub(crate) fn here(problem: Problem) -> Self {
        Self { problem, steps: Vec::new() }
    }

    /// A problem with one field or item of the value at hand.
    pub(crate) fn at(step: impl Into<Step>, problem: Problem) -> Self {
        Self::here(problem).within(step)
    }

    /// The same problem; if it is an unknown field of the value at hand, these are known as well.
    pub(crate) fn with_known(mut self, more: &[&'static str]) -> Self {
        if let (Problem::UnknownField { known }, 1) = (&mut self.problem, self.steps.len()) {
            known.splice(0..0, more.iter().copied());
        }
        self
    }

    /// The same problem, seen from one level further out.
    pub(crate) fn within(mut self, step: impl Into<Step>) -> Self {
        self.steps.push(step.into());
        self
    }
}

impl From<FieldError> for SceneError {
    fn from(error: FieldError) -> Self {
        let mut path = String::new();
        for step in error.steps.iter().rev() {
            match step {
                Step::Field(name) if path.is_empty() => path.push_str(name),
                Step::Field(name) => {
                    path.push('.');
                    path.push_str(name);
                }
                Step::Item(i) => write!(path, "[{i}]").unwrap_or(()), // writing to a String cannot fail
            }
        }
        Self::Field { path, problem: error.problem }
    }
}
