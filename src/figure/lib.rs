//! From what the core says to what people see and read, with no window.
//!
//! [`layout`] turns the marks of a lab into a [`Figure`](figure::Figure) of flat shapes; the window
//! paints that figure, and [`svg`] and [`png`] write it to a file. [`theme`] maps a role to colour,
//! marker and dash; [`numbers`] writes values; [`words`] holds every sentence. There is no I/O here,
//! no clock, no thread and no window toolkit.
#![forbid(unsafe_code)]

pub mod numbers;
pub mod words;

mod precision;
pub mod tables;

pub mod theme;
mod tokens;

pub mod figure;
pub mod geometry;
pub mod glossary;
pub mod markers;
pub mod placement;
pub mod text;

mod canvas;
mod cells;
mod grid;
mod interior;
mod labels;
pub mod layout;
mod legend;
pub mod orbit;
pub mod overlay;
pub mod plot;
pub mod space;
pub mod split;

pub mod animation;
pub mod png;
pub mod svg;
