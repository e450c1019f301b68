//! The formulas of Sutherland-Hodgman, with the numbers of a step.

use super::{
    super::outline::{Carrier, Corner, Source},
    Mistake, Snapshot,
};
use crate::{
    clip::line::{Border, Point, Segment, Window, along, share},
    explain::{Formula, Piece},
    message::Value,
};

/// How far inside a border a corner lies; negative beyond it.
pub(super) fn distance(corner: &Corner, border: Border, window: &Window) -> f32 {
    let (at, c) = (corner.at[border.axis()], window.at(border));
    if border.is_upper() { c - at } else { at - c }
}

impl Snapshot {
    /// The distances of both ends of the edge from the side.
    pub(super) fn distances(&self) -> Option<Formula> {
        let ([s, e], border) = (self.edge()?, self.side()?);
        let [ds, de] = [s, e].map(|corner| Piece::Result(distance(corner, border, &self.window).into()));
        let general = match border {
            Border::Left => "d = x − xmin",
            Border::Right => "d = xmax − x",
            Border::Bottom => "d = y − ymin",
            Border::Top => "d = ymax − y",
        };
        let numbers = vec![Piece::Text("d(s) = "), ds, Piece::Text("   d(e) = "), de];
        Some(Formula { general, numbers })
    }

    /// How far along the edge the side lies, and the coordinate there: exact arithmetic over the edge as
    /// it was given, rounded arithmetic over its ends as they stand.
    pub(super) fn cut_formulas(&self, to: Point, source: Source) -> Vec<Formula> {
        let (Some(border), Some(edge), false) =
            (self.side(), self.edge(), matches!(source, Source::Window(_)))
        else {
            return Vec::new();
        };
        let exact = self.settings.arithmetic.is_exact();
        let ends = if exact { self.given_ends(edge) } else { self.standing_ends(edge) };
        let (fixed, free) = (border.axis(), 1 - border.axis());
        let [[a1, b1], [a2, b2]] = ends.map(|p| [p[fixed], p[free]]);
        let (numbers, t) = share(self.window.at(border), [a1, a2], self.settings.arithmetic);
        let general = match border {
            Border::Left => "t = (xmin − x1) / (x2 − x1)",
            Border::Right => "t = (xmax − x1) / (x2 − x1)",
            Border::Bottom => "t = (ymin − y1) / (y2 − y1)",
            Border::Top => "t = (ymax − y1) / (y2 − y1)",
        };
        let place = if fixed == 0 { "y = y1 + t (y2 − y1)" } else { "x = x1 + t (x2 − x1)" };
        let [b1, b2] = [b1, b2].map(|b| Piece::Number(b.into()));
        let result = Piece::Result(Value::from(to[free]));
        vec![Formula { general, numbers }, Formula { general: place, numbers: along(b1, b2, t, result) }]
    }

    fn given_ends(&self, [s, _]: [&Corner; 2]) -> Segment {
        let points = self.points();
        match s.next {
            Carrier::Edge(edge) => {
                let edge = edge as usize;
                [points[edge], points[(edge + 1) % points.len()]]
            }
            Carrier::Border(_) => [s.at; 2],
        }
    }

    /// The end to start from comes first: as it is walked by mistake, else the inner one.
    fn standing_ends(&self, [s, e]: [&Corner; 2]) -> Segment {
        let leaves = self.looked.last().is_some_and(|looked| looked.to == super::Place::Out);
        let as_walked = leaves || self.settings.mistake == Some(Mistake::EitherEnd);
        if as_walked { [s.at, e.at] } else { [e.at, s.at] }
    }
}
