//! Triangles on the screen, with and without depths.

use super::{Family, Random};

/// The families that triangles on the screen have.
pub const FAMILIES: &[Family] = &[
    Family::Ordinary,
    Family::Beside,
    Family::NearlyParallel,
    Family::Sliver,
    Family::Huge,
    Family::Denormal,
    Family::Long,
];

const SIDE: u32 = 96;

/// x and y of three vertices, in pixels.
pub type Triangle = [[f32; 2]; 3];

/// Columns and rows of the image that a family is for.
pub fn size(family: Family) -> [u32; 2] {
    if family == Family::Long { [32, 4_096] } else { [SIDE; 2] }
}

/// Triangles in the image of [`size`], but for what the family is about.
pub fn triangles(family: Family, count: usize) -> Vec<Triangle> {
    let mut random = Random::new(300 + family as u64);
    (0..count).map(|_| triangle(family, &mut random)).collect()
}

/// The same triangles with depths from 0 to 1.
pub fn with_depths(family: Family, count: usize) -> Vec<[[f32; 3]; 3]> {
    let mut random = Random::new(400 + family as u64);
    let deep = |flat: Triangle| flat.map(|[x, y]| [x, y, random.uniform(0.0, 1.0)]);
    triangles(family, count).into_iter().map(deep).collect()
}

fn triangle(family: Family, random: &mut Random) -> Triangle {
    let [width, height] = size(family).map(f64::from);
    let mut vertices: Triangle =
        std::array::from_fn(|_| [random.uniform(0.0, width), random.uniform(0.0, height)]);
    match family {
        Family::Beside => {
            vertices = vertices.map(|vertex| vertex.map(|x| random.beside(x.floor() + 0.5)));
        }
        // One side along a row of centres, but for next to nothing.
        Family::NearlyParallel => {
            let row = vertices[0][1].floor() + 0.5;
            for vertex in &mut vertices[..2] {
                vertex[1] = random.beside(row) + random.uniform(-1e-6, 1e-6);
            }
        }
        // Along a diagonal through centres: elsewhere hardly one covers a pixel.
        Family::Sliver => {
            let start = vertices[0].map(|x| x.floor() + 0.5);
            let length = random.uniform(8.0, 64.0).floor();
            let along = [length * random.pick(&[-1.0, 1.0]), length];
            let t = random.uniform(0.2, 0.8);
            vertices = [0.0, 1.0, t].map(|t| [0, 1].map(|i| start[i] + t * along[i]));
            vertices[2] = vertices[2].map(|x| random.beside(x));
        }
        // One vertex stays in the image.
        Family::Huge => {
            vertices[1] = [0, 1].map(|_| random.magnitude(20.0, 38.0));
            vertices[2] = [0, 1].map(|i| -vertices[1][i] * random.uniform(0.5, 2.0));
        }
        // Around the image's corner, but for next to nothing.
        Family::Denormal => {
            vertices[0] = [0, 1].map(|_| random.magnitude(-44.0, -38.0));
            let d = random.uniform(0.5, 1.0) * width as f32;
            vertices[1] = [d, d + random.magnitude(-44.0, -38.0)];
        }
        Family::Long => {
            vertices[0][1] = random.uniform(0.0, 8.0);
            vertices[2][1] = random.uniform(height - 8.0, height);
        }
        _ => {}
    }
    vertices
}
