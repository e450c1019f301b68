//! The formulas of Cohen-Sutherland, with the numbers of a step.

use super::Snapshot;
use crate::{
    clip::line::{Border, End, Mistake, Point, along, share},
    explain::{Formula, Piece},
};

impl Snapshot {
    /// How far along the segment the border lies, and the coordinate there: exact arithmetic over
    /// the original ends, rounded arithmetic over the ends as they stood.
    pub(super) fn cut(&self, border: Border, end: End, to: Point) -> [Formula; 2] {
        let exact = self.subject.is_exact();
        let mut ends = if exact { self.subject.original } else { self.subject.ends };
        if let (false, Some(last)) = (exact, self.removed().next_back()) {
            ends[end as usize] = last.from;
        }
        let other = !exact && self.settings.mistakes.has(Mistake::OtherOrder);
        if other {
            ends.reverse();
        }
        let (fixed, free) = (border.axis(), 1 - border.axis());
        let [[a1, b1], [a2, b2]] = ends.map(|p| [p[fixed], p[free]]);
        let c = self.window.at(border);
        let (numbers, t) = share(c, [a1, a2], self.subject.arithmetic);
        let [b1, b2] = [b1, b2].map(|x| Piece::Number(x.into()));
        let share = Formula {
            general: match (border, other) {
                (Border::Top, false) => "t = (ymax − y1) / (y2 − y1)",
                (Border::Bottom, false) => "t = (ymin − y1) / (y2 − y1)",
                (Border::Right, false) => "t = (xmax − x1) / (x2 − x1)",
                (Border::Left, false) => "t = (xmin − x1) / (x2 − x1)",
                (Border::Top, true) => "t = (ymax − y2) / (y1 − y2)",
                (Border::Bottom, true) => "t = (ymin − y2) / (y1 − y2)",
                (Border::Right, true) => "t = (xmax − x2) / (x1 − x2)",
                (Border::Left, true) => "t = (xmin − x2) / (x1 − x2)",
            },
            numbers,
        };
        let place = Formula {
            general: match (fixed, exact, end, other) {
                (1, true, ..) => "x = x1 + t (x2 − x1)",
                (_, true, ..) => "y = y1 + t (y2 − y1)",
                (1, _, End::P1, false) => "x1 ← x1 + t (x2 − x1)",
                (1, _, End::P2, false) => "x2 ← x1 + t (x2 − x1)",
                (_, _, End::P1, false) => "y1 ← y1 + t (y2 − y1)",
                (_, _, End::P2, false) => "y2 ← y1 + t (y2 − y1)",
                (1, _, End::P1, true) => "x1 ← x2 + t (x1 − x2)",
                (1, _, End::P2, true) => "x2 ← x2 + t (x1 − x2)",
                (_, _, End::P1, true) => "y1 ← y2 + t (y1 − y2)",
                (_, _, End::P2, true) => "y2 ← y2 + t (y1 − y2)",
            },
            numbers: along(b1, b2, t, Piece::Result(to[free].into())),
        };
        [share, place]
    }
}
