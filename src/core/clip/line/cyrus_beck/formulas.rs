//! The formulas of Cyrus-Beck, with the numbers of a step.

use super::{Edge, Snapshot, forms::measured};
use crate::{
    clip::line::{End, Point, along},
    explain::{Formula, Piece},
    math::{Arithmetic, Real},
    message::Value,
};

/// `= u1 · v1 + u2 · v2 = result`.
fn product(general: &'static str, u: [Value; 2], v: [Value; 2], result: Value) -> Formula {
    let text = Piece::Text;
    let ([u1, u2], [v1, v2]) = (u.map(Piece::Number), v.map(Piece::Number));
    let result = Piece::Result(result);
    let numbers =
        vec![text("= "), u1, text(" · "), v1, text(" + "), u2, text(" · "), v2, text(" = "), result];
    Formula { general, numbers }
}

impl Snapshot {
    /// D·n, w·n and t of an edge, and n, D and w, as the run's arithmetic rounds them; the exact
    /// ones to binary64.
    fn measured(&self, edge: Edge) -> ([Value; 3], [[Value; 2]; 3]) {
        fn values<R: Real + Into<Value>>(
            ([speed, distance], vectors): ([R; 2], [[R; 2]; 3]),
        ) -> ([Value; 3], [[Value; 2]; 3]) {
            let t = (speed != R::ZERO).then(|| -distance / speed);
            ([speed.into(), distance.into(), t.into()], vectors.map(|v| v.map(Into::into)))
        }
        let (segment, edge) = (self.subject.original, self.window.edges()[usize::from(edge)]);
        if self.subject.arithmetic == Arithmetic::F32 {
            values(measured::<f32>(segment, edge))
        } else {
            values(measured::<f64>(segment, edge))
        }
    }

    /// D·n, w·n and t of an edge.
    pub(super) fn numbers(&self, edge: Edge) -> [Value; 3] {
        self.measured(edge).0
    }

    /// Both scalar products.
    pub(super) fn measurement(&self, edge: Edge) -> [Formula; 2] {
        let ([speed, distance, _], [normal, direction, to_p1]) = self.measured(edge);
        [
            product("D·n = Dx · nx + Dy · ny", direction, normal.clone(), speed),
            product("w·n = wx · nx + wy · ny", to_p1, normal, distance),
        ]
    }

    /// The division.
    pub(super) fn division(&self, edge: Edge, t: f32) -> Formula {
        let [speed, distance, _] = self.numbers(edge);
        let [speed, distance] = [speed, distance].map(Piece::Number);
        let text = Piece::Text;
        let numbers =
            vec![text("= −("), distance, text(") / ("), speed, text(") = "), Piece::Result(t.into())];
        Formula { general: "t = −(w·n) / (D·n)", numbers }
    }

    /// Both coordinates of a cut.
    pub(super) fn cut(&self, end: End, to: Point) -> [Formula; 2] {
        let t = self.bounds[end as usize];
        [0, 1].map(|axis| {
            let [b1, b2] = self.subject.original.map(|p| Piece::Number(p[axis].into()));
            Formula {
                general: ["x = x1 + t (x2 − x1)", "y = y1 + t (y2 − y1)"][axis],
                numbers: along(b1, b2, t.into(), Piece::Result(to[axis].into())),
            }
        })
    }
}
