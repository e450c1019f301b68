//! The formulas of Nicholl-Lee-Nicholl, with the numbers of a step.

use super::{Snapshot, forms::product};
use crate::{
    clip::line::{Border, Point},
    explain::{Formula, Piece},
    math::Arithmetic,
    message::Value,
};

impl Snapshot {
    /// The product of a border, as the run's arithmetic rounds it; the exact one to binary64.
    fn product(&self, border: Border) -> Value {
        let (ends, at) = (self.subject.original, self.window.at(border));
        if self.subject.arithmetic == Arithmetic::F32 {
            product(ends, at, border).into()
        } else {
            product(ends.map(|p| p.map(f64::from)), f64::from(at), border).into()
        }
    }

    /// One of the products that a slope comparison compares.
    pub(super) fn slope(&self, border: Border) -> Formula {
        let (fixed, free) = (border.axis(), 1 - border.axis());
        let [p1, p2] = self.subject.original;
        let text = Piece::Text;
        let number = |x: f32| Piece::Number(x.into());
        Formula {
            general: match border {
                Border::Top => "T = (ymax − y1) · (x2 − x1)",
                Border::Bottom => "B = (ymin − y1) · (x2 − x1)",
                Border::Right => "R = (xmax − x1) · (y2 − y1)",
                Border::Left => "L = (xmin − x1) · (y2 − y1)",
            },
            numbers: vec![
                text("= ("),
                number(self.window.at(border)),
                text(" − "),
                number(p1[fixed]),
                text(") · ("),
                number(p2[free]),
                text(" − "),
                number(p1[free]),
                text(") = "),
                Piece::Result(self.product(border)),
            ],
        }
    }

    /// The coordinate of a cut that is not the border's.
    pub(super) fn cut(&self, border: Border, to: Point) -> Formula {
        let (fixed, free) = (border.axis(), 1 - border.axis());
        let [p1, p2] = self.subject.original;
        let text = Piece::Text;
        let number = |x: f32| Piece::Number(x.into());
        Formula {
            general: match border {
                Border::Top => "x = x1 + T / (y2 − y1)",
                Border::Bottom => "x = x1 + B / (y2 − y1)",
                Border::Right => "y = y1 + R / (x2 − x1)",
                Border::Left => "y = y1 + L / (x2 − x1)",
            },
            numbers: vec![
                text("= "),
                number(p1[free]),
                text(" + "),
                Piece::Number(self.product(border)),
                text(" / ("),
                number(p2[fixed]),
                text(" − "),
                number(p1[fixed]),
                text(") = "),
                Piece::Result(to[free].into()),
            ],
        }
    }
}
