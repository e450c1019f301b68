//! Polygons to be clipped to a window.

pub use super::segments::sides;
use super::{Family, Random};
use crate::clip::line::Point;

/// The families that polygons have.
pub const FAMILIES: &[Family] = &[
    Family::Ordinary,
    Family::Beside,
    Family::NearlyParallel,
    Family::Sliver,
    Family::Huge,
    Family::Denormal,
];

/// Corners of each polygon.
pub const CORNERS: usize = 12;

/// Polygons in and around the window of [`sides`].
pub fn polygons(family: Family, count: usize) -> Vec<Vec<Point>> {
    let mut random = Random::new(100 + family as u64);
    let sides = sides(family);
    (0..count).map(|_| polygon(family, sides, &mut random)).collect()
}

/// Star-shaped around a centre in the window, and about as large as it.
fn polygon(family: Family, sides: [f32; 4], random: &mut Random) -> Vec<Point> {
    let [xmin, ymin, xmax, ymax] = sides.map(f64::from);
    let centre = [random.uniform(xmin, xmax), random.uniform(ymin, ymax)].map(f64::from);
    let radius = (ymax - ymin) * f64::from(random.uniform(0.2, 0.9));
    (0..CORNERS)
        .map(|i| {
            let turn = (i as f64 + f64::from(random.uniform(0.0, 0.9))) / CORNERS as f64;
            let (sin, cos) = libm::sincos(turn * std::f64::consts::TAU);
            let r = radius * f64::from(random.uniform(0.5, 1.0));
            let mut point = [centre[0] + r * cos, centre[1] + r * sin].map(|x| x as f32);
            match family {
                // Out or in along the ray, so that it still goes once around the centre.
                Family::Beside => {
                    let axis = random.below(2);
                    let border = random.pick(&[sides[axis], sides[axis + 2]]);
                    let [free, fixed] = [1 - axis, axis].map(|axis| f64::from(point[axis]) - centre[axis]);
                    let part = (f64::from(border) - centre[axis]) / fixed;
                    if (0.5..1.5).contains(&part) {
                        point[axis] = random.beside(border);
                        point[1 - axis] = (centre[1 - axis] + part * free) as f32;
                    }
                }
                Family::NearlyParallel => {
                    let top = f64::from(sides[3]);
                    point[1] = (top + (f64::from(point[1]) - top) * 1e-6) as f32;
                }
                Family::Sliver => point[1] = centre[1] as f32 + (r * sin * 1e-6) as f32,
                Family::Huge => {
                    let size = random.magnitude(20.0, 38.0).abs();
                    point = [(cos * f64::from(size)) as f32, (sin * f64::from(size)) as f32];
                }
                _ => {}
            }
            point
        })
        .collect()
}
