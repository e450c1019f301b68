//! The whole scene: its pipeline, and what the overview draws of it.
//!
//! Everything here is derived from the document and kept until the document changes.

mod chips;
mod history;
mod image;
mod space;
mod thumbnails;

pub(crate) use history::{Entry, History};

use crate::{
    document::{Scenery, ViewState},
    shell::{canvas::Maker, ribbon::Chip},
};
use rasterscope_core::{
    explain::{Mark, View},
    pipeline::{Outputs, Pipeline, Skips, pixel_history},
    raster::Algorithm,
    scene::Scene,
};
use rasterscope_figure::{orbit::Orbit, tables::TextTable, theme::ThemeName, words::Words};
use std::{rc::Rc, sync::Arc};

/// The pipeline of the document, and what is drawn of it.
#[derive(Debug)]
pub(crate) struct Overview {
    pipeline: Pipeline,
    /// Moves when the scene or the skips do.
    rev: u64,
    seen: Option<(Scene, Skips)>,
    /// The image and the run that drew it.
    image: Option<(usize, Arc<Vec<u8>>)>,
    space: space::Space,
    drawing: Option<(DrawingKey, Rc<Picture>)>,
    chips: Option<((u64, ThemeName), Rc<[Chip]>)>,
    history: Option<((u64, [u32; 2]), Rc<History>)>,
    table: Option<(u64, Rc<TextTable>)>,
}

/// What the overview's drawing depends on.
#[derive(Clone, Debug, PartialEq)]
struct DrawingKey {
    rev: u64,
    scenery: Scenery,
    orbit: Option<Orbit>,
    outlines: bool,
    pixel: Option<[u32; 2]>,
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
            pipeline: Pipeline::new(Algorithm::Scanline),
            rev: 0,
            seen: None,
            image: None,
            space: space::Space::default(),
            drawing: None,
            chips: None,
            history: None,
            table: None,
        }
    }
}

impl Overview {
    /// Brings the pipeline up to date.
    pub(crate) fn update(&mut self, scene: &Scene, skips: Skips) {
        if self.seen.as_ref().is_some_and(|(old, with)| old == scene && *with == skips) {
            return;
        }
        self.rev += 1;
        self.pipeline.update(scene, &skips);
        let runs = self.pipeline.image_runs();
        let memo = self.image.as_ref().is_some_and(|(run, _)| *run == runs) && skips == Skips::ALL;
        if !memo {
            self.image = Some((runs, Arc::new(self.pipeline.outputs().frame.color.clone())));
        }
        self.seen = Some((scene.clone(), skips));
    }

    /// What the stages made of the scene.
    pub(crate) fn outputs(&self) -> &Outputs {
        self.pipeline.outputs()
    }

    /// How often the image was drawn: tests assert on it.
    #[cfg(test)]
    pub(crate) fn image_runs(&self) -> usize {
        self.pipeline.image_runs()
    }

    /// The drawing of the overview.
    pub(crate) fn picture(&mut self, view: &mut ViewState) -> Option<Rc<Picture>> {
        let (scene, _) = self.seen.as_ref()?;
        let orbit = (view.scenery == Scenery::Space)
            .then(|| *view.orbit.get_or_insert_with(|| space::first_orbit(self.pipeline.outputs(), scene)));
        let key = DrawingKey {
            rev: self.rev,
            scenery: view.scenery,
            orbit,
            outlines: view.outlines,
            pixel: view.pixel,
        };
        if let Some((_, picture)) = self.drawing.as_ref().filter(|(old, _)| *old == key) {
            return Some(Rc::clone(picture));
        }
        let rev = self.drawing.as_ref().map_or(0, |(_, picture)| picture.rev) + 1;
        let outputs = self.pipeline.outputs();
        let (maker, (marks, view)) = match (orbit, &self.image) {
            (Some(orbit), _) => (Maker::Space, self.space.drawing(outputs, scene, &orbit)),
            (None, Some((_, rgba))) => (Maker::Image, image::drawing(outputs, scene, rgba, view)),
            (None, None) => return None,
        };
        let picture = Rc::new(Picture { marks, view, maker, rev });
        self.drawing = Some((key, Rc::clone(&picture)));
        Some(picture)
    }

    /// The chips of the ribbon.
    pub(crate) fn chips(&mut self, theme: ThemeName, words: &Words) -> Rc<[Chip]> {
        let key = (self.rev, theme);
        if let Some((_, chips)) = self.chips.as_ref().filter(|(old, _)| *old == key) {
            return Rc::clone(chips);
        }
        let chips: Rc<[Chip]> = chips::chips(self.pipeline.outputs(), theme, words).into();
        self.chips = Some((key, Rc::clone(&chips)));
        chips
    }

    /// What came into every stage, what went out, what was dropped.
    pub(crate) fn table(&mut self, words: &Words) -> Rc<TextTable> {
        if let Some((_, table)) = self.table.as_ref().filter(|(rev, _)| *rev == self.rev) {
            return Rc::clone(table);
        }
        let table = Rc::new(chips::table(&self.pipeline.outputs().frame.stats, words));
        self.table = Some((self.rev, Rc::clone(&table)));
        table
    }

    /// The history of a pixel, in words.
    pub(crate) fn history(&mut self, pixel: [u32; 2], words: &Words) -> Option<Rc<History>> {
        let (scene, _) = self.seen.as_ref()?;
        if pixel[0] >= scene.size[0] || pixel[1] >= scene.size[1] {
            return None;
        }
        let key = (self.rev, pixel);
        if let Some((_, history)) = self.history.as_ref().filter(|(old, _)| *old == key) {
            return Some(Rc::clone(history));
        }
        let of = pixel_history(scene, self.pipeline.outputs(), pixel);
        let history = Rc::new(History::new(&of, scene, words));
        self.history = Some((key, Rc::clone(&history)));
        Some(history)
    }
}
