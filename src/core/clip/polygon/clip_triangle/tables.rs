//! The values of clipping a triangle.

use super::{Mistake, Snapshot, Space, TaughtCorner, snapshot::Named};
use crate::{
    explain::{Role, Row, Table},
    math::ulps_between,
    message::Value,
};

/// The names of the coordinates and of the attribute.
const COLUMNS: [&str; 5] = ["x", "y", "z", "w", "u"];

impl Snapshot {
    /// The headings of a table of corners.
    fn columns(&self) -> Vec<&'static str> {
        let mut columns = COLUMNS[..self.dimensions()].to_vec();
        columns.push("u");
        columns
    }

    /// The cells of a corner of a result.
    fn cells(&self, there: &TaughtCorner) -> Vec<Value> {
        let mut cells: Vec<Value> =
            there.corner.position[..self.dimensions()].iter().map(|&c| c.into()).collect();
        cells.push(there.attribute.into());
        cells
    }
}

/// The edges of the polygon against the current plane, as far as they are walked.
pub(super) fn edges(state: &Snapshot) -> Option<Table> {
    if state.sides.is_empty() {
        return None;
    }
    let count = state.corners.len();
    let side = |i: usize| state.sides.get(i).map(|(_, d)| *d);
    let rows = (0..count).map(|from| {
        let to = (from + 1) % count;
        let walked = state.walked.iter().find(|walked| walked.from == from);
        let transition = walked.map_or(Value::None, |walked| {
            Value::Word(match (walked.kept, walked.emitted.is_some()) {
                (true, true) => "clip-triangle-in-out",
                (false, true) => "clip-triangle-out-in",
                (true, false) => "clip-triangle-in-in",
                (false, false) => "clip-triangle-out-out",
            })
        });
        let emits = walked.map_or(Value::None, |walked| {
            let kept = walked.kept.then(|| state.corners[from].name.clone());
            let names: Vec<_> = kept.into_iter().chain(walked.emitted.clone()).collect();
            if names.is_empty() { Value::None } else { Value::text(names.join(", ")) }
        });
        let now = match state.walked.last() {
            Some(last) => last.from == from,
            None => state.sides.len() == from + 1,
        };
        let name = format!("{} → {}", state.corners[from].name, state.corners[to].name);
        Row::new(name, vec![side(from).into(), side(to).into(), transition, emits]).active(now)
    });
    Some(Table {
        title: "clip-triangle-edges",
        columns: vec![
            "column-clip-triangle-from",
            "column-clip-triangle-to",
            "column-clip-triangle-transition",
            "column-clip-triangle-emits",
        ],
        rows: rows.collect(),
    })
}

/// The polygon: while a plane cuts, what was kept and emitted so far.
pub(super) fn polygon(state: &Snapshot) -> Option<Table> {
    let cutting = !state.walked.is_empty();
    let corners: &[Named] = if cutting { &state.next } else { &state.corners };
    if corners.is_empty() {
        return None;
    }
    let size = state.dimensions();
    let last = corners.len() - 1;
    let rows = corners.iter().enumerate().map(|(i, corner)| {
        let mut cells: Vec<Value> = match state.rounded.get(i).filter(|_| !cutting) {
            Some(at) => at[..size].iter().map(|&c| c.into()).collect(),
            None => corner.at[..size].iter().map(|&c| c.into()).collect(),
        };
        cells.push(state.attributes.get(i).copied().into());
        cells.push(corner.t.into());
        let now = if cutting {
            i == last && corner.t.is_some()
        } else {
            !state.over
                && (state.attributes.len() == i + 1
                    || state.attributes.is_empty() && state.rounded.len() == i + 1)
        };
        let differs = state.over && state.is_taught() && !agrees(state, i);
        let role = if differs { Role::Taught } else { Role::Accepted };
        Row::new(corner.name.clone(), cells).active(now).role(state.over.then_some(role))
    });
    let mut columns = state.columns();
    columns.push("t");
    let title = if cutting { "clip-triangle-so-far" } else { "clip-triangle-polygon" };
    Some(Table { title, columns, rows: rows.collect() })
}

