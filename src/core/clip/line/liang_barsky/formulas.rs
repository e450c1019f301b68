//! The formulas of Liang-Barsky, with the numbers of a step.

use super::{Snapshot, forms::measured};
use crate::{
    clip::line::{Border, End, Point, along},
    explain::{Formula, Piece},
    math::Arithmetic,
    message::Value,
};

impl Snapshot {
    /// p, q and q / p of a border, as the run's arithmetic rounds them; the exact ones to
    /// binary64. The quotient is for the reader: the algorithm has not divided yet.
    pub(super) fn numbers(&self, border: Border) -> [Value; 3] {
        if self.subject.arithmetic == Arithmetic::F32 {
            let [p, q] = measured::<f32>(self.subject.original, &self.window, border);
            [p.into(), q.into(), (p != 0.0).then(|| q / p).into()]
        } else {
            let [p, q] = measured::<f64>(self.subject.original, &self.window, border);
            [p.into(), q.into(), (p != 0.0).then(|| q / p).into()]
        }
    }

    /// p and q.
    pub(super) fn measurement(&self, border: Border) -> [Formula; 2] {
        let [a1, a2] = self.subject.original.map(|p| p[border.axis()]);
        let c = self.window.at(border);
        let [p, q, _] = self.numbers(border);
        let minus = |general, a: f32, b: f32, result| Formula {
            general,
            numbers: vec![
                Piece::Text("= "),
                Piece::Number(a.into()),
                Piece::Text(" − "),
                Piece::Number(b.into()),
                Piece::Text(" = "),
                Piece::Result(result),
            ],
        };
        match border {
            Border::Top => [minus("p = y2 − y1", a2, a1, p), minus("q = ymax − y1", c, a1, q)],
            Border::Bottom => [minus("p = y1 − y2", a1, a2, p), minus("q = y1 − ymin", a1, c, q)],
            Border::Right => [minus("p = x2 − x1", a2, a1, p), minus("q = xmax − x1", c, a1, q)],
            Border::Left => [minus("p = x1 − x2", a1, a2, p), minus("q = x1 − xmin", a1, c, q)],
        }
    }

    /// The only division.
    pub(super) fn division(&self, border: Border, t: f32) -> Formula {
        let [p, q, _] = self.numbers(border);
        let text = Piece::Text;
        let [p, q] = [p, q].map(Piece::Number);
        Formula {
            general: "t = q / p",
            numbers: vec![text("= "), q, text(" / "), p, text(" = "), Piece::Result(t.into())],
        }
    }

    /// Both coordinates of a cut; in exact arithmetic that of the border is assigned.
    pub(super) fn cut(&self, border: Border, end: End, to: Point) -> [Formula; 2] {
        let assigned = self.subject.is_exact();
        let t = self.quotients[end as usize].map_or(Value::None, Value::F32);
        let text = Piece::Text;
        [0, 1].map(|axis| {
            let [b1, b2] = self.subject.original.map(|p| Piece::Number(p[axis].into()));
            let result = Piece::Result(to[axis].into());
            if assigned && axis == border.axis() {
                let general = match border {
                    Border::Top => "y = ymax",
                    Border::Bottom => "y = ymin",
                    Border::Right => "x = xmax",
                    Border::Left => "x = xmin",
                };
                return Formula { general, numbers: vec![text("= "), result] };
            }
            Formula {
                general: ["x = x1 + t (x2 − x1)", "y = y1 + t (y2 − y1)"][axis],
                numbers: along(b1, b2, t.clone(), result),
            }
        })
    }
}
