//! The whole scene: its pipeline, and what the overview draws of it.
//!
//! Everything here is derived from the document and kept until the document changes.

mod chips;
mod history;
mod image;
mod laid;
mod space;
mod thumbnails;

pub(crate) use history::{Entry, History, Hover};
pub(crate) use laid::Laid;

use crate::{
    document::{Scenery, ViewState},
    shell::{canvas::Maker, ribbon::Chip},
};
use rasterscope_core::{
    explain::{Mark, View},
    memo::Memo,
    pipeline::{Pipeline, Skips, Stats, pixel_history},
    scene::Scene,
};
use rasterscope_figure::{orbit::Orbit, tables::TextTable, theme::ThemeName, words::Words};
use std::{rc::Rc, sync::Arc};

/// The pipeline of the document, and what is drawn of it.
#[derive(Debug)]
pub(crate) struct Overview {
    /// `None` while it is lent.
    pipeline: Option<Pipeline>,
    /// Moves when the scene or the skips do.
    rev: u64,
    seen: Option<(Scene, Skips)>,
    edits: laid::Edits,
    laid: Option<laid::Of>,
    /// What lies on the image, as marks.
    layered: Memo<(u64, u64, ThemeName), Rc<[Mark]>>,
    image: Arc<Vec<u8>>,
    space: space::Space,
    picture: Memo<PictureKey, Rc<Picture>>,
    chips: Memo<(u64, ThemeName), Rc<[Chip]>>,
    table: Memo<u64, Rc<TextTable>>,
    history: Memo<(u64, [u32; 2]), Rc<History>>,
    hover: Memo<(u64, u64, [u32; 2]), Rc<Hover>>,
}

/// What the overview's drawing depends on.
#[derive(Clone, Debug, PartialEq)]
struct PictureKey {
    rev: u64,
    orbit: Option<Orbit>,
    outlines: bool,
    pixel: Option<[u32; 2]>,
    /// What lies on the image, in which colours.
    laid: Option<(u64, ThemeName)>,
}

/// A drawing of the overview.
#[derive(Debug)]
pub(crate) struct Picture {
    pub(crate) marks: Vec<Mark>,
    pub(crate) view: View,
    pub(crate) maker: Maker,
    /// Differs from picture to picture.
    pub(crate) rev: u64,
}

impl Default for Overview {
    fn default() -> Self {
        Self {
            pipeline: Some(Self::pipeline()),
            rev: 0,
            seen: None,
            edits: laid::Edits::default(),
            laid: None,
            layered: Memo::default(),
            image: Arc::default(),
            space: space::Space::default(),
            picture: Memo::default(),
            chips: Memo::default(),
            table: Memo::default(),
            history: Memo::default(),
            hover: Memo::default(),
        }
    }
}

impl Overview {
    /// A pipeline that has seen nothing.
    pub(crate) fn pipeline() -> Pipeline {
        Pipeline::default()
    }

    /// Whether everything is up to date with a scene; which lab is open makes no difference.
    pub(crate) fn is_of(&self, scene: &Scene, skips: Skips) -> bool {
        self.seen.as_ref().is_some_and(|(old, with)| old.same_picture(scene) && *with == skips)
    }

    /// Brings the pipeline up to date.
    pub(crate) fn update(&mut self, scene: &Scene, skips: Skips) {
        let mut pipeline = self.lend().unwrap_or_else(Self::pipeline);
        pipeline.update(scene, &skips);
        self.give_back(pipeline, scene, skips);
    }

    /// Lends the pipeline to whoever brings it up to date; `None` if it is lent already. What is shown
    /// meanwhile stays as it is.
    pub(crate) fn lend(&mut self) -> Option<Pipeline> {
        self.pipeline.take()
    }

    /// Takes the pipeline back, up to date with a scene.
    pub(crate) fn give_back(&mut self, pipeline: Pipeline, scene: &Scene, skips: Skips) {
        if !self.is_of(scene, skips) {
            self.rev += 1;
        }
        let color = &pipeline.outputs().frame.color;
        // An equal image keeps its texture.
        if *self.image != *color {
            self.image = Arc::new(color.clone());
        }
        self.pipeline = Some(pipeline);
        self.seen = Some((scene.clone(), skips));
    }

    /// Forgets which scene was drawn: its pipeline is lost.
    pub(crate) fn forget(&mut self) {
        self.seen = None;
    }

    /// What the stages made of the scene.
    #[cfg(test)]
    pub(crate) fn outputs(&self) -> &rasterscope_core::pipeline::Outputs {
        self.pipeline.as_ref().expect("it is not lent").outputs()
    }

