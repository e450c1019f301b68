//! The three sizes.

use super::Polygon;
use crate::{lines::Sides, random::Random};

#[derive(Clone, Copy)]
pub struct Size {
    pub name: &'static str,
    pub corners: usize,
    /// How many polygons, so that all sizes have about as many corners.
    pub count: usize,
}

pub const SIZES: [Size; 3] = [
    Size { name: "triangle", corners: 3, count: 4_096 },
    Size { name: "16-gon", corners: 16, count: 1_024 },
    Size { name: "256-gon", corners: 256, count: 64 },
];

/// Star-shaped polygons around a centre in or near the window, about as large as it: most are cut by
/// one or two sides, some by none or all, a few lie outside.
pub fn polygons(size: Size, [xmin, ymin, xmax, ymax]: Sides) -> Vec<Polygon> {
    let mut random = Random::new(size.corners as u64);
    let [xmin, ymin, xmax, ymax] = [xmin, ymin, xmax, ymax].map(f64::from);
    let reach = (xmax - xmin).min(ymax - ymin);
    (0..size.count)
        .map(|_| {
            let centre = [random.uniform(xmin, xmax), random.uniform(ymin, ymax)];
            let radius = random.uniform(0.1, 0.9) * reach;
            let turn = random.uniform(0.0, 1.0);
            (0..size.corners)
                .map(|i| {
                    let angle = (i as f64 + random.uniform(0.0, 0.9)) / size.corners as f64 + turn;
                    let (sin, cos) = (angle * std::f64::consts::TAU).sin_cos();
                    let radius = radius * random.uniform(0.7, 1.0);
                    [centre[0] + radius * cos, centre[1] + radius * sin].map(|x| x as f32)
                })
                .collect()
        })
        .collect()
}
