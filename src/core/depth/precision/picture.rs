//! The step of depth over the distance, both in powers of ten.

use super::{Line, Snapshot};
use crate::{
    depth::DepthFormat,
    explain::{Grid, Label, Mark, Role, View},
    message::{Message, Value},
};

/// Points of a curve.
const POINTS: u32 = 96;
/// Steps below this power of ten are not drawn.
const LEAST: f64 = -9.0;

/// Powers of ten.
fn log(x: f64) -> f64 {
    libm::log10(x).max(LEAST)
}

/// From the near to the far plane, from the shortest step to the longest, with room for the words.
pub(super) fn view(state: &Snapshot) -> View {
    let [near, far] = state.line.planes.map(|distance| log(f64::from(distance)) as f32);
    let steps = DepthFormat::ALL.map(|format| curve(&Line { format, ..state.line }));
    let heights = steps.iter().flatten().map(|point| point[1]).chain([log(f64::from(state.gap)) as f32]);
    let low = heights.clone().fold(f32::INFINITY, f32::min);
    let high = heights.fold(f32::NEG_INFINITY, f32::max);
    let margin = 0.06 * (far - near).max(high - low).max(0.5);
    View {
        min: [near - margin, low - margin],
        max: [far + margin, high + margin],
        y_up: true,
        grid: Grid::None,
    }
}

/// The curves of all formats, that in hand as accepted, the gap, and what was looked at.
pub(super) fn mark(state: &Snapshot, out: &mut Vec<Mark>) {
    let [near, far] = state.line.planes;
    let guide = |axis: u8, value: f64, role: Role, name: String| Mark::Guide {
        axis,
        at: log(value) as f32,
        role,
        label: Some(Label::name(name)),
        note: None,
    };
    let mut up = guide(0, near.into(), Role::Neutral, format!("n = {near}"));
    if let Mark::Guide { note, .. } = &mut up {
        *note = Some(Message::new("depth-precision-axis-step"));
    }
    out.push(up);
    out.push(guide(0, far.into(), Role::Neutral, format!("f = {far}")));
    out.push(guide(1, state.gap.into(), Role::Rejected, format!("gap {}", state.gap)));
    // Below the curves, where the axis has its ends.
    let view = view(state);
    out.push(Mark::Text {
        at: [log(far.into()) as f32, view.min[1] + 0.12 * (view.max[1] - view.min[1])],
        label: Label::new("", Value::Word("depth-precision-axis-distance")),
        role: Role::Candidate,
        big: false,
    });
    for format in DepthFormat::ALL {
        let own = format == state.line.format;
        let role = if own { Role::Accepted } else { Role::Candidate };
        let points = curve(&Line { format, ..state.line });
        out.push(Mark::Curve { points, role, label: Some(Label::name(format.name())) });
    }
    let at = |place: u32| {
        let cell = state.line.cell(place);
        let [begin, end] = cell.distances();
        [log((begin + end) / 2.0) as f32, log(cell.length()) as f32]
    };
    for place in state.left.iter().flatten() {
        out.push(Mark::Point { at: at(*place), role: Role::Candidate, label: None });
    }
    if let Some(place) = state.found.or(state.look.map(|look| look.place)) {
        let label = Some(Label::name(format!("{}", state.line.code(place))));
        out.push(Mark::Point { at: at(place), role: Role::Active, label });
    }
    if let Some(place) = state.found {
        let [begin, _] = state.line.cell(place).distances();
        let name = format!("{}", (begin * 1000.0).round() / 1000.0);
        out.push(guide(0, begin, Role::Active, name));
    }
}

/// The step at distances in equal ratios.
fn curve(line: &Line) -> Vec<[f32; 2]> {
    let [near, far] = line.planes.map(|distance| log(f64::from(distance)));
    let point = |i: u32| {
        let x = near + (far - near) * f64::from(i) / f64::from(POINTS);
        let distance = libm::exp10(x).clamp(f64::from(line.planes[0]), f64::from(line.planes[1]));
        // The last stretch is cut in half by the far plane.
        let place = line.place_of(distance).clamp(1, line.last() - 1);
        [x as f32, log(line.cell(place).length()) as f32]
    };
    (0..=POINTS).map(point).collect()
}
