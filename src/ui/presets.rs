//! The presets as the window lists them.

use rasterscope_core::scene::{PRESETS, Scene};
use rasterscope_figure::words::Words;

/// A preset with its words, and the lab that it opens.
#[derive(Clone, Debug)]
pub(crate) struct PresetInfo {
    pub(crate) name: &'static str,
    pub(crate) title: String,
    pub(crate) note: String,
    pub(crate) lab: &'static str,
}

/// All presets that can be read; a test says that all can.
pub(crate) fn all(words: &Words) -> Vec<PresetInfo> {
    PRESETS
        .iter()
        .filter_map(|preset| {
            let scene = Scene::from_json(preset.json.as_bytes()).ok()?;
            let lab = scene.lab.as_ref().map_or("pipeline", |lab| lab.input.name());
            let (title, note) = (text(words, &scene.name), text(words, &scene.note));
            Some(PresetInfo { name: preset.name, title, note, lab })
        })
        .collect()
}

/// A scene's name or note: text, or the id of a message.
pub(crate) fn text(words: &Words, text: &str) -> String {
    let id = words.ids().into_iter().map(|(_, id)| id).find(|id| *id == text);
    id.map_or_else(|| text.to_owned(), |id| words.word(id))
}