/// Whether a corner of the result is the correct one, bit for bit.
fn agrees(state: &Snapshot, index: usize) -> bool {
    let Some(corner) = state.corners.get(index) else { return true };
    let found = state.rounded.get(index).zip(state.attributes.get(index));
    state
        .correct_at(corner.origin)
        .zip(found)
        .is_some_and(|(right, (at, attribute))| right.corner.position == *at && right.attribute == *attribute)
}

/// What each vertex's distances are: a negative one violates the inequality.
pub(super) fn inequalities(state: &Snapshot) -> Table {
    let camera = state.subject.space() == Space::Camera;
    let rows = state.subject.planes().iter().map(|&plane| {
        let distances = state.vertices.map(|vertex| state.distance(plane, vertex.map(f64::from)).1);
        let outside: Vec<_> = (0..3).filter(|&i| distances[i] < 0.0).map(|i| format!("v{i}")).collect();
        let role = if outside.is_empty() { Role::Accepted } else { Role::Rejected };
        let name = if camera { row_word(plane).to_owned() } else { state.inequality(plane) };
        let mut cells: Vec<Value> = distances.map(Value::from).to_vec();
        cells.push(if outside.is_empty() { Value::None } else { Value::text(outside.join(", ")) });
        Row::new(name, cells).role(role).active(state.plane == Some(plane) && !state.over)
    });
    Table {
        title: "clip-triangle-inequalities",
        columns: vec!["v0", "v1", "v2", "column-clip-triangle-outside"],
        rows: rows.collect(),
    }
}

fn row_word(plane: crate::clip::polygon::Plane) -> &'static str {
    use crate::clip::polygon::Plane;
    match plane {
        Plane::Left => "row-clip-triangle-left",
        Plane::Right => "row-clip-triangle-right",
        Plane::Bottom => "row-clip-triangle-bottom",
        Plane::Top => "row-clip-triangle-top",
        Plane::Near => "row-clip-triangle-near",
        Plane::Far => "row-clip-triangle-far",
    }
}

/// What the neighbour computes at the corners on the edges, and how many units in the last place it is
/// away: a crack if there are any.
pub(super) fn neighbours(state: &Snapshot) -> Option<Table> {
    let rounded = !state.subject.settings.arithmetic.is_exact();
    if !state.over || !(rounded || state.subject.settings.mistake == Mistake::WalkOrder) {
        return None;
    }
    let rows: Vec<Row> = state
        .corners
        .iter()
        .zip(&state.rounded)
        .filter_map(|(corner, at)| {
            let there = state.neighbour_at(corner.origin)?.corner.position;
            let apart = at.iter().zip(there).map(|(&a, b)| ulps_between(a, b)).max().unwrap_or(0);
            let mut cells: Vec<Value> = there[..state.dimensions()].iter().map(|&c| c.into()).collect();
            cells.push(Value::Int(i64::try_from(apart).unwrap_or(i64::MAX)));
            let role = if apart == 0 { Role::Accepted } else { Role::Taught };
            Some(Row::new(corner.name.clone(), cells).role(role))
        })
        .collect();
    let mut columns = COLUMNS[..state.dimensions()].to_vec();
    columns.push("column-clip-triangle-ulp");
    (!rows.is_empty()).then_some(Table { title: "clip-triangle-neighbours", columns, rows })
}

/// The correct result, beside one with a mistake or with rounding.
pub(super) fn correct(state: &Snapshot) -> Option<Table> {
    if !state.over || !state.is_taught() {
        return None;
    }
    let rows = state
        .correct
        .corners
        .iter()
        .map(|there| Row::new(state.name(there.corner.origin), state.cells(there)).role(Role::Exact));
    Some(Table { title: "clip-triangle-correct", columns: state.columns(), rows: rows.collect() })
}

/// The vertices in clip space, or where they are clipped.
pub(super) fn vertices(state: &Snapshot) -> Table {
    let size = state.dimensions();
    let rows = (0..3).map(|i| {
        let at = state.vertices[i];
        let mut cells: Vec<Value> = at[..size].iter().map(|&c| c.into()).collect();
        cells.push(state.subject.attribute[i].into());
        Row::new(format!("v{i}"), cells)
    });
    Table { title: "clip-triangle-vertices", columns: state.columns(), rows: rows.collect() }
}
