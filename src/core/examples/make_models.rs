//! Makes the models in `assets/models` again, bit for bit.
//!
//! ```sh
//! cargo run -p rasterscope-core --example make_models
//! ```
//!
//! All of them fit into a sphere of radius 2 about the origin, stand upright (y up) and turn
//! counter-clockwise outside. Portable functions and four decimals make the files the same on every
//! machine.

use std::{collections::HashMap, f64::consts::TAU, fmt::Write, fs, io, path::Path};

type Point = [f64; 3];

fn main() -> io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/models");
    for (file, text) in models() {
        fs::write(folder.join(file), text)?;
    }
    Ok(())
}

fn models() -> [(&'static str, String); 5] {
    [
        ("cube.obj", cube()),
        ("tetrahedron.obj", tetrahedron()),
        ("icosphere.obj", icosphere(2)),
        ("pawn.obj", pawn(32)),
        ("trefoil.obj", trefoil(120, 10)),
    ]
}

/// Positions and faces; a corner is the number of its position, counted from 0.
#[derive(Default)]
struct Solid {
    positions: Vec<Point>,
    faces: Vec<Vec<usize>>,
}

impl Solid {
    fn obj(&self, what: &str) -> String {
        let mut text = head(what);
        for p in &self.positions {
            line(&mut text, "v", p);
        }
        for face in &self.faces {
            text.push('f');
            for corner in face {
                put(&mut text, format_args!(" {}", corner + 1));
            }
            text.push('\n');
        }
        text
    }

    /// Bands of quads between neighbouring rows of `columns` positions each; a band behind the last
    /// row leads back to the first.
    fn wrap(&mut self, bands: usize, rows: usize, columns: usize) {
        let at = |i: usize, j: usize| (i % rows) * columns + j % columns;
        for i in 0..bands {
            for j in 0..columns {
                self.faces.push(vec![at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)]);
            }
        }
    }
}

fn head(what: &str) -> String {
    format!("# {what}\n# Made by src/core/examples/make_models.rs\n")
}

fn put(text: &mut String, piece: std::fmt::Arguments<'_>) {
    text.write_fmt(piece).unwrap_or(()); // writing to a String cannot fail
}

/// A statement with numbers of at most four decimals.
fn line(text: &mut String, keyword: &str, numbers: &[f64]) {
    text.push_str(keyword);
    for x in numbers {
        let rounded = format!("{x:.4}");
        let short = rounded.trim_end_matches('0').trim_end_matches('.');
        put(text, format_args!(" {}", if short == "-0" { "0" } else { short }));
    }
    text.push('\n');
}

/// Side 2, six quads, each with the whole unit square as texture coordinates.
fn cube() -> String {
    let mut text = head("A cube of side 2: six quads with texture coordinates");
    for i in 0..8 {
        let side = |bit: u32| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
        line(&mut text, "v", &[side(0), side(1), side(2)]);
    }
    for uv in [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]] {
        line(&mut text, "vt", &uv);
    }
    for (side, corners) in [
        ("front", [5, 6, 8, 7]),
        ("right", [6, 2, 4, 8]),
        ("back", [2, 1, 3, 4]),
        ("left", [1, 5, 7, 3]),
        ("top", [7, 8, 4, 3]),
        ("bottom", [1, 2, 6, 5]),
    ] {
        put(&mut text, format_args!("g {side}\nf"));
        for (i, corner) in corners.into_iter().enumerate() {
            put(&mut text, format_args!(" {corner}/{}", i + 1));
        }
        text.push('\n');
    }
    text
}

/// Four alternate corners of the cube, each in a colour of its own.
fn tetrahedron() -> String {
    let mut text = head("A tetrahedron: the smallest closed mesh, with a colour for each vertex");
    for (p, color) in [
        ([1.0, 1.0, 1.0], [0.3059, 0.4863, 0.651]),
        ([-1.0, -1.0, 1.0], [0.7686, 0.5882, 0.3529]),
        ([-1.0, 1.0, -1.0], [0.549, 0.4196, 0.6588]),
        ([1.0, -1.0, -1.0], [0.4353, 0.5804, 0.3765]),
    ] {
        line(&mut text, "v", &[p, color].concat());
    }
    for face in ["1 3 2", "1 2 4", "1 4 3", "2 3 4"] {
        put(&mut text, format_args!("f {face}\n"));
    }
    text
}

fn unit([x, y, z]: Point) -> Point {
    let length = libm::sqrt(x * x + y * y + z * z);
    [x / length, y / length, z / length]
}

