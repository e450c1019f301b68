//! The formulas of a value by area ratios, with the numbers of a step.

use super::{Event, Snapshot};
use crate::{
    explain::{Formula, Piece},
    interpolate::Mode,
    message::Value,
};

/// The general form for each vertex.
const PARTS: [&str; 3] = [
    "2 |P V1 V2| = (V2 − V1) × (P − V1)",
    "2 |P V2 V0| = (V0 − V2) × (P − V2)",
    "2 |P V0 V1| = (V1 − V0) × (P − V0)",
];
const SHARES: [&str; 3] =
    ["l0 = |P V1 V2| / |V0 V1 V2|", "l1 = |P V2 V0| / |V0 V1 V2|", "l2 = |P V0 V1| / |V0 V1 V2|"];

impl Snapshot {
    /// The formula of an event, if it computes something.
    pub(super) fn formula(&self, event: &Event) -> Option<Formula> {
        let subject = &self.subject;
        let [v0, v1, v2] = self.points();
        Some(match *event {
            Event::Whole { area } => cross("2 |V0 V1 V2| = (V1 − V0) × (V2 − V0)", v0, v1, v2, area),
            Event::Part { vertex, area } => {
                let i = usize::from(vertex);
                let [from, to] = [[v1, v2], [v2, v0], [v0, v1]][i];
                cross(PARTS[i], from, to, subject.at, area)
            }
            Event::Share { vertex, l } => {
                let i = usize::from(vertex);
                let half = |area: Option<f64>| area.map(|area| area / 2.0).into();
                quotient(SHARES[i], half(self.parts[i]), half(self.whole), l.into())
            }
            Event::Over { vertex, value } => {
                let i = usize::from(vertex);
                quotient("a / w", subject.attribute[i].into(), subject.w()[i].into(), value.into())
            }
            Event::Reciprocal { vertex, value } => {
                quotient("1 / w", 1.0_f64.into(), subject.w()[usize::from(vertex)].into(), value.into())
            }
            Event::SumOver { value } => {
                self.sum("a/w = l0 a0/w0 + l1 a1/w1 + l2 a2/w2", self.over.map(Value::from), value.into())
            }
            Event::SumReciprocal { value } => {
                self.sum("1/w = l0/w0 + l1/w1 + l2/w2", self.reciprocal.map(Value::from), value.into())
            }
            Event::Value { mode: Mode::Affine, value } => {
                self.sum("a = l0 a0 + l1 a1 + l2 a2", subject.attribute.map(Value::from), value.into())
            }
            Event::Value { mode: Mode::Perspective, value } => {
                let [over, reciprocal] = self.sums.map(Value::from);
                quotient("a = (a/w) / (1/w)", over, reciprocal, value.into())
            }
            Event::Refused { .. } => return None,
        })
    }

    /// Three values, each times what its vertex weighs.
    fn sum(&self, general: &'static str, values: [Value; 3], result: Value) -> Formula {
        let mut numbers = Vec::new();
        for ((i, l), value) in self.l.iter().enumerate().zip(values) {
            numbers.extend([
                Piece::Text(if i == 0 { "= " } else { " + " }),
                Piece::Number((*l).into()),
                Piece::Text(" · "),
                Piece::Number(value),
            ]);
        }
        numbers.extend([Piece::Text(" = "), Piece::Result(result)]);
        Formula { general, numbers }
    }
}

fn quotient(general: &'static str, over: Value, under: Value, result: Value) -> Formula {
    let numbers = vec![
        Piece::Text("= "),
        Piece::Number(over),
        Piece::Text(" / "),
        Piece::Number(under),
        Piece::Text(" = "),
        Piece::Result(result),
    ];
    Formula { general, numbers }
}

/// `(b − a) × (c − a)`
fn cross(general: &'static str, a: [f32; 2], b: [f32; 2], c: [f32; 2], result: f64) -> Formula {
    let side = |to: [f32; 2]| Piece::Number([0, 1].map(|axis| to[axis] - a[axis]).into());
    let numbers = vec![
        Piece::Text("= "),
        side(b),
        Piece::Text(" × "),
        side(c),
        Piece::Text(" = "),
        Piece::Result(result.into()),
    ];
    Formula { general, numbers }
}
