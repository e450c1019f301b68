//! A shape grown a little, for its outline: three ways to move its vertices outwards.
//!
//! *Source:* McReynolds and Blythe, Advanced Graphics Programming Using OpenGL, 2005, sections 16.7.2
//! and 16.7.3. Deviation: vertices at one place move together, so that a model with several normals there
//! does not open; a mesh that names its own normals moves along those.

use crate::{
    scene::Mesh,
    transform::{Matrix, matrices::row_times},
};
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;

/// Where vertices move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Way {
    /// Away from the mean of all vertices, in object space: the distance times a factor. What bends
    /// inwards moves inwards.
    Scale,
    /// Along the normal, in object space: the same distance everywhere, less on the screen farther away.
    Normals,
    /// Along the normal as the screen sees it: the same number of pixels everywhere.
    Pixels,
}

impl Way {
    /// In the order of the lecture: nothing, a distance, a distance on the screen.
    pub const ALL: [Self; 3] = [Self::Scale, Self::Normals, Self::Pixels];
}

/// A way, and how far: a factor, a distance in object space, or a number of pixels. Finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enlarge {
    /// Where vertices move.
    pub way: Way,
    /// How far.
    pub amount: f32,
}

impl Enlarge {
    /// The vertices in object space after it, in binary64 and rounded once; by [`Way::Pixels`] they stay
    /// where they are.
    pub fn positions(self, mesh: &Mesh) -> Vec<[f32; 3]> {
        let wide = mesh.positions.iter().map(|p| wide(*p));
        let amount = f64::from(self.amount);
        let narrow = |p: DVec3| p.to_array().map(|c| c as f32);
        match self.way {
            Way::Scale => {
                let centroid = wide.clone().sum::<DVec3>() / mesh.positions.len().max(1) as f64;
                wide.map(|p| narrow(centroid + amount * (p - centroid))).collect()
            }
            Way::Normals => wide.zip(normals(mesh)).map(|(p, n)| narrow(p + amount * n)).collect(),
            Way::Pixels => mesh.positions.clone(),
        }
    }

    /// The vertices in clip space after it, by [`Way::Pixels`]; the other ways leave them.
    ///
    /// `matrix` leads from object to clip space, `size` is the image's in pixels. A point at (x, y, w)
    /// moves on the screen along (w dx - x dw, w dy - y dw) if it moves along d in clip space. Where that
    /// is zero or w is not positive, the vertex stays. In binary64, rounded once.
    pub fn clip(self, mesh: &Mesh, matrix: &Matrix, size: [u32; 2], clip: &mut [[f32; 4]]) {
        if self.way != Way::Pixels {
            return;
        }
        let half = DVec2::from_array(size.map(|side| f64::from(side) / 2.0));
        for (point, normal) in clip.iter_mut().zip(normals(mesh)) {
            let [x, y, _, w] = point.map(f64::from);
            let n = normal.to_array().map(|c| c as f32);
            let [dx, dy, dw] = [0, 1, 3].map(|i| f64::from(row_times(matrix, i, [n[0], n[1], n[2], 0.0])));
            let along = DVec2::new(w * dx - x * dw, w * dy - y * dw) * half;
            if along.length() > 0.0 && w > 0.0 {
                let moved = along.normalize() * f64::from(self.amount) / half * w;
                (point[0], point[1]) = ((x + moved.x) as f32, (y + moved.y) as f32);
            }
        }
    }
}

fn wide(p: [f32; 3]) -> DVec3 {
    DVec3::from_array(p.map(f64::from))
}

/// A unit normal at each vertex, zero where there is none: the mesh's own, else that of the faces around
/// it, each weighted by its area.
fn normals(mesh: &Mesh) -> Vec<DVec3> {
    if !mesh.normals.is_empty() {
        return mesh.normals.iter().map(|n| wide(*n).normalize_or_zero()).collect();
    }
    let place = |i: u32| mesh.positions[i as usize].map(|c| (c + 0.0).to_bits());
    let mut sums: HashMap<[u32; 3], DVec3> = HashMap::new();
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|i| wide(mesh.positions[i as usize]));
        for i in triangle {
            *sums.entry(place(*i)).or_default() += (b - a).cross(c - a);
        }
    }
    let at = |i: u32| sums.get(&place(i)).copied().unwrap_or_default().normalize_or_zero();
    (0..mesh.positions.len() as u32).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transform::matrices::IDENTITY;

    fn square() -> Mesh {
        let positions = vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
        let normals = vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [3.0, 4.0, 0.0], [0.0, 0.0, 2.0]];
        Mesh { normals, triangles: vec![[0, 1, 2], [0, 2, 3]], ..Mesh::soup(positions, [1.0; 4]) }
    }

    #[test]
    fn scaling_keeps_the_centroid() {
        let enlarge = Enlarge { way: Way::Scale, amount: 2.0 };
        let expected = [[-1.0, -1.0, 0.0], [3.0, -1.0, 0.0], [3.0, 3.0, 0.0], [-1.0, 3.0, 0.0]];
        assert_eq!(enlarge.positions(&square()), expected);
    }

    #[test]
    fn normals_of_any_length_move_by_the_distance() {
        let enlarge = Enlarge { way: Way::Normals, amount: 5.0 };
        let moved = enlarge.positions(&square());
        assert_eq!(moved[2..], [[5.0, 6.0, 0.0], [0.0, 2.0, 5.0]]);
        let without = Mesh { normals: Vec::new(), ..square() };
        assert!(enlarge.positions(&without).iter().all(|p| p[2] == 5.0), "a flat shape moves as a whole");
    }

    #[test]
    fn pixels_are_the_same_number_at_every_distance() {
        let enlarge = Enlarge { way: Way::Pixels, amount: 5.0 };
        let mut clip = [[0.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.5, 4.0], [0.0, 0.0, 0.5, 4.0], [0.0; 4]];
        enlarge.clip(&square(), &IDENTITY, [200, 100], &mut clip);
        let [x, y, _, w] = clip[2];
        // The normal (3, 4) is (3 * 100, 4 * 50) on the screen, of length 360.6.
        let moved = [x / w * 100.0, y / w * 50.0];
        assert!((moved[0] - 4.160_25).abs() < 1e-5 && (moved[1] - 2.773_5).abs() < 1e-5, "{moved:?}");
        assert_eq!(clip[3], [0.0; 4], "no direction on the screen");
    }
}
