//! What the labs that clip a polygon share: all but the algorithm.

use super::{Handle, Kind, Lab, Outcome, window};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    theme::Text,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    clip::polygon::{
        Algorithm,
        sutherland_hodgman::{Mistake, SideOrder},
    },
    explain::{Marker, Role},
    labs::{self, LabInput},
};

/// More corners than this have no handles and no numbers.
const MOST_CORNERS: usize = 64;

/// The lab of one algorithm: the corners of a polygon and the window are dragged.
#[derive(Debug)]
pub(crate) struct ClipPolygon(pub(crate) Algorithm);

impl Lab for ClipPolygon {
    fn name(&self) -> &'static str {
        self.0.name()
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        let LabInput::ClipPolygon(input) = document.input_mut() else { return };
        heading(ui, face, &face.say("ui-conventions"));
        let arithmetics: Vec<_> =
            self.0.arithmetics().iter().map(|&each| (each, face.say(each.word()))).collect();
        if arithmetics.len() > 1 {
            choices::choose(ui, face, "ui-arithmetic", &mut input.arithmetic, &arithmetics);
        }
        if self.0 == Algorithm::SutherlandHodgman {
            order(ui, face, &mut input.order);
        }
        choices::snapping(ui, face, view);
        if self.0 == Algorithm::SutherlandHodgman {
            heading(ui, face, &face.say("ui-mistakes"));
            mistakes(ui, face, &mut input.mistake);
        }
        heading(ui, face, &face.say("ui-corners-and-window"));
        for (name, corner) in corners(input).into_iter().take(MOST_CORNERS) {
            let [x, y] = corner;
            choices::fields(ui, face, &name, [x, y]);
        }
        ui.horizontal(|ui| {
            let add = ui.button(face.rich(face.say("ui-add-corner"), Text::Label));
            if add.on_hover_text(face.say("ui-add-corner-where")).clicked() {
                add_corner(&mut input.polygon);
            }
            let remove = egui::Button::new(face.rich(face.say("ui-remove-corner"), Text::Label));
            let remove = ui.add_enabled(input.polygon.len() > 3, remove);
            if remove.on_hover_text(face.say("ui-remove-corner-where")).clicked() {
                input.polygon.pop();
            }
        });
        window::fields(ui, face, &mut input.window);
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let LabInput::ClipPolygon(input) = document.input() else { return Vec::new() };
        let mut input = input.clone();
        let sides = window::handles(&input.window);
        let corners = corners(&mut input).into_iter().take(MOST_CORNERS).map(|(name, at)| Handle {
            name,
            at: *at,
            kind: Kind::Point,
        });
        // The corners last: where a handle of the window lies on one, the corner is on top.
        sides.into_iter().chain(corners).collect()
    }

    fn outcome(&self, document: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let LabInput::ClipPolygon(input) = document.input() else { return None };
        let named = markers.iter().filter(|(_, marker)| marker.label.is_some());
        let empty = named.filter(|(_, marker)| marker.role == Role::Rejected).count();
        let polygons = 1 + input.contours.len();
        Some(Outcome {
            came: Some(polygons),
            went: polygons - empty.min(polygons),
            unit: None,
            given: (polygons, "ui-unit-polygon"),
        })
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        let LabInput::ClipPolygon(input) = document.input_mut() else { return };
        let dragged = window::drag(&mut input.window, handle, to);
        if let Some((_, corner)) = dragged.and_then(|index| corners(input).into_iter().nth(index)) {
            *corner = to;
        }
    }
}

/// Every corner with its name, as in the drawing.
fn corners(input: &mut labs::ClipPolygon) -> Vec<(String, &mut [f32; 2])> {
    let polygons = std::iter::once(&mut input.polygon).chain(&mut input.contours).enumerate();
    let named = polygons.flat_map(|(polygon, corners)| {
        let primes = "′".repeat(polygon.min(3));
        corners.iter_mut().enumerate().map(move |(i, corner)| (format!("V{i}{primes}"), corner))
    });
    named.collect()
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

/// In which order the sides cut.
fn order(ui: &mut Ui, face: &Face<'_>, order: &mut SideOrder) {
    let all = SideOrder::ALL.map(|each| {
        let name = match each {
            SideOrder::LeftRightBottomTop => "word-side-order-left-right-bottom-top",
            SideOrder::BottomTopLeftRight => "word-side-order-bottom-top-left-right",
            SideOrder::TopRightBottomLeft => "word-side-order-top-right-bottom-left",
            SideOrder::LeftBottomRightTop => "word-side-order-left-bottom-right-top",
        };
        (each, face.say(name))
    });
    choices::choose(ui, face, "ui-side-order", order, &all);
}

/// At most one is made at a time.
fn mistakes(ui: &mut Ui, face: &Face<'_>, made: &mut Option<Mistake>) {
    for mistake in Mistake::ALL {
        let words = match mistake {
            Mistake::TwoSides => ["mistake-two-sides", "mistake-two-sides-effect"],
            Mistake::EitherEnd => ["mistake-either-end", "mistake-either-end-effect"],
        };
        let mut this = *made == Some(mistake);
        choices::mistake(ui, face, words, &mut this);
        if this {
            *made = Some(mistake);
        } else if *made == Some(mistake) {
            *made = None;
        }
    }
}
