//! Inputs of a lab that are a choice among a few values.

use serde_json::Value;

/// One value of an input that is a choice: a mistake, an order, a set of planes.
///
/// It is known by how the scene file writes it, so a family of labs lists its choices and nothing
/// else: reading, writing and comparing go through the file's own form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Choice {
    /// The field of the lab.
    pub field: &'static str,
    /// Message id of what the input is called.
    pub heading: &'static str,
    /// The value as JSON.
    pub json: &'static str,
    /// Message id of the value.
    pub word: &'static str,
}

impl Choice {
    /// All values of one field, each as JSON with its words; the first is the default, which a file may
    /// leave out.
    pub(crate) fn all<const N: usize>(
        field: &'static str,
        heading: &'static str,
        values: [(&'static str, &'static str); N],
    ) -> [Self; N] {
        values.map(|(json, word)| Self { field, heading, json, word })
    }

    /// Whether a file has this value. Numbers count by what they are, not by how they are written.
    pub(crate) fn is(self, value: &Value) -> bool {
        match (self.value(), value) {
            (Value::Number(own), Value::Number(other)) => own.as_f64() == other.as_f64(),
            (own, other) => own == *other,
        }
    }

    /// The value as it stands in a file.
    pub(crate) fn value(self) -> Value {
        // Written in this program, as JSON.
        serde_json::from_str(self.json).unwrap_or(Value::Null)
    }
}
