//! What lies on the image, and what the last edit was made on.

use super::Overview;
use rasterscope_core::{
    explain::Mark,
    pipeline::{Layer, Outputs, Overlay, Pipeline, PixelCounts, Skips},
    scene::Scene,
};
use rasterscope_figure::{overlay, theme::ThemeName};
use std::{rc::Rc, sync::Arc};

/// The scene before the last edit.
#[derive(Debug, Default)]
pub(super) struct Edits {
    before: Option<(Scene, Skips)>,
    /// Whether the edit goes on: a drag is one edit.
    going_on: bool,
    /// Whether the next scene is another document, and no edit of this one.
    anew: bool,
}

/// What lies on an image, computed.
#[derive(Debug)]
pub(crate) struct Laid {
    layer: Layer,
    counts: Option<PixelCounts>,
}

/// What lies on which image.
#[derive(Debug)]
pub(super) struct Of {
    pub(super) overlay: Overlay,
    /// Differs whenever it was computed anew.
    pub(super) number: u64,
    /// The revision of the image.
    rev: u64,
    laid: Laid,
}

impl Laid {
    /// Computes what an overlay lays on the image of a scene.
    pub(crate) fn new(
        overlay: Overlay,
        scene: &Scene,
        outputs: &Outputs,
        before: Option<&(Scene, Skips)>,
    ) -> Self {
        let counts = overlay.counts().then(|| PixelCounts::of(scene, outputs));
        Self { layer: Layer::of(overlay, scene, outputs, counts.as_ref(), before), counts }
    }
}

impl Of {
    /// The marks of the image with what lies on it.
    pub(super) fn marks(&self, scene: &Scene, image: &Arc<Vec<u8>>, theme: ThemeName) -> Rc<[Mark]> {
        let size = scene.size.map(|side| side as usize);
        overlay::marks(&self.laid.layer, size, image, theme.theme()).into()
    }

    /// The counts of each pixel, if they are known and of that image.
    pub(super) fn counts_of(&self, rev: u64) -> Option<&PixelCounts> {
        self.laid.counts.as_ref().filter(|_| self.rev == rev)
    }
}

impl Overview {
    /// The scene is about to change by an edit, which may go on.
    pub(crate) fn edited(&mut self, going_on: bool) {
        if std::mem::take(&mut self.edits.anew) {
            self.edits.before = None;
        } else if !self.edits.going_on {
            self.edits.before = self.seen.clone();
        }
        self.edits.going_on = going_on;
    }

    /// Whether the last edit goes on.
    pub(crate) fn edit_goes_on(&self) -> bool {
        self.edits.going_on
    }

    /// The next change of the scene is another edit.
    pub(crate) fn edit_is_over(&mut self) {
        self.edits.going_on = false;
    }

    /// The next change of the scene is no edit: another document was opened.
    pub(crate) fn forget_edits(&mut self) {
        self.edits.anew = true;
    }

    /// The scene before the last edit, with its skips.
    pub(crate) fn before(&self) -> Option<&(Scene, Skips)> {
        self.edits.before.as_ref()
    }

    /// Whether an overlay lies on the image as it is.
    pub(crate) fn has_laid(&self, overlay: Overlay) -> bool {
        self.laid.as_ref().is_some_and(|laid| laid.overlay == overlay && laid.rev == self.rev)
    }

    /// Lays an overlay on the image of a scene.
    pub(crate) fn lay(&mut self, scene: &Scene, overlay: Overlay) {
        let Some(outputs) = self.pipeline.as_ref().map(Pipeline::outputs) else { return };
        let laid = Laid::new(overlay, scene, outputs, self.before());
        self.take_laid(overlay, laid);
    }

    /// Takes what was computed for the image as it is.
    pub(crate) fn take_laid(&mut self, overlay: Overlay, laid: Laid) {
        let number = self.laid.as_ref().map_or(1, |laid| laid.number + 1);
        self.laid = Some(Of { overlay, number, rev: self.rev, laid });
    }
}
