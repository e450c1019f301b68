//! Clipping: what part of a line, polygon or triangle lies inside.

pub mod line;
pub mod point;
pub mod polygon;
