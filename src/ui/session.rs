//! What is kept from one start to the next: the work, and how it is looked at.

use crate::{
    aids::Aids,
    document::{Document, Snap, ViewState},
    files,
    recent::Recent,
};
use rasterscope_core::{
    explain::Level,
    labs::LabInput,
    message::Message,
    pipeline::Overlay,
    scene::{Lab, Scene},
};
use rasterscope_figure::theme::ThemeName;
use serde::{Deserialize, Serialize};

/// The work and the settings as one text.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Session {
    /// How things are looked at.
    #[serde(default)]
    pub(crate) settings: Settings,
    /// Where the document came from.
    pub(crate) path: Option<String>,
    /// The preset that was opened.
    pub(crate) preset: Option<String>,
    /// Whether there are edits that are in no file.
    pub(crate) modified: bool,
    /// The document, with the step in its lab.
    pub(crate) scene: Scene,
    /// The inputs of the labs that are not open, each in a scene that draws nothing.
    #[serde(default)]
    pub(crate) others: Vec<Scene>,
}

impl Session {
    /// A session of a document; `step` is `None` at the end.
    pub(crate) fn new(settings: Settings, document: &Document, step: Option<usize>) -> Self {
        let mut scene = document.scene.clone();
        if let Some(lab) = &mut scene.lab {
            lab.step = step;
        }
        let alone = |input: &LabInput| Scene { lab: Some(Lab::new(input.clone())), ..Scene::empty([8, 8]) };
        let others = document.others().iter().map(alone).collect();
        Self { settings, path: None, preset: None, modified: false, scene, others }
    }

    /// The session as text.
    pub(crate) fn to_bytes(&self) -> Vec<u8> {
        // A struct of numbers, texts and lists has no way to fail.
        serde_json::to_vec(self).unwrap_or_default()
    }

    /// The session of a text; `None` if it is none.
    pub(crate) fn from_bytes(bytes: &[u8]) -> Option<Self> {
        serde_json::from_slice(bytes).ok()
    }

    /// The document, with its models, and the step.
    pub(crate) fn document(&self, load: files::Load<'_>) -> Result<(Document, Option<usize>), Message> {
        let folder = files::split(self.path.as_deref().unwrap_or_default())[0];
        let scene = files::resolve(&self.scene, folder, load)?;
        let step = scene.lab.as_ref().and_then(|lab| lab.step);
        let others = self.others.iter().filter_map(|scene| scene.lab.as_ref()).map(|lab| lab.input.clone());
        Ok((Document::with_others(scene, others.collect()), step))
    }
}

/// How things are looked at.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Settings {
    theme: String,
    text_size: f32,
    /// 0 is the coarsest.
    level: usize,
    speed: f32,
    snap: usize,
    outlines: bool,
    overlay: String,
    /// Names of the labs that were open, oldest first.
    recent: Vec<String>,
    aids: Aids,
}

impl Default for Settings {
    fn default() -> Self {
        Self::of(&ViewState::default(), 1.0)
    }
}

impl Settings {
    /// The settings in a view.
    pub(crate) fn of(view: &ViewState, text_size: f32) -> Self {
        Self {
            theme: view.theme.name().to_owned(),
            text_size,
            level: Level::ALL.iter().position(|level| *level == view.level).unwrap_or(0),
            speed: view.speed,
            snap: Snap::ALL.iter().position(|snap| *snap == view.snap).unwrap_or(0),
            outlines: view.outlines,
            overlay: view.overlay.name().to_owned(),
            recent: view.recent.names().iter().map(|name| (*name).to_owned()).collect(),
            aids: view.aids,
        }
    }

    /// Puts the settings into a view; what is unknown leaves what is there.
    pub(crate) fn apply(&self, view: &mut ViewState) {
        view.theme = ThemeName::from_name(&self.theme).unwrap_or(view.theme);
        view.level = Level::ALL.get(self.level).copied().unwrap_or(view.level);
        view.snap = Snap::ALL.get(self.snap).copied().unwrap_or(view.snap);
        if (0.1..=100.0).contains(&self.speed) {
            view.speed = self.speed;
        }
        view.outlines = self.outlines;
        view.overlay = Overlay::from_name(&self.overlay).unwrap_or(view.overlay);
        view.aids = self.aids;
        view.recent = Recent::of(self.recent.iter().map(String::as_str));
    }

    /// How much bigger than normal everything is.
    pub(crate) fn text_size(&self) -> f32 {
        if (0.5..=4.0).contains(&self.text_size) { self.text_size } else { 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rasterscope_core::{labs::FillTriangle, raster::Algorithm};

    #[test]
    fn what_is_no_session_is_none() {
        for bytes in [&b""[..], b"{", b"{\"settings\":{}}", b"\xFF\x00"] {
            assert_eq!(Session::from_bytes(bytes), None);
        }
    }

    #[test]
    fn a_session_reads_back_with_its_step_and_the_other_labs() {
        let mut document = Document::new(Scene::empty([8, 8]));
        let input =
            LabInput::from(FillTriangle::of(Algorithm::Scanline, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]));
        document.open_lab("scanline", || input.clone());
        document.open_lab("pipeline", || LabInput::PIPELINE);
        let session = Session::new(Settings::default(), &document, Some(7));
        let read = Session::from_bytes(&session.to_bytes()).expect("it is one");
        assert_eq!(read, session);
        assert_eq!(read.document(&mut |_| None), Ok((document, Some(7))));
    }

    #[test]
    fn settings_out_of_range_leave_the_default() {
        let mut view = ViewState::default();
        let odd = Settings {
            level: 99,
            snap: 99,
            speed: -1.0,
            text_size: 1e9,
            theme: "pink".into(),
            outlines: true,
            overlay: "no such overlay".into(),
            recent: vec!["no such lab".into()],
            aids: Aids::default(),
        };
        odd.apply(&mut view);
        assert_eq!((view, odd.text_size()), (ViewState::default(), 1.0));
    }
}
