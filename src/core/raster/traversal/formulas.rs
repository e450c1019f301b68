//! The formula of a traversal, with the numbers of a step.

use super::{Event, Snapshot, Traversal};
use crate::{
    explain::{Formula, Piece},
    raster::edge::centre,
};

impl<A: Traversal> Snapshot<A> {
    /// The edge function that decides about a centre.
    pub(super) fn formula(&self, event: &Event) -> Option<Formula> {
        let (Event::Test { x, y, keeps_out }, Some(edges)) = (*event, &self.edges) else { return None };
        // The edge that decides: the first that keeps it out, the one it lies on, or the nearest.
        let at = [x, y];
        let values = self.says(at).map_or([f64::INFINITY; 3], |says| says.map(|edge| edge.value));
        let nearest = (0..3).min_by(|&a, &b| values[a].total_cmp(&values[b])).unwrap_or_default();
        let edge = if keeps_out == 0 { nearest } else { (keeps_out.trailing_zeros() as usize).min(2) };
        let [[ax, ay], [bx, by]] = edges.0[edge].ends;
        let [px, py] = centre(x.into(), y.into());
        let number = |value: f32| Piece::Number(value.into());
        let text = Piece::Text;
        let numbers = vec![
            text("= ("),
            number(bx),
            text(" − "),
            number(ax),
            text(") · ("),
            number(py),
            text(" − "),
            number(ay),
            text(") − ("),
            number(by),
            text(" − "),
            number(ay),
            text(") · ("),
            number(px),
            text(" − "),
            number(ax),
            text(") = "),
            Piece::Result(values[edge].into()),
        ];
        let general = [
            "E0 = (bx − ax) (y − ay) − (by − ay) (x − ax)",
            "E1 = (bx − ax) (y − ay) − (by − ay) (x − ax)",
            "E2 = (bx − ax) (y − ay) − (by − ay) (x − ax)",
        ][edge];
        Some(Formula { general, numbers })
    }
}
