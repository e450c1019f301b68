//! The numbers of a step: formulas and tables.

use super::Role;
use crate::message::Value;

/// One piece of a formula.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// Signs and names, the same in every language.
    Text(&'static str),
    /// A number put in.
    Number(Value),
    /// The number that comes out: highlighted.
    Result(Value),
}

/// A formula in its names, and the same with this step's numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// Such as `t = (ymin − y1) / (y2 − y1)`.
    pub general: &'static str,
    /// The same with numbers, piece by piece.
    pub numbers: Vec<Piece>,
}

/// Values to show as a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Message id of its title.
    pub title: &'static str,
    /// Headings; names of the listing or message ids that start with `column-`.
    pub columns: Vec<&'static str>,
    /// Rows in order.
    pub rows: Vec<Row>,
}

/// One row of a [`Table`].
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its heading: a name of the listing, an index, or a message id that starts with `row-`.
    pub name: String,
    /// One value for each column.
    pub cells: Vec<Value>,
    /// Whether it is the row the step is about.
    pub active: bool,
    /// A marker before it.
    pub role: Option<Role>,
}

impl Row {
    /// A row without marks.
    pub fn new(name: impl Into<String>, cells: Vec<Value>) -> Self {
        Self { name: name.into(), cells, active: false, role: None }
    }

    /// Marks it as what the step is about.
    #[must_use]
    pub fn active(mut self, active: bool) -> Self {
        self.active = active;
        self
    }

    /// Puts a marker before it.
    #[must_use]
    pub fn role(mut self, role: impl Into<Option<Role>>) -> Self {
        self.role = role.into();
        self
    }
}
