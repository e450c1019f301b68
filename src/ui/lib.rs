//! The window's contents: shell and labs, in egui and nothing else of a window.
//!
//! [`App::ui`] is one frame, always in the same order: keys, run, panels, edits, commands. The
//! shell owns cursor, transport, listing, inspector, canvas and keys; a lab says what can be dragged
//! and chosen. The canvas paints the same [`Figure`](rasterscope_figure::figure::Figure) that is
//! exported. There is no file here, no clock, no thread and no blocking call: [`Platform`] has the
//! files and the clock to measure with; other time comes with egui's input.
#![forbid(unsafe_code)]

mod aids;
mod app;
mod commands;
mod document;
mod evaluation;
mod export;
mod face;
mod files;
mod film;
mod keeping;
mod labs;
mod link;
mod measure;
mod opening;
mod overview;
mod paint;
mod panels;
mod platform;
mod presets;
mod recent;
mod run;
mod session;
mod shell;
mod skips;
mod split;
mod task;
mod theme;
mod widgets;

pub use app::App;
pub use platform::{Clock, Platform, Purpose, Reader};

#[cfg(test)]
mod tests;
