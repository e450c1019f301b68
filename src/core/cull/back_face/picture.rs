//! The triangle as it is seen: its image, with the turning sense that the tests ask for.

use super::Snapshot;
use crate::explain::{Grid, Label, Mark, Role, View};

/// The square of NDC and some room around it.
pub(super) fn view(_of: &Snapshot) -> View {
    View { min: [-1.5, -1.5], max: [1.5, 1.5], y_up: true, grid: Grid::None }
}

/// The image of the triangle in NDC.
pub(super) fn marks(of: &Snapshot, out: &mut Vec<Mark>) {
    let square = vec![[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    out.push(Mark::Polygon { points: square, role: Role::Neutral, object: None, label: None });
    let ndc = of.input.spaces.ndc;
    out.push(Mark::Polygon { points: ndc.to_vec(), role: Role::Active, object: Some(0), label: None });
    for (at, name) in ndc.into_iter().zip(["p0", "p1", "p2"]) {
        out.push(Mark::Point { at, role: Role::Neutral, label: Some(Label::name(name)) });
    }
}
