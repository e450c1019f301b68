//! The presets as the window lists them.

use rasterscope_core::scene::{PRESETS, Scene};
use rasterscope_figure::words::Words;
use std::collections::HashSet;

/// A preset with its words, and the lab that it opens.
#[derive(Clone, Debug)]
pub(crate) struct PresetInfo {
    pub(crate) name: &'static str,
    pub(crate) title: String,
    pub(crate) note: String,
    pub(crate) lab: &'static str,
}

/// All presets that can be read; a test says that all can.
pub(crate) fn all(names: &Names, words: &Words) -> Vec<PresetInfo> {
    PRESETS
        .iter()
        .filter_map(|preset| {
            let scene = Scene::from_json(preset.json.as_bytes()).ok()?;
            let lab = scene.lab.as_ref().map_or("pipeline", |lab| lab.input.name());
            let (title, note) = (names.text(words, &scene.name), names.text(words, &scene.note));
            Some(PresetInfo { name: preset.name, title, note, lab })
        })
        .collect()
}

/// All ids of messages: a scene's name and note may be one of them.
#[derive(Debug)]
pub(crate) struct Names(HashSet<&'static str>);

impl Names {
    pub(crate) fn new(words: &Words) -> Self {
        Self(words.ids().into_iter().map(|(_, id)| id).collect())
    }

    /// A scene's name or note: text, or the words of a message.
    pub(crate) fn text(&self, words: &Words, text: &str) -> String {
        self.0.get(text).map_or_else(|| text.to_owned(), |id| words.word(id))
    }
}
