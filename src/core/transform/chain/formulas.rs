//! The formulas of the transform chain, with the numbers of a step.

use super::Snapshot;
use crate::{explain::Piece, message::Value, raster::YAxis, transform::DepthRange};

pub(super) fn text(text: &'static str) -> Piece {
    Piece::Text(text)
}

fn number(value: Value) -> Piece {
    Piece::Number(value)
}

/// A row's formula, without its result.
pub(super) fn product_formula(row: [f32; 4], v: [Value; 4], i: usize) -> (&'static str, Vec<Piece>) {
    let mut numbers = vec![text("= ")];
    for (factor, component) in row.into_iter().zip(v) {
        if numbers.len() > 1 {
            numbers.push(text(" + "));
        }
        numbers.extend([number(factor.into()), text(" · "), number(component)]);
    }
    let general = [
        "x′ = m11 · x + m12 · y + m13 · z + m14 · w",
        "y′ = m21 · x + m22 · y + m23 · z + m24 · w",
        "z′ = m31 · x + m32 · y + m33 · z + m34 · w",
        "w′ = m41 · x + m42 · y + m43 · z + m44 · w",
    ];
    (general[i], numbers)
}

/// The divide's formula for component `i`, without its result.
pub(super) fn divide_formula([x, y, z, w]: [Value; 4], i: usize) -> (&'static str, Vec<Piece>) {
    let (general, above) = match i {
        0 => ("x″ = x′ / w", x),
        1 => ("y″ = y′ / w", y),
        2 => ("z″ = z′ / w", z),
        _ => ("r = 1 / w", Value::Int(1)),
    };
    (general, vec![text("= "), number(above), text(" / "), number(w)])
}

impl Snapshot {
    /// The viewport's formula for component `i`, without its result.
    pub(super) fn viewport_formula(&self, [x, y, z, r]: [Value; 4], i: usize) -> (&'static str, Vec<Piece>) {
        let viewport = &self.chain.viewport;
        let [width, height] = viewport.size.map(Value::from);
        match i {
            0 => (
                "x‴ = W / 2 · (x″ + 1)",
                vec![text("= "), number(width), text(" / 2 · ("), number(x), text(" + 1)")],
            ),
            1 if viewport.y_axis == YAxis::Down => (
                "y‴ = H / 2 · (1 − y″)",
                vec![text("= "), number(height), text(" / 2 · (1 − "), number(y), text(")")],
            ),
            1 => (
                "y‴ = H / 2 · (y″ + 1)",
                vec![text("= "), number(height), text(" / 2 · ("), number(y), text(" + 1)")],
            ),
            2 if viewport.depth_range == DepthRange::ZeroToOne => ("z‴ = z″", vec![text("= "), number(z)]),
            2 => ("z‴ = (z″ + 1) / 2", vec![text("= ("), number(z), text(" + 1) / 2")]),
            _ => ("r‴ = r", vec![text("= "), number(r)]),
        }
    }
}
