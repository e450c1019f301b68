//! Diagrams of measured numbers: points, curves and bars over two axes.
//!
//! A [`Plot`] says what is shown, [`draw`] lays it out as a [`Figure`], which the window paints and the files
//! hold. Coordinates of a figure are points, y down. A logarithmic axis has no place for 0, so that what is
//! right to the last bit gets a lane of its own at the axis' start; what is infinite gets one at its end. A
//! value that is no number, or below 0 on a logarithmic axis, is left out. Cost: a few microseconds a point.

mod bars;
mod draw;
mod labels;
mod points;
mod ruler;

pub use draw::{Drawn, Spot, draw, mark, panels};

use rasterscope_core::explain::Role;

#[cfg(doc)]
use crate::figure::Figure;

/// A diagram.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// What it shows.
    pub title: String,
    /// In which way, in a sentence or two; wrapped.
    pub subtitle: String,
    /// Across and up.
    pub axes: [Axis; 2],
    /// The points.
    pub series: Vec<Series>,
    /// Lines that points are held against.
    pub guides: Vec<Guide>,
    /// What the line along the points to which none is preferable is called; `None`: there is no such line.
    /// Less is better on both axes.
    pub frontier: Option<String>,
    /// Where it was measured, such as the machine; wrapped.
    pub foot: String,
}

/// One axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What is measured, with its unit.
    pub title: String,
    /// How numbers become places.
    pub scale: Scale,
    /// The name of the lane of 0, on a logarithmic axis.
    pub zero: String,
    /// The name of the lane of what is infinite.
    pub infinite: String,
}

/// How numbers become places.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Each step is a factor.
    Log,
    /// Each step is a sum; begins at 0.
    Linear,
    /// A place for each name; numbers count them from 0. Points are bars. For the axis across only.
    Names(Vec<String>),
}

/// Points that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Its name in the key.
    pub name: String,
    /// Its colour, marker and dash.
    pub role: Role,
    /// Whether a line joins the points.
    pub joined: bool,
    /// The points, in the order of the line.
    pub points: Vec<Point>,
}

/// A point.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Across and up.
    pub at: [f64; 2],
    /// From where to where it could as well be, along the axis up.
    pub spread: Option<[f64; 2]>,
    /// Its name, written beside it if there is room; empty: none.
    pub label: String,
}

/// A line right through the diagram.
#[derive(Clone, Debug, PartialEq)]
pub struct Guide {
    /// Up the axis so far.
    pub at: f64,
    /// What it says.
    pub label: String,
}

impl Axis {
    /// An axis without names for its lanes.
    pub fn new(title: String, scale: Scale) -> Self {
        Self { title, scale, zero: "0".to_owned(), infinite: "∞".to_owned() }
    }
}

#[cfg(test)]
mod tests;
