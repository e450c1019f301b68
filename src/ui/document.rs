//! The document: what undo restores and a scene file holds; and the view, which is neither.

use crate::{aids::Aids, recent::Recent};
use rasterscope_core::{
    compare::{Fact, Setting, Side},
    explain::Level,
    labs,
    labs::LabInput,
    pipeline::{Overlay, Skips},
    scene::{Lab, Scene},
};
use rasterscope_figure::{orbit::Orbit, theme::ThemeName};

/// Everything the user edits. Nothing derived lives here.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Document {
    /// The scene, with the lab that is open.
    pub(crate) scene: Scene,
    /// The inputs of the labs that were open before, so that going back finds them.
    others: Vec<LabInput>,
}

impl Document {
    /// A document of a scene; a scene without a lab opens the overview.
    pub(crate) fn new(mut scene: Scene) -> Self {
        // The step belongs to the view.
        scene.lab.get_or_insert(Lab::new(LabInput::PIPELINE)).step = None;
        Self { scene, others: Vec::new() }
    }

    /// A document that knows the inputs of labs that are not open.
    pub(crate) fn with_others(scene: Scene, others: Vec<LabInput>) -> Self {
        Self { others, ..Self::new(scene) }
    }

    /// The inputs of the labs that were open before.
    pub(crate) fn others(&self) -> &[LabInput] {
        &self.others
    }

    /// The inputs of all labs that are or were open.
    fn all(&self) -> impl Iterator<Item = &LabInput> {
        std::iter::once(self.input()).chain(&self.others)
    }

    /// Whether nothing was edited between the two; which lab is open is no edit.
    pub(crate) fn same_work(&self, clean: &Self) -> bool {
        let known = |document: &Self, name: &str| document.all().find(|input| input.name() == name).cloned();
        let same = |input: &LabInput| {
            let name = input.name();
            let from_another = |other: &LabInput| other.carried(name).as_ref() == Some(input);
            known(clean, name).or_else(|| labs::default_input(name)).as_ref() == Some(input)
                || clean.all().any(from_another)
        };
        if !self.all().all(same) {
            return false;
        }
        self.scene.same_picture(&clean.scene)
    }

    /// The inputs of the open lab.
    pub(crate) fn input(&self) -> &LabInput {
        self.scene.lab.as_ref().map_or(&LabInput::PIPELINE, |lab| &lab.input)
    }

    /// The inputs of the open lab, to edit.
    pub(crate) fn input_mut(&mut self) -> &mut LabInput {
        &mut self.scene.lab.get_or_insert(Lab::new(LabInput::PIPELINE)).input
    }

    /// Shows two sides that differ in a setting, or one side only.
    pub(crate) fn compare(&mut self, setting: Option<Setting>) {
        self.scene.lab.get_or_insert(Lab::new(LabInput::PIPELINE)).compare = setting;
    }

    /// Chooses what a side has of the setting in which they differ.
    pub(crate) fn choose(&mut self, side: Side, setting: Setting) {
        let other = match side {
            Side::A => {
                let other = self.scene.compared();
                setting.apply(&mut self.scene);
                other
            }
            Side::B => Some(setting),
        };
        self.compare(other);
    }

    /// Opens another lab: with the same inputs if it can have them, so that algorithms are seen on
    /// one line, else with those it had, or with `first` at its first time.
    pub(crate) fn open_lab(&mut self, name: &'static str, first: impl FnOnce() -> LabInput) {
        if self.input().name() == name {
            return;
        }
        self.keep_input();
        let known = self.others.iter().rev().find_map(|other| other.carried(name));
        self.scene.lab = Some(Lab::new(known.unwrap_or_else(first)));
    }

    /// Opens a lab with these inputs.
    pub(crate) fn show_lab(&mut self, input: LabInput) {
        self.keep_input();
        self.scene.lab = Some(Lab::new(input));
    }

    /// Keeps the inputs of the lab that is open, for when it is opened again.
    fn keep_input(&mut self) {
        let old = self.input().clone();
        self.others.retain(|other| other.name() != old.name());
        self.others.push(old);
    }
}

/// Where dragged points snap to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Snap {
    /// Halves of a unit: pixel centres and corners, and round numbers.
    #[default]
    Half,
    /// Centres of pixels.
    Centre,
    /// Anywhere.
    Off,
}

impl Snap {
    /// All, the default first.
    pub(crate) const ALL: [Self; 3] = [Self::Half, Self::Centre, Self::Off];

    /// The nearest coordinate that may be chosen.
    pub(crate) fn snap(self, x: f32) -> f32 {
        // Adding zero turns a negative zero into zero.
        let snapped = match self {
            Self::Half => (x * 2.0).round() / 2.0,
            Self::Centre => x.floor() + 0.5,
            // Shown numbers have at most four decimals; a drag gives no more.
            Self::Off => (x * 4096.0).round() / 4096.0,
        };
        snapped + 0.0
    }

    /// How far an arrow key moves a point.
    pub(crate) fn step(self) -> f32 {
        match self {
            Self::Half => 0.5,
            Self::Centre => 1.0,
            Self::Off => 0.125,
        }
    }
}

