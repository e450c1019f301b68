//! The formulas of the plane equation, with the numbers of a step.

use super::{Event, Quantity, Snapshot, explain::PlaneState};
use crate::{
    explain::{Formula, Piece},
    interpolate::Mode,
    message::Value,
    raster::edge::centre,
};

/// The components of the cross product.
const NORMAL: [&str; 3] = [
    "A = (y1 − y0)(q2 − q0) − (q1 − q0)(y2 − y0)",
    "B = (q1 − q0)(x2 − x0) − (x1 − x0)(q2 − q0)",
    "C = (x1 − x0)(y2 − y0) − (y1 − y0)(x2 − x0)",
];

impl Snapshot {
    /// The formula of an event, if it computes something.
    pub(super) fn formula(&self, event: &Event) -> Option<Formula> {
        match *event {
            Event::Normal { quantity, axis, value } => Some(self.normal(quantity, usize::from(axis), value)),
            Event::Offset { quantity, value } => self.offset(quantity, value),
            Event::Slope { quantity, axis, value } => self.slope(quantity, usize::from(axis), value),
            Event::Start { quantity, x, value } => self.start(quantity, x.into(), value),
            Event::Step { quantity, value, .. } => {
                let PlaneState { before, slopes: [dq_dx, _], .. } = self.plane(quantity)?;
                let terms = [(*before)?, (*dq_dx)?].map(number);
                Some(written("q = q − A/C", &["= ", " + "], terms, value.into()))
            }
            Event::Value { mode: Mode::Perspective, value, .. } => {
                let [over, reciprocal] = [Quantity::Over, Quantity::Reciprocal].map(|q| self.plane(q)?.value);
                let terms = [over?, reciprocal?].map(number);
                Some(written("a = (a/w) / (1/w)", &["= ", " / "], terms, value.into()))
            }
            _ => None,
        }
    }

    /// What the vertices have of a quantity, for display.
    fn q(&self, quantity: Quantity) -> [f64; 3] {
        let (a, w) = (self.subject.attribute.map(f64::from), self.subject.w().map(f64::from));
        [0, 1, 2].map(|i| match quantity {
            Quantity::Value => a[i],
            Quantity::Over => a[i] / w[i],
            Quantity::Reciprocal => 1.0 / w[i],
        })
    }

    fn normal(&self, quantity: Quantity, axis: usize, value: f64) -> Formula {
        let points = self.subject.points(self.arithmetic).map(|point| point.map(f64::from));
        let q = self.q(quantity);
        let side = |i: usize| [points[i][0] - points[0][0], points[i][1] - points[0][1], q[i] - q[0]];
        let [u, v] = [side(1), side(2)];
        let [first, second] = [[1, 2], [2, 0], [0, 1]][axis];
        let terms = [u[first], v[second], u[second], v[first]].map(number);
        written(NORMAL[axis], &["= ", " · ", " − ", " · "], terms, value.into())
    }

    fn offset(&self, quantity: Quantity, value: f64) -> Option<Formula> {
        let [a, b, c] = self.plane(quantity)?.normal;
        let [[x0, y0], ..] = self.subject.points(self.arithmetic).map(|point| point.map(f64::from));
        let terms = [a?, x0, b?, y0, c?, self.q(quantity)[0]].map(number);
        let texts = ["= −(", " · ", " + ", " · ", " + ", " · "];
        let mut formula = written("D = −(A x0 + B y0 + C q0)", &texts, terms, value.into());
        let close = formula.numbers.len() - 2;
        formula.numbers[close] = Piece::Text(") = ");
        Some(formula)
    }

    fn slope(&self, quantity: Quantity, axis: usize, value: f64) -> Option<Formula> {
        let normal = self.plane(quantity)?.normal;
        let terms = [normal[axis]?, normal[2]?].map(number);
        Some(written(["dq/dx = −A/C", "dq/dy = −B/C"][axis], &["= −", " / "], terms, value.into()))
    }

    fn start(&self, quantity: Quantity, x: u32, value: f64) -> Option<Formula> {
        let PlaneState { normal: [a, b, c], d, .. } = self.plane(quantity)?;
        let [y, ..] = self.row?;
        let [x, y] = centre(x, y).map(f64::from);
        let terms = [(*a)?, x, (*b)?, y, (*d)?, (*c)?].map(number);
        let texts = ["= (−", " · ", " − ", " · ", " − ", ") / "];
        Some(written("q = (−A x − B y − D) / C", &texts, terms, value.into()))
    }
}

fn number(value: f64) -> Value {
    value.into()
}

/// Texts and numbers in turn, then the result.
fn written<const N: usize>(
    general: &'static str,
    texts: &[&'static str; N],
    terms: [Value; N],
    result: Value,
) -> Formula {
    let mut numbers = Vec::with_capacity(2 * N + 2);
    for (text, term) in texts.iter().zip(terms) {
        numbers.extend([Piece::Text(text), Piece::Number(term)]);
    }
    numbers.extend([Piece::Text(" = "), Piece::Result(result)]);
    Formula { general, numbers }
}
