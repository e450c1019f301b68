//! The scan line's formulas, with the numbers of a step.

use super::{Between, Event, Side, Snapshot};
use crate::{
    explain::{Formula, Piece},
    message::Value,
    raster::{FillRule, YAxis},
};

impl Snapshot {
    /// The formula of an event, if it computes something.
    pub(super) fn formula(&self, event: &Event) -> Option<Formula> {
        match *event {
            Event::Slope { edge, dx_dy } => Some(self.slope(edge, dx_dy)),
            Event::Crossing { side, edge, x } => Some(self.crossing(side, edge, x)),
            Event::End { side, x, .. } => self.end(side, x),
            _ => None,
        }
    }

    fn slope(&self, edge: Between, dx_dy: f64) -> Formula {
        let [[x0, y0], [x1, y1]] = self.ends(edge).map(|end| self.vertices[end].map(number));
        let numbers = vec![
            Piece::Text("= ("),
            x1,
            Piece::Text(" − "),
            x0,
            Piece::Text(") / ("),
            y1,
            Piece::Text(" − "),
            y0,
            Piece::Text(") = "),
            Piece::Result(dx_dy.into()),
        ];
        Formula { general: "dx/dy = (x1 − x0) / (y1 − y0)", numbers }
    }

    fn crossing(&self, side: Side, edge: Between, x: f64) -> Formula {
        let slope = self.slopes[edge as usize].unwrap_or(0.0);
        let (slope, result) = (Piece::Number(slope.into()), Piece::Result(x.into()));
        if let Some(last) = self.last_crossing(side, edge) {
            let (general, sign) = match (side, self.settings.y_axis) {
                (Side::Left, YAxis::Down) => ("x left = x left + dx/dy", " + "),
                (Side::Right, YAxis::Down) => ("x right = x right + dx/dy", " + "),
                (Side::Left, YAxis::Up) => ("x left = x left − dx/dy", " − "),
                (Side::Right, YAxis::Up) => ("x right = x right − dx/dy", " − "),
            };
            let numbers = vec![
                Piece::Text("= "),
                Piece::Number(last.into()),
                Piece::Text(sign),
                slope,
                Piece::Text(" = "),
                result,
            ];
            return Formula { general, numbers };
        }
        let [start, _] = self.ends(edge);
        let [x0, y0] = self.vertices[start].map(number);
        let centre = self.row().map(|row| row.y as f32 + 0.5);
        let numbers = vec![
            Piece::Text("= "),
            x0,
            Piece::Text(" + ("),
            Piece::Number(centre.into()),
            Piece::Text(" − "),
            y0,
            Piece::Text(") · "),
            slope,
            Piece::Text(" = "),
            result,
        ];
        let general = match side {
            Side::Left => "x left = x0 + (y − y0) · dx/dy",
            Side::Right => "x right = x0 + (y − y0) · dx/dy",
        };
        Formula { general, numbers }
    }

    /// The crossing of the row before, if rounded arithmetic added the slope to it.
    fn last_crossing(&self, side: Side, edge: Between) -> Option<f64> {
        if !self.settings.accumulates() {
            return None;
        }
        let before = self.rows.iter().nth_back(1)?;
        before.crossings[side as usize].filter(|(other, _)| *other == edge).map(|(_, x)| x)
    }

    fn end(&self, side: Side, x: u32) -> Option<Formula> {
        let (_, at) = self.row()?.crossings[side as usize]?;
        // A span leaves out a tie at its begin, or takes one in at its end.
        let past_ties = match side {
            Side::Left => self.settings.fill_rule == FillRule::Strict,
            Side::Right => self.settings.fill_rule == FillRule::Inclusive,
        };
        let (general, open, close, guess) = match (side, past_ties) {
            (Side::Left, false) => ("first = ⌈x left − 0.5⌉", "= ⌈", " − 0.5⌉ = ", (at - 0.5).ceil()),
            (Side::Right, false) => ("end = ⌈x right − 0.5⌉", "= ⌈", " − 0.5⌉ = ", (at - 0.5).ceil()),
            (Side::Left, true) => ("first = ⌊x left + 0.5⌋", "= ⌊", " + 0.5⌋ = ", (at - 0.5).floor() + 1.0),
            (Side::Right, true) => ("end = ⌊x right + 0.5⌋", "= ⌊", " + 0.5⌋ = ", (at - 0.5).floor() + 1.0),
        };
        let mut numbers = vec![Piece::Text(open), Piece::Number(at.into()), Piece::Text(close)];
        if guess != f64::from(x) {
            // Kept within the image, or moved by the exact sign.
            numbers.extend([Piece::Number(guess.into()), Piece::Text(" → ")]);
        }
        numbers.push(Piece::Result(x.into()));
        Some(Formula { general, numbers })
    }
}

fn number(value: f32) -> Piece {
    Piece::Number(Value::from(value))
}
