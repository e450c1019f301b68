//! The window of the labs that clip against one: its handles and its numbers.

use super::{Handle, Kind};
use crate::{face::Face, shell::choices};
use egui::Ui;

/// The handles: which of xmin, ymin, xmax, ymax each moves.
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

/// What can be dragged.
pub(super) fn handles(window: &[f32; 4]) -> [Handle; WINDOW.len()] {
    let middle = |low: usize| window[low] / 2.0 + window[low + 2] / 2.0;
    WINDOW.map(|(name, kind, x, y)| {
        let at = [x.map_or(middle(0), |x| window[x]), y.map_or(middle(1), |y| window[y])];
        Handle { name: name.to_owned(), at, kind }
    })
}

/// Moves a handle of the window; of the handles behind these, returns which one it is.
pub(super) fn drag(window: &mut [f32; 4], handle: usize, [x, y]: [f32; 2]) -> Option<usize> {
    let Some((_, _, to_x, to_y)) = WINDOW.get(handle) else { return Some(handle - WINDOW.len()) };
    let before = *window;
    for (side, to) in [(to_x, x), (to_y, y)] {
        if let Some(side) = side {
            window[*side] = to;
        }
    }
    keep_order(window, before);
    None
}

/// Its numbers.
pub(super) fn fields(ui: &mut Ui, face: &Face<'_>, window: &mut [f32; 4]) {
    let before = *window;
    let [xmin, ymin, xmax, ymax] = window;
    choices::fields(ui, face, "min", [xmin, ymin]);
    choices::fields(ui, face, "max", [xmax, ymax]);
    keep_order(window, before);
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
