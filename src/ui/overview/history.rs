//! The history of a pixel in words.

use rasterscope_core::{explain::Role, message::Value, pipeline::PixelHistory, scene::Scene};
use rasterscope_figure::words::Words;

/// What happened to a pixel, ready to be shown.
#[derive(Clone, Debug)]
pub(crate) struct History {
    pub(crate) pixel: [u32; 2],
    /// Its colour codes now.
    pub(crate) color: [u8; 4],
    /// What the clear left, in order: depth, code.
    pub(crate) clear: String,
    pub(crate) entries: Vec<Entry>,
    pub(crate) sentence: String,
}

/// One fragment, or what kept it from becoming one.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) name: String,
    pub(crate) reason: String,
    pub(crate) role: Role,
    pub(crate) details: Vec<String>,
}

impl History {
    pub(crate) fn new(history: &PixelHistory, scene: &Scene, words: &Words) -> Self {
        let entries = history.entries.iter().map(|entry| Entry {
            name: entry.name.clone(),
            reason: words.message(&entry.reason()),
            role: entry.role(),
            details: entry.details(scene).iter().map(|line| words.message(line)).collect(),
        });
        Self {
            pixel: history.pixel,
            color: history.color,
            clear: words.value(&Value::F64(scene.depth_format.decode(history.clear_depth))),
            entries: entries.collect(),
            sentence: words.message(&history.sentence()),
        }
    }
}
