//! What the labs that clip a line share: all but the algorithm.

use super::{Handle, Kind, Lab, Outcome};
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

/// Handles of the window: which of xmin, ymin, xmax, ymax each moves.
const WINDOW: [(&str, Kind, Option<usize>, Option<usize>); 8] = [
    ("xmin ymin", Kind::Corner, Some(0), Some(1)),
    ("xmax ymin", Kind::Corner, Some(2), Some(1)),
    ("xmax ymax", Kind::Corner, Some(2), Some(3)),
    ("xmin ymax", Kind::Corner, Some(0), Some(3)),
    ("xmin", Kind::SideX, Some(0), None),
    ("xmax", Kind::SideX, Some(2), None),
    ("ymin", Kind::SideY, None, Some(1)),
    ("ymax", Kind::SideY, None, Some(3)),
];

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
        window_fields(ui, face, window);
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let LabInput::ClipLine(input) = document.input() else { return Vec::new() };
        let labs::ClipLine { window, segment: [x1, y1, x2, y2], .. } = input;
        let end = |name: &str, at| Handle { name: name.to_owned(), at, kind: Kind::Point };
        let ends = [end("P1", [*x1, *y1]), end("P2", [*x2, *y2])];
        // The ends last: where a handle of the window lies on an end, the end is on top.
        window_handles(window).chain(ends).collect()
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        Some(kept(markers, "ui-unit-line"))
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        let LabInput::ClipLine(labs::ClipLine { window, segment, .. }) = document.input_mut() else { return };
        if let Err(end) = drag_window(window, handle, to) {
            segment[2 * end..2 * end + 2].copy_from_slice(&to);
        }
    }
}

/// The corners and sides of a window.
pub(super) fn window_handles(window: &[f32; 4]) -> impl Iterator<Item = Handle> {
    let middle = |low: usize| window[low] / 2.0 + window[low + 2] / 2.0;
    WINDOW.into_iter().map(move |(name, kind, x, y)| {
        let at = [x.map_or(middle(0), |x| window[x]), y.map_or(middle(1), |y| window[y])];
        Handle { name: name.to_owned(), at, kind }
    })
}

/// Moves a side or a corner; `Err` is how far the handle lies behind those of the window.
pub(super) fn drag_window(window: &mut [f32; 4], handle: usize, [x, y]: [f32; 2]) -> Result<(), usize> {
    let Some((_, _, to_x, to_y)) = WINDOW.get(handle) else { return Err(handle - WINDOW.len()) };
    let before = *window;
    for (side, to) in [(to_x, x), (to_y, y)] {
        if let Some(side) = side {
            window[*side] = to;
        }
    }
    keep_order(window, before);
    Ok(())
}

/// The window as numbers.
pub(super) fn window_fields(ui: &mut Ui, face: &Face<'_>, window: &mut [f32; 4]) {
    let before = *window;
    let [xmin, ymin, xmax, ymax] = window;
    choices::fields(ui, face, "min", [xmin, ymin]);
    choices::fields(ui, face, "max", [xmax, ymax]);
    keep_order(window, before);
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

/// A side that was moved stops at the opposite one.
fn keep_order(window: &mut [f32; 4], before: [f32; 4]) {
    for axis in 0..2 {
        let (low, high) = (axis, axis + 2);
        if window[low] > window[high] {
            if window[low] == before[low] {
                window[high] = window[low];
            } else {
                window[low] = window[high];
            }
        }
    }
}