/// The tabs of the inspector.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Tab {
    /// What just happened.
    #[default]
    Step,
    /// The pseudocode.
    Listing,
    /// Every value.
    Values,
    /// The chosen pixel.
    Pixel,
    /// How the two sides differ.
    Difference,
}

/// What the overview's canvas shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Scenery {
    /// The image, with outlines.
    #[default]
    Image,
    /// The scene and its frustum from outside.
    Space,
    /// What each skip leaves out.
    Skips,
}

/// How the document is looked at: saved, but not undone.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ViewState {
    /// The colours.
    pub(crate) theme: ThemeName,
    /// How big a step is.
    pub(crate) level: Level,
    /// Steps a second while playing.
    pub(crate) speed: f32,
    /// When the next step of playing is due, in egui's seconds.
    pub(crate) due: Option<f64>,
    /// The inspector's tab.
    pub(crate) tab: Tab,
    /// The pixel whose history is shown.
    pub(crate) pixel: Option<[u32; 2]>,
    /// Whether the window is laid out for two sides.
    pub(crate) split: bool,
    /// The part of two results that is explained, as either side has it.
    pub(crate) part: Option<Fact>,
    /// The camera outside the frustum, once it was used.
    pub(crate) orbit: Option<Orbit>,
    /// The camera of a lab that draws in space, once the user has turned it.
    pub(crate) outside: Option<Orbit>,
    /// What the pipeline may leave out; it never changes the image.
    pub(crate) skips: Skips,
    /// What the overview's canvas shows.
    pub(crate) scenery: Scenery,
    /// Whether the overview draws the outlines of triangles.
    pub(crate) outlines: bool,
    /// What lies on the overview's image.
    pub(crate) overlay: Overlay,
    /// Where dragged points snap to.
    pub(crate) snap: Snap,
    /// Whether the choices lie over the canvas of a narrow window.
    pub(crate) choices: bool,
    /// Whether the keys are shown.
    pub(crate) keys: bool,
    /// The command palette, while it is open.
    pub(crate) palette: Option<Palette>,
    /// Which labs were open.
    pub(crate) recent: Recent,
    /// Hints, exact values, less motion.
    pub(crate) aids: Aids,
}

/// The command palette, while it is open.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Palette {
    /// As typed so far.
    pub(crate) typed: String,
    /// Whether it shows only what can be compared.
    pub(crate) compare: bool,
    /// Which of the commands that fit is chosen.
    pub(crate) chosen: usize,
    /// Whether it was already shown.
    pub(crate) shown: bool,
}

impl Default for ViewState {
    fn default() -> Self {
        Self {
            theme: ThemeName::Dark,
            level: Level::Detail,
            speed: 2.0,
            due: None,
            tab: Tab::Step,
            pixel: None,
            split: false,
            part: None,
            orbit: None,
            outside: None,
            skips: Skips::ALL,
            scenery: Scenery::Image,
            outlines: true,
            overlay: Overlay::None,
            snap: Snap::Half,
            choices: false,
            keys: false,
            palette: None,
            recent: Recent::default(),
            aids: Aids::default(),
        }
    }
}

impl ViewState {
    /// Whether steps are being played.
    pub(crate) fn playing(&self) -> bool {
        self.due.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rasterscope_core::labs::ClipLine;

    #[test]
    fn a_lab_finds_its_inputs_again() {
        let line = |x| {
            LabInput::ClipLine(ClipLine {
                algorithm: rasterscope_core::clip::line::Algorithm::CohenSutherland,
                window: [0.0, 0.0, 4.0, 3.0],
                segment: [x, 0.0, 1.0, 1.0],
                arithmetic: Default::default(),
                mistakes: Default::default(),
            })
        };
        let mut document = Document::new(Scene::empty([8, 8]));
        assert_eq!(document.input(), &LabInput::PIPELINE);
        document.open_lab("cohen-sutherland", || line(1.0));
        *document.input_mut() = line(2.0);
        document.open_lab("pipeline", || LabInput::PIPELINE);
        document.open_lab("cohen-sutherland", || line(3.0));
        assert_eq!(document.input(), &line(2.0));
    }

    #[test]
    fn algorithms_of_one_family_are_seen_on_one_input() {
        let mut document = Document::new(Scene::empty([8, 8]));
        let first = |name| labs::default_input(name).expect("a lab");
        document.open_lab("cohen-sutherland", || first("cohen-sutherland"));
        let LabInput::ClipLine(line) = document.input_mut() else { panic!("it clips a line") };
        line.segment = [1.0, 2.0, 3.0, 4.0];
        let edited = document.clone();
        document.open_lab("pipeline", || LabInput::PIPELINE);
        document.open_lab("liang-barsky", || first("liang-barsky"));
        assert_eq!(document.input(), &edited.input().carried("liang-barsky").expect("one family"));
        assert_eq!(document.input().carried("scanline"), None);
        assert!(document.same_work(&edited), "that is no edit");
    }

    #[test]
    fn snapping_gives_no_negative_zero() {
        for snap in Snap::ALL {
            assert!(snap.snap(-1e-6).is_sign_positive() || snap == Snap::Centre, "{snap:?}");
        }
        assert_eq!(Snap::Half.snap(2.74), 2.5);
        assert_eq!(Snap::Centre.snap(2.99), 2.5);
    }
}
