//! The corners of polygons: their numbers, their handles, one more and one less.

use super::{Handle, Kind};
use crate::{face::Face, shell::choices, theme::Text};
use egui::Ui;

/// More corners than this have no handles and no numbers.
const MOST_CORNERS: usize = 64;

/// Every corner that can be edited with its name, as in the drawing.
fn named<'a>(
    contours: impl Iterator<Item = &'a mut Vec<[f32; 2]>>,
) -> impl Iterator<Item = (String, &'a mut [f32; 2])> {
    let named = contours.enumerate().flat_map(|(contour, corners)| {
        let primes = "′".repeat(contour.min(3));
        corners.iter_mut().enumerate().map(move |(i, corner)| (format!("V{i}{primes}"), corner))
    });
    named.take(MOST_CORNERS)
}

/// Their numbers.
pub(super) fn fields<'a>(
    ui: &mut Ui,
    face: &Face<'_>,
    contours: impl Iterator<Item = &'a mut Vec<[f32; 2]>>,
) {
    for (name, [x, y]) in named(contours) {
        choices::fields(ui, face, &name, [x, y]);
    }
}

/// Adds a corner to a polygon, or takes one away.
pub(super) fn buttons(ui: &mut Ui, face: &Face<'_>, polygon: &mut Vec<[f32; 2]>) {
    ui.horizontal(|ui| {
        let add = ui.button(face.rich(face.say("ui-add-corner"), Text::Label));
        if add.on_hover_text(face.say("ui-add-corner-where")).clicked() {
            add_corner(polygon);
        }
        let remove = egui::Button::new(face.rich(face.say("ui-remove-corner"), Text::Label));
        let remove = ui.add_enabled(polygon.len() > 3, remove);
        if remove.on_hover_text(face.say("ui-remove-corner-where")).clicked() {
            polygon.pop();
        }
    });
}

/// What can be dragged.
pub(super) fn handles(contours: impl Iterator<Item = Vec<[f32; 2]>>) -> Vec<Handle> {
    let mut contours: Vec<_> = contours.collect();
    let handle = |(name, at): (String, &mut [f32; 2])| Handle { name, at: *at, kind: Kind::Point };
    named(contours.iter_mut()).map(handle).collect()
}

/// Moves a corner.
pub(super) fn drag<'a>(contours: impl Iterator<Item = &'a mut Vec<[f32; 2]>>, handle: usize, to: [f32; 2]) {
    if let Some((_, corner)) = named(contours).nth(handle) {
        *corner = to;
    }
}

/// Puts a corner into the middle of the longest edge.
fn add_corner(polygon: &mut Vec<[f32; 2]>) {
    let edge = |i: usize| [polygon[i], polygon[(i + 1) % polygon.len()]];
    let length = |i: &usize| {
        let [[ax, ay], [bx, by]] = edge(*i).map(|p| p.map(f64::from));
        (bx - ax) * (bx - ax) + (by - ay) * (by - ay)
    };
    let longest = (0..polygon.len()).max_by(|i, j| length(i).total_cmp(&length(j)));
    if let Some(longest) = longest {
        let [a, b] = edge(longest);
        polygon.insert(longest + 1, [0, 1].map(|axis| a[axis] / 2.0 + b[axis] / 2.0));
    }
}
