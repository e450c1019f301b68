//! What the labs that clip a polygon share: all but the algorithm.

use super::{Handle, Lab, Outcome, corners, count, window};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
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
        corners::fields(ui, face, contours(input));
        corners::buttons(ui, face, &mut input.polygon);
        window::fields(ui, face, &mut input.window);
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let LabInput::ClipPolygon(input) = document.input() else { return Vec::new() };
        // The corners last: where a handle of the window lies on one, the corner is on top.
        let sides = window::handles(&input.window).into_iter();
        sides.chain(corners::handles(input.all().into_iter())).collect()
    }

    fn outcome(&self, document: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let LabInput::ClipPolygon(input) = document.input() else { return None };
        let polygons = 1 + input.contours.len();
        let went = match self.0 {
            // Each ring is a piece, but for those that became holes of others.
            Algorithm::WeilerAtherton => {
                count(markers, Role::Accepted).saturating_sub(count(markers, Role::Changed))
            }
            Algorithm::SutherlandHodgman => {
                let named = markers.iter().filter(|(_, marker)| marker.label.is_some());
                let empty = named.filter(|(_, marker)| marker.role == Role::Rejected).count();
                polygons - empty.min(polygons)
            }
        };
        Some(Outcome { came: Some(polygons), went, unit: None, given: (polygons, "ui-unit-polygon") })
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        let LabInput::ClipPolygon(input) = document.input_mut() else { return };
        if let Some(index) = window::drag(&mut input.window, handle, to) {
            corners::drag(contours(input), index, to);
        }
    }
}

/// The polygon and what comes with it.
fn contours(input: &mut labs::ClipPolygon) -> impl Iterator<Item = &mut Vec<[f32; 2]>> {
    std::iter::once(&mut input.polygon).chain(&mut input.contours)
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
