//! The drawing of layers over a pixel: the layers in a row, below them what the pixel held and holds.

use super::{Order, Snapshot};
use crate::{
    explain::{Label, Mark, Role},
    interpolate::unorm,
};
use std::sync::Arc;

/// Width and height of a swatch, and from one to the next.
const SWATCH: [usize; 2] = [5, 3];
const STEP: [usize; 2] = [7, 6];
/// Left and above the first swatch.
const MARGIN: usize = 1;

/// Width and height of the drawing.
pub(super) fn size(layers: usize) -> [usize; 2] {
    [MARGIN + (layers + 1) * STEP[0], MARGIN + 2 * STEP[1]]
}

/// Codes as they stand below a swatch: red, green, blue, alpha.
pub(super) fn codes([r, g, b, a]: [u8; 4]) -> String {
    format!("({r}, {g}, {b}, {a})")
}

/// One swatch: its column and row, its colour, and what it is called.
struct Swatch {
    at: [usize; 2],
    color: [u8; 4],
    role: Role,
    name: String,
    lines: Vec<String>,
}

/// What is known so far.
pub(super) fn mark(state: &Snapshot, out: &mut Vec<Mark>) {
    let size = size(state.layers.len());
    let swatches = swatches(state);
    let mut rgba = vec![0; 4 * size[0] * size[1]];
    for swatch in &swatches {
        let [x, y] = corner(swatch.at);
        let [r, g, b, _] = swatch.color;
        for row in y..y + SWATCH[1] {
            for column in x..x + SWATCH[0] {
                let index = 4 * (row * size[0] + column);
                rgba[index..index + 4].copy_from_slice(&[r, g, b, 255]);
            }
        }
    }
    out.push(Mark::Image { size, rgba: Arc::new(rgba) });
    arrows(state, out);
    for swatch in swatches {
        let [left, top] = corner(swatch.at).map(|n| n as f32);
        let [right, bottom] = [left + SWATCH[0] as f32, top + SWATCH[1] as f32];
        let points = vec![[left, top], [right, top], [right, bottom], [left, bottom], [left, top]];
        out.push(Mark::Curve { points, role: swatch.role, label: None });
        let name = std::iter::once(&swatch.name).filter(|name| !name.is_empty());
        for line in name.chain(&swatch.lines) {
            let at = [left, bottom + 0.25];
            out.push(Mark::Text { at, label: Label::name(line), role: Role::Neutral, big: false });
        }
    }
}

/// The upper left corner of a swatch.
fn corner([column, row]: [usize; 2]) -> [usize; 2] {
    [MARGIN + column * STEP[0], MARGIN + row * STEP[1]]
}

/// The layers in the order in which they are blended, and the pixel before and after each.
fn swatches(state: &Snapshot) -> Vec<Swatch> {
    let mut all = Vec::new();
    for (place, &index) in state.list.iter().enumerate() {
        let layer = state.layers[usize::from(index)];
        let compared = state.compared.is_some_and(|at| [at, at + 1].contains(&(place as u8)));
        let role = if state.layer == Some(index) {
            Role::Active
        } else if compared {
            Role::Changed
        } else {
            Role::Neutral
        };
        let mut lines = vec![format!("α {}", layer.color[3])];
        if state.settings.order == Order::Sorted {
            lines.push(format!("z {}", layer.depth));
        }
        all.push(Swatch {
            at: [place + 1, 0],
            color: layer.color.map(|channel| unorm(channel, 255) as u8),
            role,
            name: state.names[usize::from(index)].clone(),
            lines,
        });
    }
    let pixel = |column: usize, color: [u8; 4], role: Role| {
        let [r, g, b, a] = color;
        let lines = vec![format!("{r} {g} {b}"), format!("α {a}")];
        Swatch { at: [column, 1], color, role, name: String::new(), lines }
    };
    let after = &state.result.after;
    all.push(pixel(0, state.settings.codes(), Role::Neutral));
    for (place, (_, color)) in after.iter().enumerate() {
        let last = place + 1 == after.len();
        all.push(pixel(place + 1, *color, if last { Role::Active } else { Role::Neutral }));
    }
    all
}

/// From what was there and from the layer to what is there then.
fn arrows(state: &Snapshot, out: &mut Vec<Mark>) {
    let done = state.result.after.len();
    let started = usize::from(state.layer.is_some() && state.result.after.last().map(|a| a.0) != state.layer);
    for place in 1..=done + started {
        let role = if place == done + started { Role::Active } else { Role::Neutral };
        let [x, y] = corner([place, 1]).map(|n| n as f32);
        let middle = y + SWATCH[1] as f32 / 2.0;
        let gap = (STEP[0] - SWATCH[0]) as f32;
        let lines = [
            [[x - gap, middle], [x, middle]],
            [[x + SWATCH[0] as f32 - 0.5, y - 3.0], [x + SWATCH[0] as f32 - 0.5, y]],
        ];
        out.extend(lines.map(|ends| Mark::Segment { ends, role, label: None }));
    }
}
