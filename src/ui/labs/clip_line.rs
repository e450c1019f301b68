//! What the labs that clip a line share: all but the algorithm.

use super::{Handle, Kind, Lab, Outcome, window};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    clip::line::{Algorithm, Mistake, Mistakes},
    explain::{Marker, Role},
    labs::{self, LabInput},
    math::Arithmetic,
};

/// The lab of one algorithm: the ends of a line and the window are dragged.
#[derive(Debug)]
pub(crate) struct ClipLine(pub(crate) Algorithm);

impl Lab for ClipLine {
    fn name(&self) -> &'static str {
        self.0.name()
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        let LabInput::ClipLine(input) = document.input_mut() else { return };
        let labs::ClipLine { algorithm, window, segment, arithmetic, mistakes } = input;
        conventions(ui, face, arithmetic, view);
        if *algorithm == Algorithm::CohenSutherland {
            choose_mistakes(ui, face, mistakes);
        }
        heading(ui, face, &face.say("ui-ends-and-window"));
        let [x1, y1, x2, y2] = segment;
        choices::fields(ui, face, "P1", [x1, y1]);
        choices::fields(ui, face, "P2", [x2, y2]);
        window::fields(ui, face, window);
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let LabInput::ClipLine(input) = document.input() else { return Vec::new() };
        let labs::ClipLine { window, segment: [x1, y1, x2, y2], .. } = input;
        let end = |name: &str, at| Handle { name: name.to_owned(), at, kind: Kind::Point };
        let ends = [end("P1", [*x1, *y1]), end("P2", [*x2, *y2])];
        // The ends last: where a handle of the window lies on an end, the end is on top.
        window::handles(window).into_iter().chain(ends).collect()
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        Some(kept(markers, "ui-unit-line"))
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        let LabInput::ClipLine(labs::ClipLine { window, segment, .. }) = document.input_mut() else { return };
        if let Some(end) = window::drag(window, handle, to) {
            segment[2 * end..2 * end + 2].copy_from_slice(&to);
        }
    }
}

/// What a line is clipped in, and where dragged points snap to.
pub(super) fn conventions(ui: &mut Ui, face: &Face<'_>, arithmetic: &mut Arithmetic, view: &mut ViewState) {
    heading(ui, face, &face.say("ui-conventions"));
    let all = [Arithmetic::Exact, Arithmetic::F64, Arithmetic::F32].map(|each| (each, face.say(each.word())));
    choices::choose(ui, face, "ui-arithmetic", arithmetic, &all);
    choices::snapping(ui, face, view);
}

/// One thing came in, and went out if the run ended by accepting it.
pub(super) fn kept(markers: &[(usize, Marker)], unit: &'static str) -> Outcome {
    let decided = markers.iter().rev().find(|(_, marker)| marker.role != Role::Neutral);
    let kept = decided.is_some_and(|(_, marker)| marker.role == Role::Accepted);
    Outcome { came: Some(1), went: usize::from(kept), unit: None, given: (1, unit) }
}

fn choose_mistakes(ui: &mut Ui, face: &Face<'_>, mistakes: &mut Mistakes) {
    heading(ui, face, &face.say("ui-mistakes"));
    for mistake in Mistake::ALL {
        let words = match mistake {
            Mistake::OrForAnd => ["mistake-or-for-and", "mistake-or-for-and-effect"],
            Mistake::OtherOrder => ["mistake-other-order", "mistake-other-order-effect"],
        };
        let mut made = mistakes.has(mistake);
        choices::mistake(ui, face, words, &mut made);
        *mistakes = if made { mistakes.with(mistake) } else { mistakes.without(mistake) };
    }
}
