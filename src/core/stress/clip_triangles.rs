//! Triangles in clip space.

use super::{Family, Random};

/// The families that triangles in clip space have.
pub const FAMILIES: &[Family] = &[
    Family::Ordinary,
    Family::Beside,
    Family::NearlyParallel,
    Family::NearWZero,
    Family::Sliver,
    Family::Huge,
    Family::Denormal,
];

/// x, y, z and w of clip space.
pub type Vertex = [f32; 4];

/// Triangles with vertices in and around the view volume, but for what the family is about.
pub fn clip_triangles(family: Family, count: usize) -> Vec<[Vertex; 3]> {
    let mut random = Random::new(200 + family as u64);
    (0..count).map(|_| triangle(family, &mut random)).collect()
}

fn triangle(family: Family, random: &mut Random) -> [Vertex; 3] {
    let mut vertices: [Vertex; 3] = std::array::from_fn(|_| {
        let w = random.uniform(0.5, 3.0);
        let reach = 2.0 * f64::from(w);
        let [x, y, z] = std::array::from_fn(|_| random.uniform(-reach, reach));
        [x, y, z, w]
    });
    for vertex in &mut vertices {
        let w = vertex[3];
        match family {
            Family::Beside => {
                let axis = random.below(3);
                let border = random.pick(&[w, -w]);
                vertex[axis] = random.beside(border);
            }
            Family::NearWZero => vertex[3] = random.magnitude(-8.0, 0.0),
            Family::Huge => *vertex = vertex.map(|x| x * random.magnitude(20.0, 37.0).abs()),
            Family::Denormal => *vertex = vertex.map(|x| x * 1e-39),
            _ => {}
        }
    }
    // One side nearly in a plane of the volume.
    if family == Family::NearlyParallel {
        let axis = random.below(2);
        for vertex in &mut vertices[..2] {
            let w = vertex[3];
            vertex[axis] = random.beside(w) + w * random.uniform(-1e-6, 1e-6);
        }
    }
    if family == Family::Sliver {
        let [a, b, _] = vertices;
        let t = random.uniform(0.2, 0.8);
        vertices[2] = std::array::from_fn(|i| random.beside(a[i] + t * (b[i] - a[i])));
    }
    vertices
}
