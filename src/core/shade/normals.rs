//! Normals: through a model matrix, and of a mesh that has none.
//!
//! *Source:* Turkowski, Transformations of Surface Normal Vectors, 1990 (the inverse transpose);
//! Gouraud, Continuous Shading of Curved Surfaces, 1971 (the mean of the faces around a vertex).
//! Deviations: cofactors in place of the inverse, so that nothing is divided and a flattened object
//! still has a normal; faces count by their area.

use crate::{scene::Mesh, transform::Matrix};

/// The inverse transpose of a matrix's linear part times the size of its determinant: normals have any
/// length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalMatrix {
    /// Row by row.
    rows: [[f64; 3]; 3],
}

impl NormalMatrix {
    /// The cofactors in binary64: products are exact, each difference is rounded once. Turned around
    /// where the matrix mirrors, as the inverse would be.
    pub fn new(model: &Matrix) -> Self {
        let at = |row: usize, column: usize| f64::from(model[4 * column + row]);
        let minor = |row: usize, column: usize| {
            let ([a, b], [c, d]) = (others(row), others(column));
            at(a, c) * at(b, d) - at(a, d) * at(b, c)
        };
        let cofactors = [0, 1, 2].map(|row| [0, 1, 2].map(|column| minor(row, column)));
        let determinant = (0..3).map(|column| at(0, column) * cofactors[0][column]).sum::<f64>();
        let sign = if determinant < 0.0 { -1.0 } else { 1.0 };
        Self { rows: cofactors.map(|row| row.map(|entry| sign * entry)) }
    }

    /// The matrix's own linear part: right for points, wrong for normals unless it only turns and moves.
    pub fn mistaken(model: &Matrix) -> Self {
        Self { rows: [0, 1, 2].map(|row| [0, 1, 2].map(|column| f64::from(model[4 * column + row]))) }
    }

    /// A normal in world space, of any length: summed in binary64, rounded once. What leaves binary32 is
    /// the largest number.
    pub fn apply(&self, normal: [f32; 3]) -> [f32; 3] {
        let [x, y, z] = normal.map(f64::from);
        let limit = f64::from(f32::MAX);
        self.rows.map(|[a, b, c]| (a * x + b * y + c * z).clamp(-limit, limit) as f32 + 0.0)
    }

    /// Its entries, row by row.
    pub fn rows(&self) -> [[f64; 3]; 3] {
        self.rows
    }
}

/// The two other indices, in the order that gives a cofactor its sign.
fn others(index: usize) -> [usize; 2] {
    [(index + 1) % 3, (index + 2) % 3]
}

/// One normal for each vertex: the sum of the normals of the faces around it, which are as long as twice
/// their area. Zero for a vertex of no face. In binary64, rounded once; linear in the mesh.
pub fn smooth_normals(mesh: &Mesh) -> Vec<[f32; 3]> {
    let mut sums = vec![[0.0_f64; 3]; mesh.positions.len()];
    for triangle in &mesh.triangles {
        let corners = triangle.map(|i| mesh.positions[i as usize]);
        let normal = face_normal(corners);
        for i in triangle {
            let sum = &mut sums[*i as usize];
            *sum = [0, 1, 2].map(|axis| sum[axis] + normal[axis]);
        }
    }
    // Any length will do: scaled by the largest part, so that none leaves binary32.
    sums.iter()
        .map(|sum| {
            let largest = sum.iter().fold(0.0_f64, |largest, c| largest.max(c.abs()));
            if largest > 0.0 { sum.map(|c| (c / largest) as f32) } else { [0.0; 3] }
        })
        .collect()
}

/// `(b - a) x (c - a)` in binary64.
pub(crate) fn face_normal([a, b, c]: [[f32; 3]; 3]) -> [f64; 3] {
    let side = |to: [f32; 3]| [0, 1, 2].map(|axis| f64::from(to[axis]) - f64::from(a[axis]));
    let ([ux, uy, uz], [vx, vy, vz]) = (side(b), side(c));
    [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx]
}
