//! The formulas of Cohen-Sutherland, with the numbers of a step.

use super::Snapshot;
use crate::{
    clip::line::{Border, End, Outcode, Point, along, share},
    explain::{Formula, Piece},
    math::Arithmetic,
    message::Value,
};

pub(super) fn bits(code: Outcode) -> Value {
    Value::Bits { bits: code.0.into(), width: 4 }
}

/// Two codes joined to a third.
pub(super) fn joined(general: &'static str, sign: &'static str, [c1, c2, result]: [Outcode; 3]) -> Formula {
    let numbers = vec![
        Piece::Number(bits(c1)),
        Piece::Text(sign),
        Piece::Number(bits(c2)),
        Piece::Text(" = "),
        Piece::Result(bits(result)),
    ];
    Formula { general, numbers }
}

impl Snapshot {
    /// How far along the segment the border lies, and the coordinate there: exact arithmetic over
    /// the original ends, rounded arithmetic over the ends as they stood.
    pub(super) fn cut(&self, border: Border, end: End, to: Point) -> [Formula; 2] {
        let exact = matches!(self.arithmetic, Arithmetic::Exact | Arithmetic::Fixed8);
        let mut ends = if exact { self.original } else { self.ends };
        if let (false, Some(last)) = (exact, self.removed().next_back()) {
            ends[end as usize] = last.from;
        }
        let (fixed, free) = (border.axis(), 1 - border.axis());
        let [[a1, b1], [a2, b2]] = ends.map(|p| [p[fixed], p[free]]);
        let c = self.window.at(border);
        let (numbers, t) = share(c, [a1, a2], self.arithmetic);
        let [b1, b2] = [b1, b2].map(|x| Piece::Number(x.into()));
        let share = Formula {
            general: match border {
                Border::Top => "t = (ymax − y1) / (y2 − y1)",
                Border::Bottom => "t = (ymin − y1) / (y2 − y1)",
                Border::Right => "t = (xmax − x1) / (x2 − x1)",
                Border::Left => "t = (xmin − x1) / (x2 − x1)",
            },
            numbers,
        };
        let place = Formula {
            general: match (fixed, exact, end) {
                (1, true, _) => "x = x1 + t (x2 − x1)",
                (_, true, _) => "y = y1 + t (y2 − y1)",
                (1, _, End::P1) => "x1 ← x1 + t (x2 − x1)",
                (1, _, End::P2) => "x2 ← x1 + t (x2 − x1)",
                (_, _, End::P1) => "y1 ← y1 + t (y2 − y1)",
                (_, _, End::P2) => "y2 ← y1 + t (y2 − y1)",
            },
            numbers: along(b1, b2, t, Piece::Result(to[free].into())),
        };
        [share, place]
    }
}