    /// How often the image was drawn: tests assert on it.
    #[cfg(test)]
    pub(crate) fn image_runs(&self) -> usize {
        self.pipeline.as_ref().expect("it is not lent").image_runs()
    }

    /// The drawing of the overview.
    pub(crate) fn picture(&mut self, view: &mut ViewState) -> Option<Rc<Picture>> {
        let Some(outputs) = self.pipeline.as_ref().map(Pipeline::outputs) else {
            return self.picture.last().cloned();
        };
        let (scene, _) = self.seen.as_ref()?;
        let orbit = (view.scenery == Scenery::Space)
            .then(|| *view.orbit.get_or_insert_with(|| space::first_orbit(outputs, scene)));
        let laid = self.laid.as_ref().filter(|laid| orbit.is_none() && laid.overlay == view.overlay);
        let key = PictureKey {
            rev: self.rev,
            orbit,
            outlines: view.outlines,
            pixel: view.pixel,
            laid: laid.map(|laid| (laid.number, view.theme)),
        };
        let rev = self.picture.runs() as u64;
        let picture = self.picture.get(key, |_| {
            let (maker, (marks, view)) = match orbit {
                Some(orbit) => (Maker::Space, self.space.drawing(outputs, scene, &orbit)),
                None => (Maker::Image, {
                    let image = &self.image;
                    let ground = laid.map(|laid| {
                        let key = (self.rev, laid.number, view.theme);
                        Rc::clone(self.layered.get(key, |_| laid.marks(scene, image, view.theme)))
                    });
                    image::drawing(outputs, scene, (image, ground.as_deref()), view)
                }),
            };
            Rc::new(Picture { marks, view, maker, rev })
        });
        Some(Rc::clone(picture))
    }

    /// The chips of the ribbon.
    pub(crate) fn chips(&mut self, theme: ThemeName, words: &Words) -> Rc<[Chip]> {
        let Some(outputs) = self.pipeline.as_ref().map(Pipeline::outputs) else {
            return self.chips.last().cloned().unwrap_or_default();
        };
        let chips = self.chips.get((self.rev, theme), |_| chips::chips(outputs, theme, words).into());
        Rc::clone(chips)
    }

    /// What the stages counted, and of which scene; `None` while the pipeline is lent.
    pub(crate) fn counted(&self) -> Option<(&Stats, &Scene)> {
        let (scene, _) = self.seen.as_ref()?;
        Some((&self.pipeline.as_ref()?.outputs().frame.stats, scene))
    }

    /// What came into every stage, what went out, what was dropped.
    pub(crate) fn table(&mut self, words: &Words) -> Rc<TextTable> {
        let stats = self.pipeline.as_ref().map(|pipeline| &pipeline.outputs().frame.stats);
        match (stats, self.table.last()) {
            (None, Some(last)) => Rc::clone(last),
            (None, None) => Rc::new(chips::table(&Stats::default(), words)),
            (Some(stats), _) => Rc::clone(self.table.get(self.rev, |_| Rc::new(chips::table(stats, words)))),
        }
    }

    /// The history of a pixel, in words.
    pub(crate) fn history(&mut self, pixel: [u32; 2], words: &Words) -> Option<Rc<History>> {
        let (scene, _) = self.seen.as_ref()?;
        if pixel[0] >= scene.size[0] || pixel[1] >= scene.size[1] {
            return None;
        }
        let outputs = self.pipeline.as_ref()?.outputs();
        let history = self.history.get((self.rev, pixel), |_| {
            Rc::new(History::new(&pixel_history(scene, outputs, pixel), scene, outputs, words))
        });
        Some(Rc::clone(history))
    }

    /// What a pixel holds and who drew it, in one line.
    pub(crate) fn hover(&mut self, pixel: [u32; 2], words: &Words) -> Option<Rc<Hover>> {
        let (scene, _) = self.seen.as_ref()?;
        if pixel[0] >= scene.size[0] || pixel[1] >= scene.size[1] {
            return None;
        }
        let outputs = self.pipeline.as_ref()?.outputs();
        let laid = self.laid.as_ref();
        let key = (self.rev, laid.map_or(0, |laid| laid.number), pixel);
        let hover = self.hover.get(key, |_| {
            let counts = laid.and_then(|laid| laid.counts_of(self.rev));
            Rc::new(Hover::new((scene, outputs), counts, pixel, words))
        });
        Some(Rc::clone(hover))
    }
}
