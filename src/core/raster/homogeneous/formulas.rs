//! The formulas of homogeneous rasterization, with the numbers of a step.

use super::{
    Event, Snapshot,
    explain::{NEAR_ROW, SUM},
    form::ends,
};
use crate::{
    explain::{Formula, Piece},
    raster::{edge::centre, traversal},
};

/// The components of which each coefficient is a difference of products.
const TERMS: [[usize; 2]; 3] = [[1, 2], [2, 0], [0, 1]];

impl Snapshot {
    /// The formulas of an event, if it computes something.
    pub(super) fn formulas_of(&self, event: &Event, out: &mut Vec<Formula>) {
        let number = |value: Option<f64>| Piece::Number(value.into());
        let text = Piece::Text;
        match *event {
            Event::Coefficient { edge, term, value } => {
                let [p, q] = ends(self.vertices, usize::from(edge));
                let [i, j] = TERMS[usize::from(term)];
                let general = ["a = py · qw − pw · qy", "b = pw · qx − px · qw", "c = px · qy − py · qx"]
                    [usize::from(term)];
                let given = |value: f32| Piece::Number(value.into());
                let numbers = vec![
                    text("= "),
                    given(p[i]),
                    text(" · "),
                    given(q[j]),
                    text(" − "),
                    given(p[j]),
                    text(" · "),
                    given(q[i]),
                    text(" = "),
                    Piece::Result(value.into()),
                ];
                out.push(Formula { general, numbers });
            }
            Event::Determinant { value } => {
                let [x, y, w] = self.vertices[0].map(|value| Piece::Number(value.into()));
                let [a, b, c] = self.rows[0].map(number);
                let numbers = vec![
                    text("= "),
                    x,
                    text(" · "),
                    a,
                    text(" + "),
                    y,
                    text(" · "),
                    b,
                    text(" + "),
                    w,
                    text(" · "),
                    c,
                    text(" = "),
                    Piece::Result(value.into()),
                ];
                out.push(Formula { general: "det = x0 · a + y0 · b + w0 · c", numbers });
            }
            Event::InverseW { term, value } => {
                let [e0, e1, e2] = [0, 1, 2].map(|edge| number(self.rows[edge][usize::from(term)]));
                let numbers = vec![
                    text("= "),
                    e0,
                    text(" + "),
                    e1,
                    text(" + "),
                    e2,
                    text(" = "),
                    Piece::Result(value.into()),
                ];
                let general = ["a = a0 + a1 + a2", "b = b0 + b1 + b2", "c = c0 + c1 + c2"][usize::from(term)];
                out.push(Formula { general, numbers });
            }
            Event::Near { term, value } => {
                let near = Piece::Number(self.near.into());
                let of_sum = number(self.rows[SUM][usize::from(term)]);
                let (general, mut numbers) = match term {
                    0 => ("a = −near · a", vec![text("= −")]),
                    1 => ("b = −near · b", vec![text("= −")]),
                    _ => ("c = det − near · c", vec![text("= "), number(self.determinant), text(" − ")]),
                };
                numbers.extend([near, text(" · "), of_sum, text(" = "), Piece::Result(value.into())]);
                out.push(Formula { general, numbers });
            }
            Event::Walk { event: traversal::Event::Test { x, y, .. }, .. } => {
                let says = self.says([x.into(), y.into()]);
                let Some(edge) = says.iter().position(|says| !says.draws).or(Some(0)) else { return };
                let row = if edge == super::form::NEAR { NEAR_ROW } else { edge };
                let (Some(said), [a, b, c]) = (says.get(edge), self.rows[row].map(number)) else { return };
                let [px, py] = centre(x.into(), y.into()).map(|value| Piece::Number(value.into()));
                let numbers = vec![
                    text("= "),
                    a,
                    text(" · "),
                    px,
                    text(" + "),
                    b,
                    text(" · "),
                    py,
                    text(" + "),
                    c,
                    text(" = "),
                    Piece::Result(said.value.into()),
                ];
                let general =
                    ["E0 = a x + b y + c", "E1 = a x + b y + c", "E2 = a x + b y + c", "N = a x + b y + c"]
                        [edge];
                out.push(Formula { general, numbers });
            }
            _ => {}
        }
    }
}
