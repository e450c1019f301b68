//! Soups of equilateral triangles, and a mesh.

use super::SIZE;
use crate::random::Random;

/// Triangles one after another.
#[derive(Clone, Default)]
pub struct Soup {
    /// Three vertices a triangle: x and y in pixels, depth in 0..1.
    pub positions: Vec<[f32; 3]>,
    /// One colour a triangle: red, green, blue, alpha; none is 0.
    pub colors: Vec<u32>,
}

impl Soup {
    /// Takes one more triangle.
    pub fn push(&mut self, triangle: [[f32; 3]; 3]) {
        self.positions.extend(triangle);
        let code = (self.colors.len() as u32 + 1).wrapping_mul(0x9E_3779);
        self.colors.push(code | 0xFF00_0000);
    }

    /// The triangles with their colours.
    pub fn triangles(&self) -> impl Iterator<Item = ([[f32; 3]; 3], u32)> {
        self.positions.as_chunks().0.iter().copied().zip(self.colors.iter().copied())
    }
}

#[derive(Clone, Copy)]
pub enum Order {
    Random,
    BackToFront,
    FrontToBack,
}

#[derive(Clone, Copy)]
pub struct Workload {
    pub name: &'static str,
    pub edge: f64,
    pub count: usize,
    pub order: Order,
}

const fn soup(name: &'static str, edge: f64, count: usize, order: Order) -> Workload {
    Workload { name, edge, count, order }
}

/// Edge length in pixels and number of triangles; the last is a mesh of that edge length.
pub const ALL: [Workload; 8] = [
    soup("L=3", 3.0, 400_000, Order::Random),
    soup("L=10", 10.0, 200_000, Order::Random),
    soup("L=30", 30.0, 40_000, Order::Random),
    soup("L=100", 100.0, 5_000, Order::Random),
    soup("L=500", 500.0, 300, Order::Random),
    soup("b2f 100", 100.0, 5_000, Order::BackToFront),
    soup("f2b 100", 100.0, 5_000, Order::FrontToBack),
    soup("mesh", 8.0, 0, Order::Random),
];

impl Workload {
    /// Wholly inside the image, for not everybody clips; turned at random, nearly parallel to the screen. The
    /// vertices are multiples of 2^-20 pixel, which most binary32 coordinates here are anyway.
    pub fn soup(&self) -> Soup {
        let mut soup = Soup::default();
        if self.count == 0 {
            mesh(self.edge, 1).into_iter().for_each(|triangle| soup.push(triangle));
            return soup;
        }
        let mut random = Random::new(self.edge as u64);
        let radius = self.edge / 3_f64.sqrt();
        let mut triangles: Vec<_> = (0..self.count)
            .map(|_| {
                let [x, y] = [(); 2].map(|()| random.uniform(radius + 1.0, SIZE as f64 - 1.0 - radius));
                let turn = random.uniform(0.0, std::f64::consts::TAU);
                let depth = random.uniform(0.05, 0.95);
                let triangle = [0.0, 1.0, 2.0].map(|corner| {
                    let angle = turn + corner * std::f64::consts::TAU / 3.0;
                    let z = depth + random.uniform(-0.01, 0.01);
                    [grid(x + radius * angle.cos()), grid(y + radius * angle.sin()), z as f32]
                });
                (depth, triangle)
            })
            .collect();
        match self.order {
            Order::Random => {}
            Order::FrontToBack => triangles.sort_by(|a, b| a.0.total_cmp(&b.0)),
            Order::BackToFront => triangles.sort_by(|a, b| b.0.total_cmp(&a.0)),
        }
        triangles.into_iter().for_each(|(_, triangle)| soup.push(triangle));
        soup
    }
}

fn grid(coordinate: f64) -> f32 {
    const STEPS: f64 = (1 << 20) as f64;
    ((coordinate * STEPS).round() / STEPS) as f32
}

/// Columns and rows of the mesh's cells.
pub const CELLS: usize = 120;

/// A sheet of squares cut in two, cell by cell, its inner vertices moved about: a third of them to centres of
/// pixels, so that edges run through centres.
pub fn mesh(edge: f64, seed: u64) -> Vec<[[f32; 3]; 3]> {
    let mut random = Random::new(seed);
    let mut vertices = Vec::new();
    for row in 0..=CELLS {
        for column in 0..=CELLS {
            let inner = [row, column].iter().all(|&at| at > 0 && at < CELLS);
            let reach = if inner { edge / 5.0 } else { 0.0 };
            let on_centre = random.below(3) == 0;
            let place = |at: usize, moved: f64| {
                let coordinate = 10.5 + at as f64 * edge + moved;
                if on_centre { (coordinate.floor() + 0.5) as f32 } else { grid(coordinate) }
            };
            let [x, y] = [column, row].map(|at| place(at, random.uniform(-reach, reach)));
            vertices.push([x, y, random.uniform(0.2, 0.8) as f32]);
        }
    }
    let mut triangles = Vec::new();
    for row in 0..CELLS {
        for column in 0..CELLS {
            let at = row * (CELLS + 1) + column;
            let [a, b, c, d] = [at, at + 1, at + CELLS + 1, at + CELLS + 2].map(|i| vertices[i]);
            triangles.extend([[a, b, d], [a, d, c]]);
        }
    }
    triangles
}
