//! The formulas of the six tests, with the numbers of a step.

use super::{Numbers, Snapshot, Test};
use crate::{
    explain::{Formula, Piece},
    raster::YAxis,
};

fn text(text: &'static str) -> Piece {
    Piece::Text(text)
}

fn number(value: f64) -> Piece {
    Piece::Number(value.into())
}

fn result(value: f64) -> Piece {
    Piece::Result(value.into())
}

/// `(x, y, z)`.
fn vector(v: &[f64], piece: fn(f64) -> Piece) -> impl Iterator<Item = Piece> {
    let pieces = v
        .iter()
        .enumerate()
        .flat_map(move |(i, &value)| [text(if i == 0 { "(" } else { ", " }), piece(value)]);
    pieces.chain([text(")")])
}

fn wide<const N: usize>(p: [f32; N]) -> [f64; N] {
    p.map(f64::from)
}

/// `b - a` as it is shown.
fn edge(a: [f32; 3], b: [f32; 3]) -> [f64; 3] {
    let (a, b) = (wide(a), wide(b));
    [0, 1, 2].map(|i| b[i] - a[i])
}

/// `= a × b = n`.
fn product(general: &'static str, a: [f64; 3], b: [f64; 3], n: &[f64]) -> Formula {
    let mut numbers = vec![text("= ")];
    numbers.extend(vector(&a, number));
    numbers.push(text(" × "));
    numbers.extend(vector(&b, number));
    numbers.push(text(" = "));
    numbers.extend(vector(n, result));
    Formula { general, numbers }
}

/// `= a · b = s`.
fn scalar(general: &'static str, a: [f64; 3], b: &[f64], s: f64) -> Formula {
    let mut numbers = vec![text("= ")];
    numbers.extend(vector(&a, number));
    numbers.push(text(" · "));
    numbers.extend(vector(b, number));
    numbers.extend([text(" = "), result(s)]);
    Formula { general, numbers }
}

/// `= a b − c d = s`.
fn difference(general: &'static str, [a, b, c, d]: [f64; 4], s: f64) -> Formula {
    let numbers = vec![
        text("= "),
        number(a),
        text(" · "),
        number(b),
        text(" − "),
        number(c),
        text(" · "),
        number(d),
        text(" = "),
        result(s),
    ];
    Formula { general, numbers }
}

/// What comes before the value.
pub(super) fn terms(of: &Snapshot, test: Test) -> Vec<Formula> {
    let Some(Numbers { terms, .. }) = &of.numbers[test as usize] else { return Vec::new() };
    let spaces = &of.input.spaces;
    let normal = |general, [p0, p1, p2]: [[f32; 3]; 3]| {
        product(general, edge(p0, p1), edge(p0, p2), terms.get(..3).unwrap_or_default())
    };
    match test {
        Test::Camera => vec![normal("n = (p1 − p0) × (p2 − p0)", spaces.camera)],
        Test::Object => vec![normal("n = (p1 − p0) × (p2 − p0)", spaces.object)],
        Test::Plane => {
            let [a, b, c, d] = [0, 1, 2, 3].map(|i| terms.get(i).copied().unwrap_or_default());
            let p0 = wide(spaces.world[0]);
            let mut numbers = vec![text("= −(")];
            for (i, (factor, at)) in [a, b, c].into_iter().zip(p0).enumerate() {
                let sign = if i == 0 { "" } else { " + " };
                numbers.extend([text(sign), number(factor), text(" · "), number(at)]);
            }
            numbers.extend([text(") = "), result(d)]);
            vec![
                normal("(A, B, C) = (p1 − p0) × (p2 − p0)", spaces.world),
                Formula { general: "D = −(A x0 + B y0 + C z0)", numbers },
            ]
        }
        Test::Ndc => Vec::new(),
        Test::Screen => {
            let p = spaces.screen.map(wide);
            let general = ["a = x0 y1 − x1 y0", "b = x1 y2 − x2 y1", "c = x2 y0 − x0 y2"];
            let pairs = [[0, 1], [1, 2], [2, 0]];
            let each = general.into_iter().zip(pairs).zip(terms);
            each.map(|((general, [i, j]), &s)| difference(general, [p[i][0], p[j][1], p[j][0], p[i][1]], s))
                .collect()
        }
        Test::Determinant => {
            let [_, r1, r2] = rows(of);
            vec![product("m = r1 × r2", r1, r2, terms)]
        }
    }
}

/// The rows (x, y, w).
fn rows(of: &Snapshot) -> [[f64; 3]; 3] {
    of.input.spaces.clip.map(|[x, y, _, w]| wide([x, y, w]))
}

/// What the sign is taken of.
pub(super) fn value(of: &Snapshot, test: Test, s: f64) -> Vec<Formula> {
    let Some(Numbers { terms, .. }) = &of.numbers[test as usize] else { return Vec::new() };
    let spaces = &of.input.spaces;
    let (object, world, camera) = spaces.eyes;
    let seen = |eye: [f32; 4], p0: [f32; 3]| {
        let [x, y, z, w] = eye;
        if w == 0.0 {
            scalar("s = e · n", wide([x, y, z]), terms, s)
        } else {
            scalar("s = (e − p0) · n", edge(p0, [x, y, z]), terms, s)
        }
    };
    match test {
        Test::Camera => vec![seen(camera, spaces.camera[0])],
        Test::Object => object.map(|eye| seen(eye, spaces.object[0])).into_iter().collect(),
        Test::Plane => {
            let [x, y, z, w] = wide(world);
            let parts = if w == 0.0 { 3 } else { 4 };
            let mut numbers = vec![text("= ")];
            for (i, (factor, at)) in terms.iter().zip([x, y, z, w]).take(parts).enumerate() {
                let sign = if i == 0 { "" } else { " + " };
                numbers.extend([text(sign), number(*factor)]);
                if i < 3 {
                    numbers.extend([text(" · "), number(at)]);
                }
            }
            numbers.extend([text(" = "), result(s)]);
            let general = if w == 0.0 { "s = A ex + B ey + C ez" } else { "s = A ex + B ey + C ez + D" };
            vec![Formula { general, numbers }]
        }
        Test::Ndc => {
            let [[x0, y0], [x1, y1], [x2, y2]] = spaces.ndc.map(wide);
            let general = "s = (x1 − x0) (y2 − y0) − (y1 − y0) (x2 − x0)";
            vec![difference(general, [x1 - x0, y2 - y0, y1 - y0, x2 - x0], s)]
        }
        Test::Screen => {
            let (general, half) = match spaces.y_axis {
                YAxis::Down => ("s = −½ (a + b + c)", "= −½ ("),
                YAxis::Up => ("s = ½ (a + b + c)", "= ½ ("),
            };
            let mut numbers = vec![text(half)];
            for (i, &term) in terms.iter().enumerate() {
                numbers.extend([text(if i == 0 { "" } else { " + " }), number(term)]);
            }
            numbers.extend([text(") = "), result(s)]);
            vec![Formula { general, numbers }]
        }
        Test::Determinant => {
            let [r0, ..] = rows(of);
            let volume = vec![text("= "), number(s.abs()), text(" / 6 = "), result(s.abs() / 6.0)];
            vec![
                scalar("s = r0 · m", r0, terms, s),
                Formula { general: "volume of the tetrahedron = |s| / 6", numbers: volume },
            ]
        }
    }
}
