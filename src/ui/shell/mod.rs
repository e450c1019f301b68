//! The shell: everything round the canvas that all labs share.

mod algorithm;
pub(crate) mod canvas;
pub(crate) mod choices;
mod halo;
pub(crate) mod handles;
pub(crate) mod header;
pub(crate) mod hints;
pub(crate) mod inspector;
pub(crate) mod keys;
mod lectures;
pub(crate) mod menu;
pub(crate) mod notice;
mod outside;
pub(crate) mod palette;
mod readout;
pub(crate) mod ribbon;
pub(crate) mod split;
pub(crate) mod timeline;

use crate::{aids::Aids, presets::PresetInfo};
use rasterscope_core::compare::Setting;
use rasterscope_figure::theme::ThemeName;
use split::Sides;

/// Windows narrower than this fold: choices into a drawer, the ribbon into a path.
pub(crate) const NARROW: f32 = 1150.0;

/// From this width on the panels at the sides are wider.
pub(crate) const WIDE: f32 = 1640.0;
/// From this width on step and listing stand side by side; at the first start of so large a window
/// everything may be made bigger.
pub(crate) const WIDEST: f32 = 2200.0;

/// What the panels of one frame have in common.
#[derive(Debug)]
pub(crate) struct Frame<'a> {
    pub(crate) theme: ThemeName,
    pub(crate) aids: Aids,
    pub(crate) can_undo: bool,
    pub(crate) can_redo: bool,
    /// Whether the choices are folded into a drawer.
    pub(crate) folded: bool,
    /// The two sides, where two are shown.
    pub(crate) compare: Option<Sides>,
    /// What the open lab can be compared with, while somebody asks.
    pub(crate) settings: Vec<Setting>,
    /// What is open.
    pub(crate) title: String,
    /// On what.
    pub(crate) subtitle: String,
    /// Whether there are edits that are in no file.
    pub(crate) modified: bool,
    /// One sentence about it.
    pub(crate) about: String,
    /// The open lab's name.
    pub(crate) lab: &'static str,
    /// The preset that was opened, until something is edited.
    pub(crate) preset: Option<&'static str>,
    pub(crate) presets: &'a [PresetInfo],
    /// One sentence why the scene matters; may be empty.
    pub(crate) note: String,
    /// Why nothing runs.
    pub(crate) problem: Option<String>,
}
