//! Segments to be clipped to a window.

use super::{Family, Random};
use crate::clip::line::Segment;

/// The families that segments have.
pub const FAMILIES: &[Family] = &[
    Family::Ordinary,
    Family::PastACorner,
    Family::Beside,
    Family::NearlyParallel,
    Family::Huge,
    Family::Denormal,
];

const SIDES: [f32; 4] = [-3.1, -2.2, 4.7, 3.3];
const SMALL: [f32; 4] = [-3.1e-39, -2.2e-39, 4.7e-39, 3.3e-39];

/// The window that a family is for: xmin, ymin, xmax, ymax.
pub fn sides(family: Family) -> [f32; 4] {
    if family == Family::Denormal { SMALL } else { SIDES }
}

/// Segments with ends anywhere around the window of [`sides`], but for what the family is about.
pub fn segments(family: Family, count: usize) -> Vec<Segment> {
    let mut random = Random::new(family as u64);
    let sides = sides(family);
    (0..count).map(|_| segment(family, sides, &mut random)).collect()
}

fn segment(family: Family, sides: [f32; 4], random: &mut Random) -> Segment {
    let [xmin, ymin, xmax, ymax] = sides;
    let around = |random: &mut Random| {
        [[xmin, xmax], [ymin, ymax]].map(|[low, high]| {
            let (low, high) = (f64::from(low), f64::from(high));
            random.uniform(2.0 * low - high, 2.0 * high - low)
        })
    };
    let mut ends = [around(random), around(random)];
    match family {
        Family::PastACorner => {
            let corner = [random.pick(&[xmin, xmax]), random.pick(&[ymin, ymax])];
            let back = f64::from(random.uniform(0.3, 3.0));
            ends[1] = [0, 1].map(|axis| {
                let [c, p] = [corner[axis], ends[0][axis]].map(f64::from);
                (c + back * (c - p)) as f32
            });
        }
        Family::Beside => {
            for end in &mut ends {
                for (axis, coordinate) in end.iter_mut().enumerate() {
                    if random.below(2) == 0 {
                        let border = random.pick(&[sides[axis], sides[axis + 2]]);
                        *coordinate = random.beside(border);
                    }
                }
            }
        }
        Family::NearlyParallel => {
            let axis = random.below(2);
            let border = random.pick(&[sides[axis], sides[axis + 2]]);
            for end in &mut ends {
                end[axis] = random.beside(border) + random.uniform(-1e-6, 1e-6);
            }
        }
        Family::Huge => {
            ends[1] = [0, 1].map(|_| random.magnitude(20.0, 38.5));
            if random.below(2) == 0 {
                ends[0] = [0, 1].map(|axis| -ends[1][axis] * random.uniform(0.1, 0.9));
            }
        }
        _ => {}
    }
    ends
}