/// An icosahedron whose triangles are split in four `times` times, on the sphere of radius 1.5.
fn icosphere(times: usize) -> String {
    let golden = (1.0 + libm::sqrt(5.0)) / 2.0;
    let mut points: Vec<Point> = Vec::new();
    for turn in 0..3 {
        for (a, b) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
            let mut p = [0.0; 3];
            p[turn] = a;
            p[(turn + 1) % 3] = b;
            points.push(unit(p));
        }
    }
    // Three points are a face if all are neighbours: 63.4 degrees apart.
    let near = |a: usize, b: usize| (0..3).map(|i| points[a][i] * points[b][i]).sum::<f64>() > 0.4;
    let mut faces = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(c, a) {
                    let [u, v, w] = [points[a], points[b], points[c]];
                    let outside = u[0] * (v[1] * w[2] - v[2] * w[1])
                        + u[1] * (v[2] * w[0] - v[0] * w[2])
                        + u[2] * (v[0] * w[1] - v[1] * w[0]);
                    faces.push(if outside > 0.0 { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    for _ in 0..times {
        let mut middles = HashMap::new();
        let mut split = Vec::new();
        for [a, b, c] in faces {
            let mut middle = |a: usize, b: usize| {
                *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                    points.push(unit([0, 1, 2].map(|i| points[a][i] + points[b][i])));
                    points.len() - 1
                })
            };
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            split.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
        }
        faces = split;
    }
    let positions = points.into_iter().map(|p| p.map(|x| 1.5 * x)).collect();
    let solid = Solid { positions, faces: faces.into_iter().map(Vec::from).collect() };
    solid.obj("A sphere: an icosahedron whose triangles were split in four twice")
}

/// A chess pawn turned on a lathe; its ends are fans about the axis.
fn pawn(columns: usize) -> String {
    // Radius and height, from the foot to the head.
    const PROFILE: [[f64; 2]; 17] = [
        [0.9, -1.6],
        [0.95, -1.4],
        [0.75, -1.2],
        [0.7, -1.1],
        [0.5, -0.9],
        [0.36, -0.4],
        [0.28, 0.2],
        [0.3, 0.4],
        [0.55, 0.5],
        [0.55, 0.6],
        [0.3, 0.66],
        [0.44, 0.82],
        [0.52, 1.02],
        [0.52, 1.18],
        [0.44, 1.38],
        [0.26, 1.54],
        [0.1, 1.6],
    ];
    let mut solid = Solid::default();
    for [radius, y] in PROFILE {
        for j in 0..columns {
            let angle = TAU * j as f64 / columns as f64;
            solid.positions.push([radius * libm::cos(angle), y, -radius * libm::sin(angle)]);
        }
    }
    solid.wrap(PROFILE.len() - 1, PROFILE.len(), columns);
    let foot = solid.positions.len();
    solid.positions.extend([[0.0, -1.6, 0.0], [0.0, 1.62, 0.0]]);
    let last = (PROFILE.len() - 1) * columns;
    for j in 0..columns {
        let next = (j + 1) % columns;
        solid.faces.push(vec![foot, next, j]);
        solid.faces.push(vec![foot + 1, last + j, last + next]);
    }
    solid.obj("A chess pawn, turned on a lathe")
}

/// A tube along the trefoil knot; `columns` points about each of `rows` points of the knot.
fn trefoil(rows: usize, columns: usize) -> String {
    const TUBE: f64 = 0.26;
    let knot = |t: f64| -> Point {
        let r = 1.0 + 0.45 * libm::cos(3.0 * t);
        [r * libm::cos(2.0 * t), r * libm::sin(2.0 * t), 0.5 * libm::sin(3.0 * t)]
    };
    let mut solid = Solid::default();
    for i in 0..rows {
        let t = TAU * i as f64 / rows as f64;
        let (p, before, after) = (knot(t), knot(t - 1e-3), knot(t + 1e-3));
        let along = unit([0, 1, 2].map(|k| after[k] - before[k]));
        // Away from the knot's axis, made perpendicular to the knot.
        let out = unit([p[0], p[1], 0.0]);
        let dot: f64 = (0..3).map(|k| out[k] * along[k]).sum();
        let normal = unit([0, 1, 2].map(|k| out[k] - dot * along[k]));
        let binormal = [(1, 2), (2, 0), (0, 1)].map(|(a, b)| along[a] * normal[b] - along[b] * normal[a]);
        for j in 0..columns {
            let angle = TAU * j as f64 / columns as f64;
            let (c, s) = (TUBE * libm::cos(angle), TUBE * libm::sin(angle));
            solid.positions.push([0, 1, 2].map(|k| p[k] + c * normal[k] + s * binormal[k]));
        }
    }
    solid.wrap(rows, rows, columns);
    solid.obj("A trefoil knot")
}

#[cfg(test)]
mod tests {
    use super::models;
    use rasterscope_core::scene::{MODELS, model};

    #[test]
    fn the_models_are_what_this_makes() {
        for (file, text) in models() {
            assert_eq!(model(file), Some(text.as_bytes()), "{file}");
        }
        assert_eq!(MODELS.len(), models().len());
    }
}
