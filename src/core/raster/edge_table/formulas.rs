//! The edge table's formulas, with the numbers of a step.

use super::{Event, Snapshot};
use crate::{
    explain::{Formula, Piece},
    message::Value,
    raster::YAxis,
};

impl Snapshot {
    /// The formula of an event, if it computes something.
    pub(super) fn formula(&self, event: &Event) -> Option<Formula> {
        match *event {
            Event::Slope { edge, dx_dy } => {
                let [[x0, y0], [x1, y1]] = self.upper_first(edge).map(|end| end.map(number));
                let numbers = [
                    ("= (", x1),
                    (" − ", x0),
                    (") / (", y1),
                    (" − ", y0),
                    (") = ", Piece::Result(dx_dy.into())),
                ];
                Some(formula("dx/dy = (x1 − x0) / (y1 − y0)", numbers))
            }
            Event::Crossing { edge, x } => self.crossing(edge, x),
            Event::First { edge, x, .. } => {
                let at = self.live(edge)?.x?;
                let guess = (at - 0.5).ceil();
                let mut first = formula("first = ⌈x − 0.5⌉", [("= ⌈", Piece::Number(at.into()))]);
                first.numbers.push(Piece::Text(" − 0.5⌉ = "));
                if guess != f64::from(x) {
                    // Kept within the image, or moved by the exact sign.
                    first.numbers.extend([Piece::Number(guess.into()), Piece::Text(" → ")]);
                }
                first.numbers.push(Piece::Result(x.into()));
                Some(first)
            }
            Event::Across { edge, winding } => {
                let direction = self.direction(edge);
                let (general, sign) = match direction {
                    1 => ("winding = winding + 1", " + 1 = "),
                    _ => ("winding = winding − 1", " − 1 = "),
                };
                let before = Piece::Number((winding - direction).into());
                Some(formula(general, [("= ", before), (sign, Piece::Result(winding.into()))]))
            }
            Event::Span { begin, end } => {
                let numbers = [
                    ("= ", Piece::Number(end.into())),
                    (" − ", Piece::Number(begin.into())),
                    (" = ", Piece::Result((end - begin).into())),
                ];
                Some(formula("pixels = first − begin", numbers))
            }
            _ => None,
        }
    }

    fn upper_first(&self, edge: u32) -> [[f32; 2]; 2] {
        let [a, b] = self.ends(edge);
        if self.direction(edge) > 0 { [a, b] } else { [b, a] }
    }

    fn crossing(&self, edge: u32, x: f64) -> Option<Formula> {
        let listed = self.table.iter().find(|listed| listed.edge == edge)?;
        let (slope, result) = (Piece::Number(listed.dx_dy?.into()), Piece::Result(x.into()));
        let row = self.row?;
        let is_taught = !self.settings.arithmetic.is_exact();
        if let Some(before) = self.live(edge)?.before.filter(|_| is_taught) {
            let (general, sign) = match self.settings.y_axis {
                YAxis::Down => ("x = x + dx/dy", " + "),
                YAxis::Up => ("x = x − dx/dy", " − "),
            };
            let before = Piece::Number(before.into());
            return Some(formula(general, [("= ", before), (sign, slope), (" = ", result)]));
        }
        let [[x0, y0], _] = self.upper_first(edge);
        let centre = row as f32 + 0.5;
        let numbers = [
            ("= ", number(x0)),
            (" + (", number(centre)),
            (" − ", number(y0)),
            (") · ", slope),
            (" = ", result),
        ];
        Some(formula("x = x0 + (y − y0) · dx/dy", numbers))
    }
}

fn formula<const N: usize>(general: &'static str, numbers: [(&'static str, Piece); N]) -> Formula {
    let numbers = numbers.into_iter().flat_map(|(text, piece)| [Piece::Text(text), piece]).collect();
    Formula { general, numbers }
}

fn number(value: f32) -> Piece {
    Piece::Number(Value::from(value))
}
